#ifndef VITRINE_CORE_CULLING_MESH_FEW_FACETS_H
#define VITRINE_CORE_CULLING_MESH_FEW_FACETS_H

#include "Core/culling/mesh/MeshFacets.h"
#include "Core/geometry/Lanes.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/** One number per facet. */
using FacetDepths = std::array<float, LaneCount>;

/**
 * The facets of a small convex mesh, such as a box, a wedge or a plate, prepared for vector registers. One register
 * holds a number for each point or each facet. Two registers hold a number for each edge.
 */
struct FewFacets
{
  static constexpr int MostEdges = 2 * LaneCount;
  static constexpr int CornerCount = 4;
  /** Largest depth uncertainty of a facet's plane. A facet with more uses the depth of its farthest corner instead. */
  static constexpr float MostUnsteady = 0x1p-12f;

  /**
   * Returns null if the mesh has too many points, facets or edges, or a facet with too many corners or faces. Also
   * returns null if the mesh is neither closed and convex nor a single convex facet.
   */
  static std::unique_ptr<const FewFacets> Of(
    const MeshFacets& facets, const std::vector<glm::vec3>& points);

  /**
   * Corners of each facet: those of its largest face and a fourth one, which may repeat one of them. Padding facets
   * have no extent.
   */
  std::int32_t Corners[CornerCount][LaneCount] = {};

  /** Corners of each facet's second face. If there is none, the largest face is repeated. */
  std::int32_t Others[3][LaneCount] = {};

  MeshFace Largest(int facet) const { return FaceOf(this->Corners, facet); }
  MeshFace Other(int facet) const { return FaceOf(this->Others, facet); }

  /**
   * Points of each edge, in the direction of the facet on its left, and bit masks of the facets on both sides. Padding
   * edges have no facets.
   */
  std::int32_t From[MostEdges] = {};
  std::int32_t To[MostEdges] = {};
  std::int32_t Left[MostEdges] = {};
  std::int32_t Right[MostEdges] = {};

private:
  static MeshFace FaceOf(const std::int32_t (*corners)[LaneCount], int facet)
  {
    const auto corner = [&](int i) { return static_cast<std::uint32_t>(corners[i][facet]); };
    return { corner(0), corner(1), corner(2) };
  }
};

}

#endif
