/**
 * Division that rounds up.
 */
#ifndef VITRINE_CORE_GEOMETRY_ROUNDING_H
#define VITRINE_CORE_GEOMETRY_ROUNDING_H

namespace vitrine
{

/** The least number of parts of size `by` that hold `count`; both are of the same kind of integer, `by` above 0. */
template <class Integer>
constexpr Integer DividedUp(Integer count, Integer by)
{
  return (count + by - 1) / by;
}

/** The least multiple of `granule` that is not below `count`. */
template <class Integer>
constexpr Integer RoundedUp(Integer count, Integer granule)
{
  return DividedUp(count, granule) * granule;
}

}
#endif
