#ifndef VITRINE_CORE_CULLING_MESH_MESH_BOXES_H
#define VITRINE_CORE_CULLING_MESH_MESH_BOXES_H

#include "Core/culling/mesh/OccluderMesh.h"
#include "Core/geometry/BoxLanes.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** Meshes with more points are tested by their boxes first. They are projected only if a box is visible. */
constexpr std::size_t FewPointsOfAMesh = 64;

/**
 * A bounding volume hierarchy of two levels over the faces of a mesh, with up to eight boxes per node. It finds large
 * meshes hidden even if their single bounding box is visible. A node halves its faces three times at the median of
 * their centres, on the axis with the largest extent of the centres. (J. Goldsmith, J. Salmon: Automatic creation of
 * object hierarchies for ray tracing, IEEE CG&A 7(5), 1987; for medians, I. Wald: On fast construction of SAH-based
 * bounding volume hierarchies, 2007)
 */
class MeshBoxes
{
public:
  static constexpr std::uint32_t NoNode = 0xffffffffu;

  /** A node of up to eight boxes. */
  struct Node
  {
    BoxLanes Boxes;
    int Count = 0;
    std::uint32_t Nodes[LaneCount]; ///< The child node of each box, or NoNode.
  };

  /** Creates a tree without boxes. */
  MeshBoxes() = default;

  explicit MeshBoxes(const OccluderMesh& mesh);

  /** Returns the origin of the boxes in model coordinates (MC). */
  const glm::dvec3& Origin() const { return this->MeshOrigin; }

  /** Returns the nodes. The first one is the root; there is none if the mesh has no faces. */
  const std::vector<Node>& Nodes() const { return this->Tree; }

  /** Returns the memory use in bytes. */
  std::size_t Bytes() const { return sizeof(*this) + this->Tree.capacity() * sizeof(Node); }

private:
  class Builder;

  glm::dvec3 MeshOrigin{ 0.0 };
  std::vector<Node> Tree;
};

}

#endif
