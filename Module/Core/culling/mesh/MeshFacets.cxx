#include "Core/culling/mesh/MeshFacets.h"

#include <algorithm>

namespace vitrine
{

namespace
{
// Least cosine of the angle between faces of a facet, which is 0.8 degrees at most.
const double LeastCosine = 0.9999;
}

MeshFacets::MeshFacets(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
  const std::vector<MeshEdge>& edges)
{
  const FaceRegions regions(points, faces, edges, LeastCosine);
  for (std::size_t i = 0; i < regions.Count(); ++i)
  {
    const std::vector<std::uint32_t> members = regions.FacesOf(i);
    this->Largest.push_back(faces[*std::max_element(members.begin(), members.end(),
      [&](std::uint32_t a, std::uint32_t b) { return regions.AreaOf(a) < regions.AreaOf(b); })]);
    this->AddCorners(faces, members);
    this->FaceTotal += members.size();
  }
  const std::uint32_t count = static_cast<std::uint32_t>(this->Count());
  for (const MeshEdge& edge : edges)
  {
    const std::uint32_t left = regions.OfFaces()[edge.Left];
    const std::uint32_t right = edge.Right == NoFace ? count : regions.OfFaces()[edge.Right];
    if (left != right)
    {
      this->Sides.push_back({ edge.From, edge.To, left, right });
    }
  }
}

void MeshFacets::AddCorners(
  const std::vector<MeshFace>& faces, const std::vector<std::uint32_t>& taken)
{
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t face : taken)
  {
    corners.insert(corners.end(), faces[face].begin(), faces[face].end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  this->CornerList.insert(this->CornerList.end(), corners.begin(), corners.end());
  this->Ends.push_back(static_cast<std::uint32_t>(this->CornerList.size()));
}

}
