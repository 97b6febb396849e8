#ifndef VITRINE_CORE_CULLING_PLANE_BELOW_H
#define VITRINE_CORE_CULLING_PLANE_BELOW_H

#include "Core/culling/MeshProjection.h"
#include "Core/culling/SlantedDepth.h"

#include <vector>

namespace vitrine
{

/**
 * A plane that lies behind all faces between some corners, and near them: the one that fits the corners best by least squares, moved
 * back until none is behind it. What is between corners of which none is behind a plane is not behind it either.
 * @param corners  at least one
 * @param margin   what a device may move them by
 */
SlantedDepth PlaneBelow(const std::vector<ScreenPoint>& corners, const ScreenMargin& margin);

}

#endif
