#ifndef VITRINE_CORE_LEVELS_SURFACE_BOUND_H
#define VITRINE_CORE_LEVELS_SURFACE_BOUND_H

#include "Core/measure/PartMesh.h"

#include <glm/vec3.hpp>

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace vitrine
{

/** Triangles of a set of points, and where they are in space. */
struct Surface
{
  /** @param corners  three numbers of points for each triangle */
  Surface(const std::vector<glm::dvec3>& points, std::vector<std::uint32_t> corners)
    : Corners(std::move(corners))
    , Mesh(points, this->Corners)
  {
  }

  const std::vector<std::uint32_t> Corners;
  const PartMesh Mesh; ///< without those triangles that have two equal corners
};

/**
 * Returns an upper bound of the distances of all points of some triangles from a mesh: of the one-sided Hausdorff
 * distance. It holds by construction. The distance from a triangle, which is a convex set, is a convex function, so its
 * maximum over a polygon is at a corner. Polygons are cut until one triangle of the mesh serves all corners of each.
 *
 * @param points     those of both
 * @param from       triangles, among them segments and points
 * @param to         the mesh. Its Mesh has triangles.
 * @param tolerance  the result is at most this, or 1.05 times the distance, except where that would take too long
 * @param isStopped  ends the work; the result is no bound then
 */
double BoundOfDistance(const std::vector<glm::dvec3>& points, const Surface& from,
  const Surface& to, double tolerance, const std::atomic<bool>& isStopped);

}

#endif
