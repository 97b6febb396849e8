#include "Core/section/ClosedMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace vitrine
{

namespace
{

bool IsFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool IsBefore(const glm::dvec3& a, const glm::dvec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/** Returns for each point the number of its place. Equal points have the same. */
std::vector<std::uint32_t> PlacesOf(const std::vector<glm::dvec3>& points)
{
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return IsBefore(points[a], points[b]); });
  std::vector<std::uint32_t> places(points.size());
  std::uint32_t place = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place += i > 0 && IsBefore(points[order[i - 1]], points[order[i]]) ? 1 : 0;
    places[order[i]] = place;
  }
  return places;
}

/** Returns the edges of all triangles, each as its two places in ascending order. */
std::vector<std::uint64_t> EdgesOf(
  const std::vector<std::uint32_t>& places, const std::vector<std::uint32_t>& corners)
{
  std::vector<std::uint64_t> edges;
  edges.reserve(corners.size());
  for (std::size_t first = 0; first + 2 < corners.size(); first += 3)
  {
    const std::uint32_t of[3] = { places[corners[first]], places[corners[first + 1]],
      places[corners[first + 2]] };
    if (of[0] == of[1] || of[1] == of[2] || of[2] == of[0])
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(of[i], of[(i + 1) % 3]);
      edges.push_back(std::uint64_t{ ends.first } << 32 | ends.second);
    }
  }
  return edges;
}
}

bool IsClosed(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  if (corners.empty() || !std::all_of(points.begin(), points.end(), IsFinite))
  {
    return false;
  }
  std::vector<std::uint64_t> edges = EdgesOf(PlacesOf(points), corners);
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 != 0)
    {
      return false;
    }
    edge = next;
  }
  return !edges.empty();
}

}
