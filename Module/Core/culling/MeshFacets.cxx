#include "Core/culling/MeshFacets.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

// Of the angle between faces of a facet: 0.8 degrees.
const double LeastCosine = 0.9999;

glm::dvec3 NormalOf(const MeshFace& face, const std::vector<glm::vec3>& points)
{
  const glm::dvec3 a(points[face[0]]);
  return glm::cross(glm::dvec3(points[face[1]]) - a, glm::dvec3(points[face[2]]) - a);
}

/** Collects facets, one after the other, from their first faces. */
class FacetFinder
{
public:
  FacetFinder(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
    const std::vector<MeshEdge>& edges)
    : Neighbours(faces.size(), { MeshFacets::NoFace, MeshFacets::NoFace, MeshFacets::NoFace })
    , FacetOf(faces.size(), MeshFacets::NoFace)
  {
    for (const MeshFace& face : faces)
    {
      this->Normals.push_back(NormalOf(face, points));
    }
    for (const MeshEdge& edge : edges)
    {
      if (edge.Right != MeshFacets::NoFace)
      {
        this->AddNeighbour(edge.Left, edge.Right);
        this->AddNeighbour(edge.Right, edge.Left);
      }
    }
  }

  bool IsTaken(std::uint32_t face) const { return this->FacetOf[face] != MeshFacets::NoFace; }
  const std::vector<std::uint32_t>& Facets() const { return this->FacetOf; }
  double AreaOf(std::uint32_t face) const { return glm::length(this->Normals[face]); }

  /** All faces of the facet that begins with one. Faces without extent belong to whatever they are joined with. */
  const std::vector<std::uint32_t>& Take(std::uint32_t first, std::uint32_t facet)
  {
    this->Taken.assign(1, first);
    this->FacetOf[first] = facet;
    for (std::size_t i = 0; i < this->Taken.size(); ++i)
    {
      for (const std::uint32_t face : this->Neighbours[this->Taken[i]])
      {
        if (face != MeshFacets::NoFace && !this->IsTaken(face) && this->IsAlong(first, face))
        {
          this->FacetOf[face] = facet;
          this->Taken.push_back(face);
        }
      }
    }
    return this->Taken;
  }

private:
  void AddNeighbour(std::uint32_t face, std::uint32_t neighbour)
  {
    auto& neighbours = this->Neighbours[face];
    *std::find(neighbours.begin(), neighbours.end(), MeshFacets::NoFace) = neighbour;
  }

  bool IsAlong(std::uint32_t a, std::uint32_t b) const
  {
    return glm::dot(this->Normals[a], this->Normals[b]) >=
      LeastCosine * this->AreaOf(a) * this->AreaOf(b);
  }

  std::vector<std::array<std::uint32_t, 3>> Neighbours;
  std::vector<std::uint32_t> FacetOf;
  std::vector<glm::dvec3> Normals;
  std::vector<std::uint32_t> Taken;
};
}

MeshFacets::MeshFacets(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
  const std::vector<MeshEdge>& edges)
{
  FacetFinder finder(points, faces, edges);
  for (const bool hasExtent : { true, false }) // a face without any looks into no direction
  {
    for (std::uint32_t face = 0; face < faces.size(); ++face)
    {
      if (!finder.IsTaken(face) && (finder.AreaOf(face) > 0.0) == hasExtent)
      {
        const auto& taken = finder.Take(face, static_cast<std::uint32_t>(this->Count()));
        this->Largest.push_back(faces[*std::max_element(taken.begin(), taken.end(),
          [&](std::uint32_t a, std::uint32_t b) { return finder.AreaOf(a) < finder.AreaOf(b); })]);
        this->AddCorners(faces, taken);
      }
    }
  }
  const std::uint32_t count = static_cast<std::uint32_t>(this->Count());
  for (const MeshEdge& edge : edges)
  {
    const std::uint32_t left = finder.Facets()[edge.Left];
    const std::uint32_t right = edge.Right == NoFace ? count : finder.Facets()[edge.Right];
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

std::size_t MeshFacets::Bytes() const
{
  return this->Largest.capacity() * sizeof(MeshFace) +
    (this->CornerList.capacity() + this->Ends.capacity()) * sizeof(std::uint32_t) +
    this->Sides.capacity() * sizeof(MeshEdge);
}

}
