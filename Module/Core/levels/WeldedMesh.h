#ifndef VITRINE_CORE_LEVELS_WELDED_MESH_H
#define VITRINE_CORE_LEVELS_WELDED_MESH_H

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** A mesh that may get levels of detail, in model coordinates. */
struct DetailedMesh
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t> Corners; ///< three numbers of points for each triangle
  /** A unit vector for each point. Empty if the triangles are shaded flat. */
  std::vector<glm::vec3> Normals;
  /** A number for each point, equal for equal colours. Empty if all have one colour. */
  std::vector<std::uint32_t> Colors;
};

/** Returns true if all coordinates and normals are finite, all numbers in range, and all arrays of fitting lengths. */
bool IsUsable(const DetailedMesh& mesh);

/**
 * A mesh whose points of one place are one vertex. Points of one vertex whose normals and colours are alike are one
 * *wedge*, called by the number of one of them. Triangles on both sides of a hard edge have different wedges there.
 * Triangles with two equal vertices are left out.
 */
struct WeldedMesh
{
  std::vector<glm::dvec3> Places;      ///< for each vertex
  std::vector<std::uint32_t> Colors;   ///< for each point; empty if all have one colour
  std::vector<std::uint32_t> Vertices; ///< three for each triangle
  std::vector<std::uint32_t> Wedges;   ///< three for each triangle: numbers of points of the mesh
};

/** Normals are alike if the angle between them is at most that of this cosine: two degrees. */
constexpr float CosineOfLikeNormals = 0.99939f;

/** @param mesh  a mesh that is usable */
WeldedMesh Welded(const DetailedMesh& mesh);

}

#endif
