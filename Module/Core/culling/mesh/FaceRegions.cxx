#include "Core/culling/mesh/FaceRegions.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{
glm::dvec3 NormalOf(const MeshFace& face, const std::vector<glm::vec3>& points)
{
  const glm::dvec3 a(points[face[0]]);
  return glm::cross(glm::dvec3(points[face[1]]) - a, glm::dvec3(points[face[2]]) - a);
}
}

FaceRegions::FaceRegions(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
  const std::vector<MeshEdge>& edges, double leastCosine)
  : LeastCosine(leastCosine)
  , Neighbours(faces.size(), { NoFace, NoFace, NoFace })
  , RegionOf(faces.size(), NoFace)
{
  for (const MeshFace& face : faces)
  {
    this->Normals.push_back(NormalOf(face, points));
  }
  this->FindNeighbours(edges);
  for (const bool hasExtent :
    { true, false }) // Faces without area have no direction and only join existing regions.
  {
    for (std::uint32_t face = 0; face < faces.size(); ++face)
    {
      if (this->RegionOf[face] == NoFace && (this->AreaOf(face) > 0.0) == hasExtent)
      {
        this->Grow(face);
      }
    }
  }
}

void FaceRegions::FindNeighbours(const std::vector<MeshEdge>& edges)
{
  const auto add = [&](std::uint32_t face, std::uint32_t neighbour)
  {
    auto& neighbours = this->Neighbours[face];
    *std::find(neighbours.begin(), neighbours.end(), NoFace) = neighbour;
  };
  for (const MeshEdge& edge : edges)
  {
    if (edge.Right != NoFace)
    {
      add(edge.Left, edge.Right);
      add(edge.Right, edge.Left);
    }
  }
}

/** Grows the region that begins with the face `first`. */
void FaceRegions::Grow(std::uint32_t first)
{
  const auto region = static_cast<std::uint32_t>(this->Count());
  std::size_t next = this->Members.size();
  this->RegionOf[first] = region;
  this->Members.push_back(first);
  for (; next < this->Members.size(); ++next)
  {
    for (const std::uint32_t face : this->Neighbours[this->Members[next]])
    {
      if (face != NoFace && this->RegionOf[face] == NoFace && this->IsAlong(first, face))
      {
        this->RegionOf[face] = region;
        this->Members.push_back(face);
      }
    }
  }
  this->Ends.push_back(static_cast<std::uint32_t>(this->Members.size()));
}

bool FaceRegions::IsAlong(std::uint32_t a, std::uint32_t b) const
{
  return glm::dot(this->Normals[a], this->Normals[b]) >=
    this->LeastCosine * this->AreaOf(a) * this->AreaOf(b);
}

double FaceRegions::AreaOf(std::uint32_t face) const
{
  return glm::length(this->Normals[face]);
}

std::vector<std::uint32_t> FaceRegions::FacesOf(std::size_t region) const
{
  const std::uint32_t begin = region == 0 ? 0 : this->Ends[region - 1];
  return { this->Members.begin() + begin, this->Members.begin() + this->Ends[region] };
}

}
