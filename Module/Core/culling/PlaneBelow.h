#ifndef VITRINE_CORE_CULLING_PLANE_BELOW_H
#define VITRINE_CORE_CULLING_PLANE_BELOW_H

#include "Core/culling/MeshProjection.h"
#include "Core/culling/SlantedDepth.h"

#include <cstdint>

namespace vitrine
{

/** Points on the screen, of which some count. There are as many of each kind as fill lanes. */
struct CountedPoints
{
  const float* Columns;
  const float* Lines;
  const float* Depths;
  const std::int32_t* Counts; ///< -1 for those that count, which are finite, and 0 for others
  std::size_t Room;           ///< how many there are
};

/**
 * A plane that lies behind all faces between some corners, and near them: the one that fits the corners best by least squares, moved
 * back until none is behind it. What is between corners of which none is behind a plane is not behind it either.
 * @param corners  of which at least one counts
 * @param origin   one that counts
 * @param margin   what a device may move them by
 */
SlantedDepth PlaneBelow(
  const CountedPoints& corners, const ScreenPoint& origin, const ScreenMargin& margin);

}

#endif
