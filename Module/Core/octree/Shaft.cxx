#include "Core/octree/Shaft.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// Sums of three products are exact to a few ulps of the largest sum of their absolute values.
constexpr double RoundingShare = 1e-14;

glm::dvec3 CornerTowards(const Box& box, const glm::dvec3& direction)
{
  return { direction.x > 0 ? box.Max.x : box.Min.x, direction.y > 0 ? box.Max.y : box.Min.y,
    direction.z > 0 ? box.Max.z : box.Min.z };
}

double LargestOf(const glm::dvec3& normal, const glm::dvec3& point)
{
  return std::abs(normal.x * point.x) + std::abs(normal.y * point.y) + std::abs(normal.z * point.z);
}

}

Shaft::Shaft(const Box& a, const Box& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      glm::dvec3 normal(0);
      normal[axis] = sign;
      this->AddPlane(normal, a, b);
    }
    // Seen along the axis, the boxes are rectangles. A line through the same corner of both bounds them if both lie on
    // one side of it. That is so if its normal points into the corner's quadrant.
    const int across = (axis + 1) % 3;
    const int up = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner)
    {
      glm::dvec3 quadrant(0);
      quadrant[across] = corner & 1 ? 1 : -1;
      quadrant[up] = corner & 2 ? 1 : -1;
      const glm::dvec3 line = CornerTowards(b, quadrant) - CornerTowards(a, quadrant);
      glm::dvec3 normal(0);
      normal[across] = std::abs(line[up]) * quadrant[across];
      normal[up] = std::abs(line[across]) * quadrant[up];
      const bool isBound = normal[across] * line[across] + normal[up] * line[up] == 0 &&
        line[across] != 0 && line[up] != 0;
      if (isBound)
      {
        this->AddPlane(normal, a, b);
      }
    }
  }
}

void Shaft::AddPlane(const glm::dvec3& normal, const Box& a, const Box& b)
{
  const glm::dvec3 ofA = CornerTowards(a, normal);
  const glm::dvec3 ofB = CornerTowards(b, normal);
  const double rounding = RoundingShare * std::max(LargestOf(normal, ofA), LargestOf(normal, ofB));
  this->Planes.push_back(
    { normal, std::max(glm::dot(normal, ofA), glm::dot(normal, ofB)) + rounding });
}

bool Shaft::MayMeet(const Box& box) const
{
  for (const Plane& plane : this->Planes)
  {
    const glm::dvec3 lowest = CornerTowards(box, -plane.Normal);
    const double rounding = RoundingShare * LargestOf(plane.Normal, lowest);
    if (glm::dot(plane.Normal, lowest) - rounding > plane.Offset)
    {
      return false;
    }
  }
  return true;
}

bool Shaft::MayMeet(const glm::dvec3* points, std::size_t count) const
{
  for (const Plane& plane : this->Planes)
  {
    bool areAllBeyond = true;
    for (std::size_t i = 0; i < count && areAllBeyond; ++i)
    {
      const double rounding = RoundingShare * LargestOf(plane.Normal, points[i]);
      areAllBeyond = glm::dot(plane.Normal, points[i]) - rounding > plane.Offset;
    }
    if (areAllBeyond)
    {
      return false;
    }
  }
  return true;
}

}
