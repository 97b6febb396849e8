#include "Core/culling/mesh/FewFacets.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

// A point may lie outside of a plane by this share of its distance from a point in the plane.
const float MostOutside = 1e-3f;

/**
 * Returns true if the mesh is small enough for FewFacets. Each facet must have two faces fewer than corners, so at most
 * two faces.
 */
bool AreFew(const MeshFacets& facets, std::size_t points)
{
  std::uint32_t begin = 0, most = 0;
  for (const std::uint32_t end : facets.CornerEnds())
  {
    most = std::max(most, end - begin);
    begin = end;
  }
  return points <= LaneCount && facets.Count() <= LaneCount &&
    facets.Edges().size() <= FewFacets::MostEdges && most <= FewFacets::CornerCount &&
    facets.FaceCount() + 2 * facets.Count() == facets.Corners().size();
}

/** Returns the outward normal of a face. Its length is twice the area. */
glm::vec3 OutwardsOf(const MeshFace& face, const std::vector<glm::vec3>& points)
{
  return glm::cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
}

/** Returns true if no point lies outside of a plane by more than the tolerance. */
bool AreWithin(
  const std::vector<glm::vec3>& points, const glm::vec3& place, const glm::vec3& outwards)
{
  return std::all_of(points.begin(), points.end(),
    [&](const glm::vec3& point)
    {
      const glm::vec3 away = point - place;
      return glm::dot(outwards, away) <= MostOutside * glm::length(outwards) * glm::length(away);
    });
}

/**
 * Returns true for a closed convex mesh and for a single convex facet. Other meshes cover less than their facets
 * suggest.
 */
bool IsConvex(const MeshFacets& facets, const std::vector<glm::vec3>& points)
{
  const bool isOne = facets.Count() == 1;
  const bool isClosed = std::all_of(facets.Edges().begin(), facets.Edges().end(),
    [&](const MeshEdge& edge) { return edge.Right < facets.Count(); });
  const auto isWithinFacet = [&](const MeshFace& face)
  { return AreWithin(points, points[face[0]], OutwardsOf(face, points)); };
  const auto isWithinEdge = [&](const MeshEdge& edge)
  {
    const glm::vec3 along = points[edge.To] - points[edge.From];
    return AreWithin(points, points[edge.From],
      glm::cross(along, OutwardsOf(facets.LargestFaces()[edge.Left], points)));
  };
  return isOne ? std::all_of(facets.Edges().begin(), facets.Edges().end(), isWithinEdge)
               : isClosed &&
      std::all_of(facets.LargestFaces().begin(), facets.LargestFaces().end(), isWithinFacet);
}

/** Returns a corner of the facet that its largest face lacks, or one of that face's corners if there is none. */
std::uint32_t LastCorner(
  const MeshFace& face, const std::uint32_t* corners, const std::uint32_t* end)
{
  const std::uint32_t* const last = std::find_if(corners, end,
    [&](std::uint32_t corner)
    { return std::find(face.begin(), face.end(), corner) == face.end(); });
  return last == end ? face[0] : *last;
}

/**
 * Returns the other face of a facet of two faces: the last corner with the side of the largest face that it lies
 * beyond. Returns the largest face if there is no other.
 */
MeshFace OtherFace(const MeshFace& face, std::uint32_t last, const std::vector<glm::vec3>& points)
{
  const glm::vec3 outwards = OutwardsOf(face, points);
  for (int i = 0; i < 3; ++i)
  {
    const std::uint32_t from = face[i], to = face[(i + 1) % 3];
    const MeshFace beyond{ to, from, last };
    if (last != from && last != to && glm::dot(OutwardsOf(beyond, points), outwards) > 0.0f)
    {
      return beyond;
    }
  }
  return face;
}

std::int32_t BitOf(std::uint32_t facet, std::size_t count)
{
  return facet < count ? std::int32_t{ 1 } << facet : 0;
}
}

std::unique_ptr<const FewFacets> FewFacets::Of(
  const MeshFacets& facets, const std::vector<glm::vec3>& points)
{
  if (!AreFew(facets, points.size()) || !IsConvex(facets, points))
  {
    return nullptr;
  }
  auto few = std::make_unique<FewFacets>();
  const std::uint32_t* corners = facets.Corners().data();
  for (std::size_t i = 0; i < facets.Count(); ++i)
  {
    const MeshFace& face = facets.LargestFaces()[i];
    const std::uint32_t* const end = facets.Corners().data() + facets.CornerEnds()[i];
    const std::uint32_t all[CornerCount] = { face[0], face[1], face[2],
      LastCorner(face, corners, end) };
    const MeshFace other = OtherFace(face, all[CornerCount - 1], points);
    for (int corner = 0; corner < 3; ++corner)
    {
      few->Others[corner][i] = static_cast<std::int32_t>(other[corner]);
    }
    for (int corner = 0; corner < CornerCount; ++corner)
    {
      few->Corners[corner][i] = static_cast<std::int32_t>(all[corner]);
    }
    corners = end;
  }
  for (std::size_t i = 0; i < facets.Edges().size(); ++i)
  {
    const MeshEdge& edge = facets.Edges()[i];
    few->From[i] = static_cast<std::int32_t>(edge.From);
    few->To[i] = static_cast<std::int32_t>(edge.To);
    few->Left[i] = BitOf(edge.Left, facets.Count());
    few->Right[i] = BitOf(edge.Right, facets.Count());
  }
  return few;
}

}
