#ifndef VITRINE_CORE_CULLING_BUFFER_LINES_THAT_PAY_H
#define VITRINE_CORE_CULLING_BUFFER_LINES_THAT_PAY_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrine
{

/**
 * Returns the number of lines an s-buffer should have at most for a scene of `parts` parts. Finer lines hide more and
 * cost more. They pay off for many parts, which are smaller on the screen (docs/lab/culling.md).
 */
inline int LinesThatPay(std::size_t parts)
{
  const std::size_t some = 16384;
  return parts < some ? 270 : parts < 2 * some ? 540 : 1080;
}

/**
 * Returns the largest number of lines for a view whose width is `aspect` times its height. Wide views get fewer lines,
 * so that columns times lines do not exceed 2^22.
 */
inline int LinesThatPay(std::size_t parts, double aspect)
{
  const double mostPlaces = 1u << 22;
  return std::min(LinesThatPay(parts), static_cast<int>(std::sqrt(mostPlaces / aspect)));
}

}

#endif
