#include "Core/measure/AssemblyIndex.h"

#include "Core/measure/PenetrationDepth.h"
#include "Core/octree/CollidingPairs.h"
#include "Core/octree/MutualVisibility.h"
#include "Core/octree/OctreeQueries.h"
#include "Core/threads/ForEachInThreads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine
{

namespace
{

constexpr std::uint32_t LeafSize = 16;

Box NarrowBox(const WideBox& box)
{
  return box.IsEmpty() ? Box() : Box::Around(box.Low, box.High);
}

/** Crossings of one place and direction, as on the edge of two triangles, become one. */
void JoinCrossings(std::vector<PartCrossing>& crossings, double slack)
{
  crossings.erase(std::unique(crossings.begin(), crossings.end(),
                    [slack](const PartCrossing& a, const PartCrossing& b)
                    { return a.IsEntering == b.IsEntering && b.Distance - a.Distance <= slack; }),
    crossings.end());
}

bool Overlaps(const Triangle& triangle, const WideBox& box)
{
  const glm::dvec3 middle = (box.Low + box.High) / 2.0;
  const glm::dvec3 half = (box.High - box.Low) / 2.0;
  const Triangle at{ triangle[0] - middle, triangle[1] - middle, triangle[2] - middle };
  const auto isApartAlong = [&](const glm::dvec3& axis)
  {
    const double a = glm::dot(axis, at[0]);
    const double b = glm::dot(axis, at[1]);
    const double c = glm::dot(axis, at[2]);
    const double reach = glm::dot(glm::abs(axis), half);
    return std::min({ a, b, c }) > reach || std::max({ a, b, c }) < -reach;
  };
  const glm::dvec3 edges[3] = { at[1] - at[0], at[2] - at[1], at[0] - at[2] };
  bool isApart = isApartAlong(glm::cross(edges[0], edges[1]));
  for (int axis = 0; axis < 3 && !isApart; ++axis)
  {
    glm::dvec3 unit(0.0);
    unit[axis] = 1;
    isApart = isApartAlong(unit) || isApartAlong(glm::cross(unit, edges[0])) ||
      isApartAlong(glm::cross(unit, edges[1])) || isApartAlong(glm::cross(unit, edges[2]));
  }
  return !isApart;
}

}

std::uint32_t AssemblyIndex::AddMesh(std::shared_ptr<const PartMesh> mesh)
{
  return this->Meshes.Keep(std::move(mesh));
}

std::uint32_t AssemblyIndex::Add(std::uint32_t mesh, const glm::dmat4& place)
{
  const std::shared_ptr<const PartMesh> shared = this->Meshes.Load(mesh);
  PlacedPart part(shared, place);
  std::shared_ptr<const PartMesh> own = part.TakeMesh();
  this->MeshNumbers.push_back(own == shared ? mesh : this->AddMesh(std::move(own)));
  this->Parts.push_back(part);
  this->Extent.Add(part.Bounds());
  this->Boxes.push_back(NarrowBox(part.Bounds()));
  return this->Count() - 1;
}

std::uint32_t AssemblyIndex::Add(std::shared_ptr<const PartMesh> mesh, const glm::dmat4& place)
{
  return this->Add(this->AddMesh(std::move(mesh)), place);
}

PlacedPart AssemblyIndex::At(std::uint32_t part) const
{
  return this->Parts[part].With(this->Meshes.Load(this->MeshNumbers[part]));
}

void AssemblyIndex::Build()
{
  this->Tree = Octree(BoxArray(this->Boxes.data(), this->Count()), LeafSize);
}

std::vector<PartCrossing> AssemblyIndex::CrossingsOf(
  std::uint32_t number, const PlacedPart& part, const Ray& ray) const
{
  std::vector<PartCrossing> crossings;
  for (const MeshCrossing& crossing : part.Crossings(ray))
  {
    crossings.push_back({ number, crossing.Distance, crossing.Triangle, !crossing.FromBehind });
  }
  const double slack = 1e-12 * (glm::length(ray.Origin) + part.Bounds().Reach());
  JoinCrossings(crossings, slack);
  if (part.IsClosed())
  {
    bool isInside = part.Contains(ray.Origin);
    for (PartCrossing& crossing : crossings)
    {
      crossing.IsEntering = !isInside;
      isInside = !isInside;
    }
  }
  return crossings;
}

std::vector<PartCrossing> AssemblyIndex::Crossings(const Ray& ray) const
{
  std::vector<PartCrossing> crossings;
  for (const std::uint32_t part :
    ItemsAlong(this->Tree, BoxArray(this->Boxes.data(), this->Count()), ray))
  {
    const std::vector<PartCrossing> of = this->CrossingsOf(part, this->At(part), ray);
    crossings.insert(crossings.end(), of.begin(), of.end());
  }
  std::stable_sort(crossings.begin(), crossings.end(),
    [](const PartCrossing& a, const PartCrossing& b) { return a.Distance < b.Distance; });
  return crossings;
}

std::vector<Wall> AssemblyIndex::Walls(const Ray& ray) const
{
  std::vector<Wall> walls;
  for (const std::uint32_t part :
    ItemsAlong(this->Tree, BoxArray(this->Boxes.data(), this->Count()), ray))
  {
    const PlacedPart placed = this->At(part);
    if (!placed.IsClosed())
    {
      continue;
    }
    std::vector<double> places;
    if (placed.Contains(ray.Origin))
    {
      places.push_back(0);
    }
    for (const PartCrossing& crossing :
      this->CrossingsOf(part, placed, { ray.Origin, ray.Direction }))
    {
      places.push_back(crossing.Distance);
    }
    for (std::size_t i = 0; places.size() % 2 == 0 && i < places.size(); i += 2)
    {
      if (places[i] <= ray.Furthest && places[i] < places[i + 1])
      {
        walls.push_back({ part, places[i], std::min(places[i + 1], ray.Furthest) });
      }
    }
  }
  std::stable_sort(
    walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.Start < b.Start; });
  return walls;
}

std::optional<NearPart> AssemblyIndex::Nearest(const glm::dvec3& point) const
{
  std::optional<NearPart> best;
  const auto distance = [&](std::uint32_t part)
  {
    const double limit = best ? best->Point.Distance : std::numeric_limits<double>::infinity();
    const std::optional<NearPoint> near = this->At(part).Nearest(point, limit);
    if (near &&
      (!best || near->Distance < best->Point.Distance ||
        (near->Distance == best->Point.Distance && part < best->Part)))
    {
      best = NearPart{ part, *near };
    }
    return near ? near->Distance : std::numeric_limits<double>::infinity();
  };
  NearestItem(this->Tree, BoxArray(this->Boxes.data(), this->Count()), point, distance);
  return best;
}

std::vector<std::uint32_t> AssemblyIndex::PartsNear(const WideBox& box) const
{
  return ItemsTouching(this->Tree, BoxArray(this->Boxes.data(), this->Count()), NarrowBox(box));
}

std::vector<std::uint32_t> AssemblyIndex::PartsTouching(const WideBox& box) const
{
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t part : this->PartsNear(box))
  {
    const std::vector<PlacedTriangle> triangles = this->At(part).TrianglesTouching(box);
    if (std::any_of(triangles.begin(), triangles.end(),
          [&](const PlacedTriangle& triangle) { return Overlaps(triangle.Corners, box); }))
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<std::uint32_t> AssemblyIndex::PartsTouching(
  const glm::dvec3& centre, double radius) const
{
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t part : this->PartsNear({ centre - radius, centre + radius }))
  {
    if (this->At(part).HasWithin(centre, radius))
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<std::uint32_t> AssemblyIndex::PartsWithin(const WideBox& box) const
{
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t part : this->PartsNear(box))
  {
    const WideBox& bounds = this->Parts[part].Bounds();
    if (box.Contains(bounds.Low) && box.Contains(bounds.High))
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<std::uint32_t> AssemblyIndex::PartsWithin(const glm::dvec3& centre, double radius) const
{
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t part : this->PartsNear({ centre - radius, centre + radius }))
  {
    const PlacedPart placed = this->At(part);
    const std::vector<glm::dvec3>& points = placed.Mesh().Points();
    if (std::all_of(points.begin(), points.end(),
          [&](const glm::dvec3& point)
          { return glm::length(placed.ToWorld(point) - centre) <= radius; }))
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::optional<Gap> AssemblyIndex::Distance(std::uint32_t first, std::uint32_t second) const
{
  const std::optional<SurfaceGap> gap =
    FindSurfaceGap(this->At(first), this->At(second), std::numeric_limits<double>::infinity());
  return gap ? std::optional<Gap>(gap->Least) : std::nullopt;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> AssemblyIndex::NearBoxes(double within) const
{
  std::vector<Box> grown;
  for (const PlacedPart& part : this->Parts)
  {
    grown.push_back(NarrowBox(part.Bounds().GrownBy(within / 2)));
  }
  const BoxArray boxes(grown.data(), this->Count());
  return CollidingPairs(Octree(boxes, LeafSize), boxes,
    [&](std::uint32_t a, std::uint32_t b)
    { return DistanceBetween(this->Parts[a].Bounds(), this->Parts[b].Bounds()) <= within; });
}

std::optional<Clash> AssemblyIndex::Compare(
  std::uint32_t first, std::uint32_t second, const ClashLimits& limits) const
{
  const PlacedPart a = this->At(first);
  const PlacedPart b = this->At(second);
  const double within = std::max(limits.Clearance, limits.Tolerance);
  const std::optional<SurfaceGap> gap = FindSurfaceGap(a, b, within);
  Clash clash{ first, second, ClashKinds::Near, Enclosures::None, 0, 0, {} };
  const bool doMeet = gap && !gap->Meetings.empty();
  std::optional<DeepPoint> deep;
  if (doMeet)
  {
    deep = FindDepthOfMeeting(a, b, gap->Meetings, limits.Tolerance);
  }
  else
  {
    const PiecesInside aInside = FindPiecesInside(a, b);
    const PiecesInside bInside = FindPiecesInside(b, a);
    clash.Enclosure = aInside.All ? Enclosures::FirstInSecond
      : bInside.All               ? Enclosures::SecondInFirst
                                  : Enclosures::None;
    deep = FindDepthOfApart(a, b, aInside, bInside, limits.Tolerance);
  }
  if (deep)
  {
    clash.Kind = ClashKinds::Interfering;
    clash.Depth = deep->Depth;
    clash.Place = deep->Place;
    clash.Distance =
      doMeet ? 0 : FindSurfaceGap(a, b, std::numeric_limits<double>::infinity())->Least.Distance;
    return clash;
  }
  if (!gap)
  {
    return std::nullopt;
  }
  clash.Kind = gap->Least.Distance <= limits.Tolerance ? ClashKinds::Touching : ClashKinds::Near;
  clash.Distance = gap->Least.Distance;
  clash.Place = (gap->Least.OnFirst + gap->Least.OnSecond) / 2.0;
  return clash;
}

std::vector<Clash> AssemblyIndex::Clashes(
  const ClashLimits& limits, const std::function<bool(double)>& goesOn) const
{
  const auto pairs = this->NearBoxes(std::max(limits.Clearance, limits.Tolerance));
  std::vector<std::optional<Clash>> found(pairs.size());
  const std::size_t chunk = 1024;
  for (std::size_t begin = 0; begin < pairs.size(); begin += chunk)
  {
    if (!goesOn(static_cast<double>(begin) / static_cast<double>(pairs.size())))
    {
      break;
    }
    ForEachInThreads(std::min(chunk, pairs.size() - begin),
      [&](std::size_t i)
      {
        const auto [first, second] = pairs[begin + i];
        found[begin + i] = this->Compare(first, second, limits);
      });
  }
  std::vector<Clash> clashes;
  for (const std::optional<Clash>& clash : found)
  {
    if (clash)
    {
      clashes.push_back(*clash);
    }
  }
  return clashes;
}

bool AssemblyIndex::MaySee(
  std::uint32_t first, std::uint32_t second, const std::function<bool(std::uint32_t)>& blocks) const
{
  WideBox between = this->Parts[first].Bounds();
  between.Add(this->Parts[second].Bounds());
  std::vector<Triangle> triangles;
  std::vector<Box> boxes;
  for (const std::uint32_t part : this->PartsNear(between))
  {
    if (part == first || part == second || !blocks(part))
    {
      continue;
    }
    for (const PlacedTriangle& triangle : this->At(part).TrianglesTouching(between))
    {
      triangles.push_back(triangle.Corners);
      boxes.push_back(BoxOf(triangle.Corners));
    }
  }
  const BoxArray array(boxes.data(), static_cast<std::uint32_t>(boxes.size()));
  return MaySeeEachOther(
    Octree(array), [&](std::uint32_t item) { return std::optional<Triangle>(triangles[item]); },
    this->Boxes[first], this->Boxes[second], triangles.size() + 1);
}

}
