#include "Core/geometry/ClosedMesh.h"

#include "Core/geometry/Finite.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace vitrine
{

std::vector<std::uint32_t> FirstOfEqualPoints(const std::vector<glm::dvec3>& points)
{
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    const glm::dvec3& p = points[a];
    const glm::dvec3& q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : a < b;
  };
  std::vector<std::uint32_t> first(points.size());
  std::iota(first.begin(), first.end(), 0u);
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  std::copy_if(first.begin(), first.end(), std::back_inserter(order),
    [&](std::uint32_t point) { return IsFinite(points[point]); });
  std::sort(order.begin(), order.end(), isBefore);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (points[order[i]] == points[order[i - 1]])
    {
      first[order[i]] = first[order[i - 1]];
    }
  }
  return first;
}

bool HasEvenEdges(const std::vector<std::uint32_t>& corners)
{
  std::vector<std::uint64_t> edges; // the lower end in the upper half
  edges.reserve(corners.size());
  for (std::size_t triangle = 0; triangle + 2 < corners.size(); triangle += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(corners[triangle + k], corners[triangle + (k + 1) % 3]);
      edges.push_back((std::uint64_t{ low } << 32) | high);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end)
  {
    for (end = i; end < edges.size() && edges[end] == edges[i];)
    {
      ++end;
    }
    if ((end - i) % 2 != 0)
    {
      return false;
    }
  }
  return !edges.empty();
}

bool IsClosed(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  if (!std::all_of(
        points.begin(), points.end(), [](const glm::dvec3& point) { return IsFinite(point); }))
  {
    return false;
  }
  const std::vector<std::uint32_t> first = FirstOfEqualPoints(points);
  std::vector<std::uint32_t> merged;
  merged.reserve(corners.size());
  for (std::size_t triangle = 0; triangle + 2 < corners.size(); triangle += 3)
  {
    const std::uint32_t a = first[corners[triangle]];
    const std::uint32_t b = first[corners[triangle + 1]];
    const std::uint32_t c = first[corners[triangle + 2]];
    if (a != b && b != c && c != a)
    {
      merged.insert(merged.end(), { a, b, c });
    }
  }
  return HasEvenEdges(merged);
}

}
