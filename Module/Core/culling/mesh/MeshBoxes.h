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

/** Meshes of more points are not projected before they are known to show: their boxes decide. */
constexpr std::size_t FewPointsOfAMesh = 64;

/**
 * Two levels of boxes around the faces of a mesh, eight of up to eight: what tells that a mesh of many points is hidden where one
 * box around it shows. A node halves its faces three times at the median of their centres, on the axis on which those reach farthest.
 * (J. Goldsmith, J. Salmon: Automatic creation of object hierarchies for ray tracing, IEEE CG&A 7(5), 1987; at medians: I. Wald: On fast
 * construction of SAH-based bounding volume hierarchies, 2007)
 */
class MeshBoxes
{
public:
  static constexpr std::uint32_t NoNode = 0xffffffffu;

  /** Up to eight boxes, side by side. */
  struct Node
  {
    BoxLanes Boxes;
    int Count = 0;
    std::uint32_t Nodes[LaneCount]; ///< what is in each box, or NoNode
  };

  /** Boxes around nothing. */
  MeshBoxes() = default;

  explicit MeshBoxes(const OccluderMesh& mesh);

  /** Where boxes count from, in model coordinates (MC). */
  const glm::dvec3& Origin() const { return this->MeshOrigin; }

  /** The root, if there are faces, is the first one. */
  const std::vector<Node>& Nodes() const { return this->Tree; }

  /** Memory that it takes. */
  std::size_t Bytes() const { return sizeof(*this) + this->Tree.capacity() * sizeof(Node); }

private:
  class Builder;

  glm::dvec3 MeshOrigin{ 0.0 };
  std::vector<Node> Tree;
};

}

#endif
