/**
 * The middle of measurements.
 */
#ifndef VITRINE_MEDIAN_H
#define VITRINE_MEDIAN_H

#include <algorithm>
#include <vector>

namespace program
{

/** The median of at least one number. */
inline double Median(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 ? numbers[middle] : 0.5 * (numbers[middle - 1] + numbers[middle]);
}

}
#endif
