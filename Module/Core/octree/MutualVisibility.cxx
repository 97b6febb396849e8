#include "Core/octree/MutualVisibility.h"

#include "Core/octree/OctreeWalk.h"
#include "Core/octree/Shaft.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_set>
#include <vector>

namespace vitrine
{

namespace
{

// Collects the triangles that may be in the shaft.
class BlockerCollector
{
public:
  BlockerCollector(const Shaft& shaft, const BlockerOf& blocker, std::size_t most)
    : Between(shaft)
    , TriangleOf(blocker)
    , Most(most)
  {
  }

  bool Enter(const OctreeNode& node) const
  {
    return !this->AreTooMany() && this->Between.MayMeet(node.Bounds);
  }

  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    for (std::uint32_t i = 0; i < count && !this->AreTooMany(); ++i)
    {
      if (!this->Seen.insert(items[i]).second)
      {
        continue;
      }
      const std::optional<Triangle> triangle = this->TriangleOf(items[i]);
      const bool isBlocker =
        triangle && BoxOf(*triangle).IsPlaceable() && this->Between.MayMeet(triangle->data(), 3);
      if (isBlocker)
      {
        this->Triangles.push_back(*triangle);
      }
    }
  }

  bool AreTooMany() const { return this->Triangles.size() > this->Most; }

  std::vector<Triangle> Triangles;

private:
  const Shaft& Between;
  const BlockerOf& TriangleOf;
  std::size_t Most;
  std::unordered_set<std::uint32_t> Seen;
};

// A union-find structure. (R. E. Tarjan: Efficiency of a good but not linear set union algorithm, 1975)
class Groups
{
public:
  explicit Groups(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), std::size_t{ 0 });
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parents[i] != i)
    {
      i = this->Parents[i] = this->Parents[this->Parents[i]];
    }
    return i;
  }

  void Join(std::size_t i, std::size_t j) { this->Parents[this->Find(i)] = this->Find(j); }

private:
  std::vector<std::size_t> Parents;
};

using Corner = std::array<double, 3>;

struct Edge
{
  Corner From; // The lesser one of the ends.
  Corner To;
  std::size_t Triangle;

  bool IsSameAs(const Edge& other) const
  {
    return this->From == other.From && this->To == other.To;
  }
};

std::vector<Edge> SortedEdges(const std::vector<Triangle>& triangles)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3& p = triangles[i][k];
      const glm::dvec3& q = triangles[i][(k + 1) % 3];
      const Corner from{ p.x, p.y, p.z };
      const Corner to{ q.x, q.y, q.z };
      if (from != to)
      {
        edges.push_back({ std::min(from, to), std::max(from, to), i });
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b) { return a.From != b.From ? a.From < b.From : a.To < b.To; });
  return edges;
}

// Returns false only if the triangle and the box are apart by a gap larger than rounding.
bool MayTouch(const Triangle& triangle, const Box& box)
{
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.Min) + glm::dvec3(box.Max));
  const glm::dvec3 half = 0.5 * (glm::dvec3(box.Max) - glm::dvec3(box.Min));
  const Triangle relative{ triangle[0] - centre, triangle[1] - centre, triangle[2] - centre };
  const std::array<glm::dvec3, 3> edges{ relative[1] - relative[0], relative[2] - relative[1],
    relative[0] - relative[2] };
  const auto areApartAlong = [&](const glm::dvec3& axis)
  {
    const glm::dvec3 size = glm::abs(axis);
    const double reach = glm::dot(size, half);
    const double on[] = { glm::dot(axis, relative[0]), glm::dot(axis, relative[1]),
      glm::dot(axis, relative[2]) };
    const glm::dvec3 extent = glm::max(glm::abs(triangle[0]),
      glm::max(glm::abs(triangle[1]), glm::max(glm::abs(triangle[2]), glm::abs(centre))));
    const double rounding = 1e-13 * (glm::dot(size, extent) + reach);
    return *std::min_element(on, on + 3) > reach + rounding ||
      *std::max_element(on, on + 3) < -reach - rounding;
  };
  bool areApart = areApartAlong(glm::cross(edges[0], edges[1]));
  for (int axis = 0; axis < 3 && !areApart; ++axis)
  {
    glm::dvec3 direction(0);
    direction[axis] = 1;
    areApart = areApartAlong(direction);
    for (int k = 0; k < 3 && !areApart; ++k)
    {
      areApart = areApartAlong(glm::cross(direction, edges[k]));
    }
  }
  return !areApart;
}

// Returns the side of a plane through three points that a fourth point is on: -1 or 1, or 0 if rounding may decide. (J.
// R. Shewchuk: Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997, for the bound)
int SideOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& point)
{
  const glm::dvec3 ap = a - point;
  const glm::dvec3 bp = b - point;
  const glm::dvec3 cp = c - point;
  const double volume = glm::dot(ap, glm::cross(bp, cp));
  const glm::dvec3 sizes(std::abs(bp.y * cp.z) + std::abs(bp.z * cp.y),
    std::abs(bp.z * cp.x) + std::abs(bp.x * cp.z), std::abs(bp.x * cp.y) + std::abs(bp.y * cp.x));
  // The constant 1e-290 covers underflow.
  const double rounding = 1e-14 * glm::dot(glm::abs(ap), sizes) + 1e-290;
  return volume > rounding ? 1 : volume < -rounding ? -1 : 0;
}

enum class Crossings
{
  Even,
  Odd,
  Unknown
};

// Returns whether a segment crosses a triangle. The result is Unknown if the segment may touch an edge, or if an end
// may touch the triangle's plane.
Crossings CrossingOf(const glm::dvec3& from, const glm::dvec3& to, const Triangle& triangle)
{
  int least = 1;
  int most = -1;
  for (int k = 0; k < 3; ++k)
  {
    const int side = SideOf(from, to, triangle[k], triangle[(k + 1) % 3]);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  const int sideOfFrom = SideOf(triangle[0], triangle[1], triangle[2], from);
  const int sideOfTo = SideOf(triangle[0], triangle[1], triangle[2], to);
  if (least * most < 0 || sideOfFrom * sideOfTo > 0)
  {
    return Crossings::Even;
  }
  return least * most > 0 && sideOfFrom * sideOfTo < 0 ? Crossings::Odd : Crossings::Unknown;
}

Crossings CrossingsOf(
  const glm::dvec3& from, const glm::dvec3& to, const std::vector<Triangle>& surface)
{
  bool isOdd = false;
  for (const Triangle& triangle : surface)
  {
    const Crossings crossing = CrossingOf(from, to, triangle);
    if (crossing == Crossings::Unknown)
    {
      return Crossings::Unknown;
    }
    isOdd = isOdd != (crossing == Crossings::Odd);
  }
  return isOdd ? Crossings::Odd : Crossings::Even;
}

// Returns a point in the box that differs for each number.
glm::dvec3 PointIn(const Box& box, int number)
{
  const glm::dvec3 share(
    0.5 + 0.061 * number, 0.5 - 0.047 * number, 0.5 + 0.029 * ((number * 3) % 7));
  return glm::dvec3(box.Min) + share * (glm::dvec3(box.Max) - glm::dvec3(box.Min));
}

// Returns true if some segment is known to cross the surface an odd number of times.
bool IsCrossedOddly(const std::vector<Triangle>& surface, const Box& a, const Box& b)
{
  constexpr int segments = 6;
  for (int i = 0; i < segments; ++i)
  {
    const Crossings crossings = CrossingsOf(PointIn(a, i), PointIn(b, i / 2), surface);
    if (crossings != Crossings::Unknown)
    {
      return crossings == Crossings::Odd;
    }
  }
  return false;
}

// Returns the surfaces that have no border in the shaft and stay clear of both boxes.
std::vector<std::vector<Triangle>> ClosedSurfaces(
  const std::vector<Triangle>& triangles, const Shaft& shaft, const Box& a, const Box& b)
{
  Groups groups(triangles.size());
  const std::vector<Edge> edges = SortedEdges(triangles);
  // True for triangles with a border in the shaft, and later for the root of each open group.
  std::vector<bool> isOpen(triangles.size(), false);
  for (std::size_t begin = 0; begin < edges.size();)
  {
    std::size_t end = begin;
    for (; end < edges.size() && edges[end].IsSameAs(edges[begin]); ++end)
    {
      groups.Join(edges[begin].Triangle, edges[end].Triangle);
    }
    const Corner& from = edges[begin].From;
    const Corner& to = edges[begin].To;
    const glm::dvec3 ends[] = { { from[0], from[1], from[2] }, { to[0], to[1], to[2] } };
    if ((end - begin) % 2 == 1 && shaft.MayMeet(ends, 2))
    {
      isOpen[edges[begin].Triangle] = true;
    }
    begin = end;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (isOpen[i] || MayTouch(triangles[i], a) || MayTouch(triangles[i], b))
    {
      isOpen[groups.Find(i)] = true;
    }
  }
  std::map<std::size_t, std::vector<Triangle>> closed;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (!isOpen[groups.Find(i)])
    {
      closed[groups.Find(i)].push_back(triangles[i]);
    }
  }
  std::vector<std::vector<Triangle>> surfaces;
  for (auto& [group, surface] : closed)
  {
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

}

bool MaySeeEachOther(const Octree& tree, const BlockerOf& blocker, const Box& a, const Box& b,
  std::size_t mostTriangles)
{
  if (!a.IsPlaceable() || !b.IsPlaceable() || Touches(a, b))
  {
    return true;
  }
  const Shaft shaft(a, b);
  BlockerCollector collector(shaft, blocker, mostTriangles);
  WalkFrontToBack(tree, OrderAlong(glm::vec3(0.0f)), collector);
  if (collector.AreTooMany())
  {
    return true;
  }
  for (const std::vector<Triangle>& surface : ClosedSurfaces(collector.Triangles, shaft, a, b))
  {
    if (IsCrossedOddly(surface, a, b))
    {
      return false;
    }
  }
  return true;
}

}
