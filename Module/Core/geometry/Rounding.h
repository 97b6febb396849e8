/** Integer division that rounds up. */
#ifndef VITRINE_CORE_GEOMETRY_ROUNDING_H
#define VITRINE_CORE_GEOMETRY_ROUNDING_H

namespace vitrine
{

/** Returns the least number of parts of size `by` that hold `count`. `by` must be positive. */
template <class Integer>
constexpr Integer DividedUp(Integer count, Integer by)
{
  return (count + by - 1) / by;
}

/** Returns the least multiple of `granule` that is not below `count`. */
template <class Integer>
constexpr Integer RoundedUp(Integer count, Integer granule)
{
  return DividedUp(count, granule) * granule;
}

}
#endif
