#ifndef VITRINE_TESTING_CORE_BRUTE_CLASH_H
#define VITRINE_TESTING_CORE_BRUTE_CLASH_H

#include "Core/measure/AssemblyIndex.h"
#include "Core/measure/PenetrationDepth.h"
#include "Core/measure/TriangleGap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

/** What AssemblyIndex::Compare() finds, without any tree, box or order: each triangle with each. */
namespace brute_clash
{

using namespace vitrine;

class Surface
{
public:
  explicit Surface(const PlacedPart& part)
    : Part(part)
  {
    for (std::uint32_t i = 0; i < part.Mesh().TriangleCount(); ++i)
    {
      this->Triangles.push_back(part.TriangleAt(i));
    }
  }

  /** The distance of a point, or any number that is at most `enough` if the distance is. */
  double DistanceTo(const glm::dvec3& point, double enough = 0) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Triangles.size() && least > enough; ++i)
    {
      least = std::min(least, glm::length(point - NearestOnTriangle(this->Triangles[i], point)));
    }
    return least;
  }

  /** Most of five rays, by a test of triangles that product code does not use for this. */
  bool Contains(const glm::dvec3& point) const
  {
    const glm::dvec3 directions[5] = { { 0.31, 0.52, 0.79 }, { -0.71, 0.23, 0.41 },
      { 0.13, -0.87, 0.37 }, { 0.61, 0.47, -0.53 }, { -0.43, -0.59, -0.67 } };
    int votes = 0;
    for (const glm::dvec3& direction : directions)
    {
      int crossings = 0;
      for (const Triangle& triangle : this->Triangles)
      {
        crossings += RayMeets({ point, direction }, triangle).has_value();
      }
      votes += crossings % 2 == 1 ? 1 : -1;
    }
    return votes > 0;
  }

  PlacedPart Part;
  std::vector<Triangle> Triangles;
};

struct BruteMeeting
{
  std::uint32_t First, Second;
  glm::dvec3 Place;
};

inline double DepthOfWitnesses(const Surface& part, const Surface& solid,
  const std::map<std::uint32_t, std::vector<glm::dvec3>>& places)
{
  std::vector<glm::dvec3> witnesses;
  for (const glm::dvec3& point : part.Part.Mesh().Points())
  {
    witnesses.push_back(part.Part.ToWorld(point));
  }
  for (const auto& [item, middles] : places)
  {
    const Triangle& triangle = part.Triangles[item];
    witnesses.push_back((triangle[0] + triangle[1] + triangle[2]) / 3.0);
    for (int k = 0; k < 3; ++k)
    {
      witnesses.push_back((triangle[k] + triangle[(k + 1) % 3]) / 2.0);
    }
    for (std::size_t a = 0; a < middles.size(); ++a)
    {
      witnesses.push_back(middles[a]);
      for (const std::size_t b : NextMeetings(a, middles.size()))
      {
        witnesses.push_back((middles[a] + middles[b]) / 2.0);
      }
    }
  }
  double depth = 0;
  for (const glm::dvec3& witness : witnesses)
  {
    if (!solid.Part.Bounds().Contains(witness))
    {
      continue;
    }
    const double distance = solid.DistanceTo(witness, depth);
    if (distance > depth && solid.Contains(witness))
    {
      depth = distance;
    }
  }
  return depth;
}

inline double DepthOfInnerPoints(const Surface& part, const Surface& solid)
{
  double depth = 0;
  for (const InnerPoint& inner : part.Part.Mesh().InnerPoints())
  {
    const glm::dvec3 place = part.Part.ToWorld(inner.Place);
    if (solid.Contains(place))
    {
      depth = std::max(depth, std::min(part.DistanceTo(place), solid.DistanceTo(place)));
    }
  }
  return depth;
}

inline std::optional<Clash> Compare(
  const PlacedPart& first, const PlacedPart& second, const ClashLimits& limits)
{
  const Surface a(first);
  const Surface b(second);
  if (a.Triangles.empty() || b.Triangles.empty())
  {
    return std::nullopt;
  }
  double distance = std::numeric_limits<double>::max();
  double through = 0;
  std::map<std::uint32_t, std::vector<glm::dvec3>> ofFirst, ofSecond;
  for (std::uint32_t i = 0; i < a.Triangles.size(); ++i)
  {
    for (std::uint32_t j = 0; j < b.Triangles.size(); ++j)
    {
      const std::optional<Gap> gap =
        GapWithin(a.Triangles[i], b.Triangles[j], distance, RoundingOf(first, second));
      distance = gap ? gap->Distance : distance;
      if (gap && gap->Distance == 0)
      {
        ofFirst[i].push_back(gap->OnFirst);
        ofSecond[j].push_back(gap->OnFirst);
        through = std::max(through, ReachThrough(a.Triangles[i], b.Triangles[j]));
      }
    }
  }
  double depth = !first.IsClosed() && !second.IsClosed() ? through : 0;
  if (second.IsClosed())
  {
    depth = std::max(depth, DepthOfWitnesses(a, b, ofFirst));
  }
  if (first.IsClosed())
  {
    depth = std::max(depth, DepthOfWitnesses(b, a, ofSecond));
  }
  if (first.IsClosed() && second.IsClosed())
  {
    depth = std::max({ depth, DepthOfInnerPoints(a, b), DepthOfInnerPoints(b, a) });
  }
  Clash clash{ 0, 0, ClashKinds::Near, Enclosures::None, 0, distance, {} };
  if (depth > limits.Tolerance)
  {
    clash.Kind = ClashKinds::Interfering;
    clash.Depth = depth;
  }
  else if (distance <= limits.Tolerance)
  {
    clash.Kind = ClashKinds::Touching;
  }
  else if (distance > limits.Clearance)
  {
    return std::nullopt;
  }
  return clash;
}

}

#endif
