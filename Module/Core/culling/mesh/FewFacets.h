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

/** A number for each of few facets. */
using FacetDepths = std::array<float, LaneCount>;

/**
 * The facets of a convex mesh of few points, such as a box, a wedge or a plate, as they are looked at together: its points fit into the lanes of one register, and
 * so do a number for each of its facets, and in two of them one for each of its edges.
 */
struct FewFacets
{
  static constexpr int MostEdges = 2 * LaneCount;
  static constexpr int CornerCount = 4;
  static constexpr float MostUnsteady =
    0x1p-12f; ///< of depth: of facets of which it is known less well only the farthest corner counts

  /** Null of a mesh of more, or with a facet of more corners or faces, and of one that is neither closed and convex nor one convex facet. */
  static std::unique_ptr<const FewFacets> Of(
    const MeshFacets& facets, const std::vector<glm::vec3>& points);

  /** Points of each facet: those of its largest face, and one more, which may be one of those. Behind the last facet there are some without extent. */
  std::int32_t Corners[CornerCount][LaneCount] = {};

  /** Points of each facet's other face, if it has one; else of the largest again. */
  std::int32_t Others[3][LaneCount] = {};

  MeshFace Largest(int facet) const { return FaceOf(this->Corners, facet); }
  MeshFace Other(int facet) const { return FaceOf(this->Others, facet); }

  /** Of each edge the points, as the facet on its left goes around, and what lies on both sides: the bits of facets. Behind the last one are some that have none. */
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
