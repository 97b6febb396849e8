#ifndef VITRINE_CORE_LEVELS_SURFACE_BOUND_H
#define VITRINE_CORE_LEVELS_SURFACE_BOUND_H

#include "Core/measure/PartMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Returns an upper bound of the distances of all points of some triangles from a mesh: of the one-sided Hausdorff
 * distance. It holds by construction. The distance from a triangle, which is a convex set, is a convex function, so its
 * maximum over a polygon is at a corner. Polygons are cut until one triangle of the mesh serves all corners of each.
 *
 * @param points, corners  three numbers of points for each triangle; a triangle may be a segment or a point
 * @param to         the mesh. It has triangles.
 * @param tolerance  the result is at most this, or 1.05 times the distance, except where that would take too long
 */
double BoundOfDistance(const std::vector<glm::dvec3>& points,
  const std::vector<std::uint32_t>& corners, const PartMesh& to, double tolerance);

}

#endif
