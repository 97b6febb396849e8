#ifndef VITRINE_CORE_LEVELS_MESH_SPECK_H
#define VITRINE_CORE_LEVELS_MESH_SPECK_H

#include "Core/levels/WeldedMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine
{

/**
 * A tetrahedron in place of a mesh that looks tiny. It has the area of the mesh. A convex solid hides a quarter of its
 * area in the mean of all directions (Cauchy), with two layers. So a cloud of tiny closed parts hides as much by their
 * specks, and lets as much light through, even if no part alone covers a pixel.
 *
 * In place of a *sheet*, an open mesh that is nearly flat, it is a rectangle of that area, with one layer.
 */
struct MeshSpeck
{
  std::array<glm::dvec3, 4> Corners;
  glm::dvec3 Middle;
  bool IsSheet = false;
  double Bound = 0.0; ///< of the Hausdorff distance to the mesh, as that of MeshLevel
};

/** Returns three numbers of corners for each triangle. */
const std::vector<std::uint32_t>& TrianglesOf(const MeshSpeck& speck);

/** Makes the speck of a usable mesh, unless that has no area. It is right only if it was not stopped meanwhile. */
std::optional<MeshSpeck> SpeckOf(const DetailedMesh& mesh, const std::atomic<bool>& isStopped);

/** Returns the area of all triangles. */
double AreaOf(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

}

#endif
