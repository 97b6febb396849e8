#ifndef VITRINE_CORE_CULLING_BUFFER_LINES_THAT_PAY_H
#define VITRINE_CORE_CULLING_BUFFER_LINES_THAT_PAY_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrine
{

/**
 * How many lines an s-buffer has at most for a scene of so many parts. Finer lines hide more, and take longer; the more parts there are, the smaller they are on the screen, and the more there is to be saved
 * (docs/benchmarks.md).
 */
inline int LinesThatPay(std::size_t parts)
{
  const std::size_t some = 16384;
  return parts < some ? 270 : parts < 2 * some ? 540 : 1080;
}

/** The same of a view that is so many times as wide as it is high: wide ones have fewer, so that there are no more columns and lines than some millions. */
inline int LinesThatPay(std::size_t parts, double aspect)
{
  const double mostPlaces = 1u << 22;
  return std::min(LinesThatPay(parts), static_cast<int>(std::sqrt(mostPlaces / aspect)));
}

}

#endif
