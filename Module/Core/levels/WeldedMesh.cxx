#include "Core/levels/WeldedMesh.h"

#include "Core/geometry/ClosedMesh.h"
#include "Core/geometry/Finite.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace vitrine
{

namespace
{

constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

bool AreAlike(const DetailedMesh& mesh, std::uint32_t a, std::uint32_t b)
{
  return (mesh.Colors.empty() || mesh.Colors[a] == mesh.Colors[b]) &&
    (mesh.Normals.empty() || glm::dot(mesh.Normals[a], mesh.Normals[b]) >= CosineOfLikeNormals);
}

/** Returns for each point the first point of its place that is like it. */
std::vector<std::uint32_t> FindWedges(
  const DetailedMesh& mesh, const std::vector<std::uint32_t>& first)
{
  std::vector<std::uint32_t> wedges(first.size());
  std::vector<std::uint32_t> next(first.size(), None); // the next wedge of the same place
  for (std::uint32_t i = 0; i < first.size(); ++i)
  {
    std::uint32_t wedge = first[i];
    while (!AreAlike(mesh, i, wedge) && next[wedge] != None)
    {
      wedge = next[wedge];
    }
    if (wedge != i && !AreAlike(mesh, i, wedge))
    {
      next[wedge] = i;
      wedge = i;
    }
    wedges[i] = wedge;
  }
  return wedges;
}

}

bool IsUsable(const DetailedMesh& mesh)
{
  const std::size_t count = mesh.Points.size();
  const auto isFinite = [](const auto& place) { return IsFinite(glm::dvec3(place)); };
  return count < None && mesh.Corners.size() % 3 == 0 &&
    (mesh.Normals.empty() || mesh.Normals.size() == count) &&
    (mesh.Colors.empty() || mesh.Colors.size() == count) &&
    std::all_of(mesh.Corners.begin(), mesh.Corners.end(),
      [&](std::uint32_t corner) { return corner < count; }) &&
    std::all_of(mesh.Points.begin(), mesh.Points.end(), isFinite) &&
    std::all_of(mesh.Normals.begin(), mesh.Normals.end(), isFinite);
}

WeldedMesh Welded(const DetailedMesh& mesh)
{
  WeldedMesh welded;
  welded.Colors = mesh.Colors;
  const std::vector<std::uint32_t> first = FirstOfEqualPoints(mesh.Points);
  const std::vector<std::uint32_t> wedges = FindWedges(mesh, first);
  std::vector<std::uint32_t> vertices(mesh.Points.size(), None);
  for (std::size_t i = 0; i < mesh.Corners.size(); i += 3)
  {
    const std::uint32_t* const corners = &mesh.Corners[i];
    const std::uint32_t a = first[corners[0]];
    const std::uint32_t b = first[corners[1]];
    const std::uint32_t c = first[corners[2]];
    if (a == b || b == c || c == a)
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      std::uint32_t& vertex = vertices[first[corners[k]]];
      if (vertex == None)
      {
        vertex = static_cast<std::uint32_t>(welded.Places.size());
        welded.Places.push_back(mesh.Points[corners[k]]);
      }
      welded.Vertices.push_back(vertex);
      welded.Wedges.push_back(wedges[corners[k]]);
    }
  }
  return welded;
}

}
