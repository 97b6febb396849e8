#ifndef VITRINE_CORE_LEVELS_MESH_SPECK_H
#define VITRINE_CORE_LEVELS_MESH_SPECK_H

#include "Core/levels/WeldedMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace vitrine
{

/**
 * A tetrahedron in place of a mesh that looks tiny. It has the area of the mesh. A convex solid hides a quarter of its
 * area in the mean of all directions (Cauchy), with two layers. So a cloud of tiny closed parts hides as much by their
 * specks, and lets as much light through, even if no part alone covers a pixel.
 */
struct MeshSpeck
{
  std::array<glm::dvec3, 4> Corners;
  glm::dvec3 Middle;
  double Bound = 0.0; ///< of the Hausdorff distance to the mesh, as that of MeshLevel
};

/** Three numbers of corners for each triangle. */
constexpr std::array<std::uint32_t, 12> CornersOfSpeck{ 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };

/** Makes the speck of a usable mesh, unless that has no area. It is right only if it was not stopped meanwhile. */
std::optional<MeshSpeck> SpeckOf(const DetailedMesh& mesh, const std::atomic<bool>& isStopped);

/** Returns the area of all triangles. */
double AreaOf(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

}

#endif
