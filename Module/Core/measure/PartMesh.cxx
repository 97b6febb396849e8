#include "Core/measure/PartMesh.h"

#include "Core/geometry/ClosedMesh.h"
#include "Core/geometry/Finite.h"
#include "Core/measure/TriangleGap.h"
#include "Core/octree/OctreeQueries.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vitrine
{

namespace
{

/** Directions that are parallel to no usual face or edge. */
constexpr std::array<std::array<double, 3>, 7> Directions{ { { 0.5377, 0.7193, 0.4395 },
  { -0.6131, 0.3947, 0.6843 }, { 0.2713, -0.8311, 0.4853 }, { 0.7591, 0.1637, -0.6301 },
  { -0.3319, -0.5471, -0.7684 }, { -0.8117, 0.5519, -0.1913 }, { 0.1259, 0.4289, 0.8945 } } };

/** Calls `visit` for each triangle whose leaf `enters` lets in, among them some twice. */
template <class Enters, class Visits>
class LeafVisitor
{
public:
  LeafVisitor(Enters enters, Visits visits)
    : MayEnter(enters)
    , Visitor(visits)
  {
  }
  bool Enter(const OctreeNode& node) const { return this->MayEnter(node.Bounds); }
  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    for (std::uint32_t i = 0; i < count; ++i)
    {
      this->Visitor(items[i]);
    }
  }

private:
  Enters MayEnter;
  Visits Visitor;
};

template <class Order, class Enters, class Visits>
void ForEachTriangle(const Octree& tree, const Order& order, Enters enters, Visits visits)
{
  for (const std::uint32_t item : tree.UnplacedItems())
  {
    visits(item);
  }
  LeafVisitor<Enters, Visits> visitor(enters, visits);
  WalkFrontToBack(tree, order, visitor);
}

std::uint32_t RootOf(std::vector<std::uint32_t>& parents, std::uint32_t i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

}

PartMesh::PartMesh(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  const std::vector<std::uint32_t> first = FirstOfEqualPoints(points);
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(points.size(), unused);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    std::array<std::uint32_t, 3> triangle;
    bool isGood = true;
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t point = corners[i + k];
      isGood = isGood && point < points.size() && IsFinite(points[point]);
      triangle[k] = isGood ? first[point] : 0;
    }
    if (!isGood || triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
      triangle[2] == triangle[0])
    {
      continue;
    }
    for (const std::uint32_t point : triangle)
    {
      if (numbers[point] == unused)
      {
        numbers[point] = static_cast<std::uint32_t>(this->Made.Points.size());
        this->Made.Points.push_back(points[point]);
      }
      this->Made.Corners.push_back(numbers[point]);
    }
    this->Made.Sources.push_back(static_cast<std::uint32_t>(i / 3));
  }
  this->Made.Points.shrink_to_fit();
  this->Made.Corners.shrink_to_fit();
  this->Made.Sources.shrink_to_fit();
}

PartMesh::PartMesh(Arrays content)
  : Made(std::move(content))
{
}

Triangle PartMesh::TriangleAt(std::uint32_t triangle) const
{
  const std::uint32_t* const corners = this->CornersOf(triangle);
  return { this->Made.Points[corners[0]], this->Made.Points[corners[1]],
    this->Made.Points[corners[2]] };
}

TriangleBoxes<double, std::uint32_t> PartMesh::Boxes() const
{
  return { this->Made.Points.empty() ? nullptr : &this->Made.Points[0].x, this->Made.Corners.data(),
    this->TriangleCount() };
}

const Octree& PartMesh::Tree() const
{
  std::call_once(this->HasTree, [this] { this->Space = Octree(this->Boxes(), 16); });
  return this->Space;
}

const PartMesh::Detail& PartMesh::Details() const
{
  std::call_once(this->HasDetails, [this] { this->Found = this->FindDetails(); });
  return this->Found;
}

PartMesh::Detail PartMesh::FindDetails() const
{
  Detail detail;
  detail.Closed = HasEvenEdges(this->Made.Corners);
  std::vector<std::uint32_t> parents(this->Made.Points.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::uint32_t i = 0; i < this->TriangleCount(); ++i)
  {
    const std::uint32_t* const corners = this->CornersOf(i);
    for (int k = 0; k < 3; ++k)
    {
      parents[RootOf(parents, corners[k])] = RootOf(parents, corners[(k + 1) % 3]);
    }
  }
  constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> pieceOfRoot(this->Made.Points.size(), unknown);
  for (std::uint32_t i = 0; i < this->TriangleCount(); ++i)
  {
    std::uint32_t& piece = pieceOfRoot[RootOf(parents, *this->CornersOf(i))];
    if (piece == unknown)
    {
      piece = static_cast<std::uint32_t>(detail.Pieces.size());
      detail.Pieces.push_back(i);
    }
  }
  for (std::uint32_t i = 0; i < this->Made.Points.size(); ++i)
  {
    detail.OfPoints.push_back(pieceOfRoot[RootOf(parents, i)]);
  }
  return detail;
}

std::vector<MeshCrossing> PartMesh::Crossings(const Ray& ray) const
{
  std::vector<MeshCrossing> found;
  if (!ray.IsFinite() || ray.Direction == glm::dvec3(0.0))
  {
    return found;
  }
  const RayCrossings line(ray);
  ForEachTriangle(
    this->Tree(), OrderAlong(ray.Direction),
    [&](const Box& box) { return !RangeInBox(ray, box).IsEmpty(); },
    [&](std::uint32_t item)
    {
      const std::optional<RayCrossing> crossing = line.With(this->TriangleAt(item));
      if (crossing && crossing->Distance >= 0 && crossing->Distance <= ray.Furthest)
      {
        found.push_back({ crossing->Distance, item, crossing->FromBehind });
      }
    });
  std::sort(found.begin(), found.end(),
    [](const MeshCrossing& a, const MeshCrossing& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Triangle < b.Triangle; });
  found.erase(
    std::unique(found.begin(), found.end(),
      [](const MeshCrossing& a, const MeshCrossing& b) { return a.Triangle == b.Triangle; }),
    found.end());
  return found;
}

std::optional<NearPoint> PartMesh::Nearest(const glm::dvec3& point, double within) const
{
  std::optional<NearPoint> best;
  double limit = within;
  ForEachTriangle(
    this->Tree(), OrderFromEye(glm::vec3(point)),
    [&](const Box& box) { return DistanceTo(box, point) <= limit; },
    [&](std::uint32_t item)
    {
      const glm::dvec3 place = NearestOnTriangle(this->TriangleAt(item), point);
      const double distance = glm::length(point - place);
      if (distance < limit || (distance == limit && (!best || item < best->Triangle)))
      {
        limit = distance;
        best = NearPoint{ distance, item, place };
      }
    });
  return best;
}

bool PartMesh::HasWithin(const glm::dvec3& point, double radius) const
{
  bool isFound = false;
  ForEachTriangle(
    this->Tree(), OrderFromEye(glm::vec3(point)),
    [&](const Box& box) { return !isFound && DistanceTo(box, point) <= radius; },
    [&](std::uint32_t item)
    {
      isFound =
        isFound || glm::length(point - NearestOnTriangle(this->TriangleAt(item), point)) <= radius;
    });
  return isFound;
}

bool PartMesh::Contains(const glm::dvec3& point) const
{
  const Box bounds = this->Tree().Bounds();
  if (this->Tree().UnplacedItems().empty() && !(DistanceTo(bounds, point) <= 0))
  {
    return false;
  }
  int votes = 0;
  std::vector<std::uint32_t> crossed;
  for (const std::array<double, 3>& direction : Directions)
  {
    const Ray ray{ point, { direction[0], direction[1], direction[2] } };
    const RayCrossings line(ray);
    bool isClear = true;
    crossed.clear();
    ForEachTriangle(
      this->Tree(), OrderAlong(ray.Direction),
      [&](const Box& box) { return !RangeInBox(ray, box).IsEmpty(); },
      [&](std::uint32_t item)
      {
        const std::optional<RayCrossing> crossing = line.With(this->TriangleAt(item));
        if (crossing && !(crossing->Distance < 0))
        {
          isClear = isClear && crossing->IsClear;
          if (crossing->Distance >= 0) // else a near miss
          {
            crossed.push_back(item);
          }
        }
      });
    std::sort(crossed.begin(), crossed.end());
    const auto end = std::unique(crossed.begin(), crossed.end());
    const bool isOdd = (end - crossed.begin()) % 2 != 0;
    if (isClear)
    {
      return isOdd;
    }
    votes += isOdd ? 1 : -1;
  }
  return votes > 0;
}

const std::vector<InnerPoint>& PartMesh::InnerPoints() const
{
  std::call_once(this->HasInnerPoints, [this] { this->Inner = this->FindInnerPoints(); });
  return this->Inner;
}

std::vector<InnerPoint> PartMesh::FindInnerPoints() const
{
  std::vector<InnerPoint> points;
  if (!this->IsClosed())
  {
    return points;
  }
  constexpr std::uint32_t most = 8;
  const std::uint32_t count = this->TriangleCount();
  for (std::uint32_t i = 0; i < std::min(most, count); ++i)
  {
    const auto item =
      static_cast<std::uint32_t>(std::uint64_t{ count } * i / std::min(most, count));
    const Triangle triangle = this->TriangleAt(item);
    const glm::dvec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    const glm::dvec3 across = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    for (const double side : { -1.0, 1.0 })
    {
      const std::vector<MeshCrossing> walls = this->Crossings({ middle, across * side });
      const auto next = std::find_if(walls.begin(), walls.end(),
        [&](const MeshCrossing& wall) { return wall.Triangle != item; });
      if (next == walls.end())
      {
        continue;
      }
      const glm::dvec3 place = middle + across * side * (next->Distance / 2);
      const std::optional<NearPoint> near = this->Nearest(place);
      if (near && near->Distance > 0 && this->Contains(place))
      {
        points.push_back({ place, near->Distance });
        break;
      }
    }
  }
  std::sort(points.begin(), points.end(),
    [](const InnerPoint& a, const InnerPoint& b) { return a.Clearance > b.Clearance; });
  return points;
}

}
