#ifndef VITRINE_CORE_OCTREE_RAY_H
#define VITRINE_CORE_OCTREE_RAY_H

#include "Core/geometry/Box.h"
#include "Core/geometry/Finite.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

/** The points Origin + t Direction with 0 <= t <= Furthest. A ray with a number that is not finite has no points. */
struct Ray
{
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Direction{ 0.0 };
  double Furthest = std::numeric_limits<double>::infinity();

  bool IsFinite() const
  {
    return vitrine::IsFinite(this->Origin) && vitrine::IsFinite(this->Direction);
  }
};

/** An interval of t along a ray. It is empty if Enter > Leave. */
struct RayRange
{
  double Enter = std::numeric_limits<double>::infinity();
  double Leave = -std::numeric_limits<double>::infinity();

  bool IsEmpty() const { return !(this->Enter <= this->Leave); }
};

/**
 * Returns the part of a finite ray that lies in a box. Each step is monotone in the box's sides, rounding included. So
 * a ray that meets a box also meets every box around it, and meets at least one half of the box if it is cut in two.
 */
inline RayRange RangeInBox(const Ray& ray, const Box& box)
{
  if (box.IsEmpty())
  {
    return {};
  }
  RayRange range{ 0.0, ray.Furthest };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = ray.Origin[axis];
    const double direction = ray.Direction[axis];
    if (direction == 0)
    {
      if (origin < box.Min[axis] || origin > box.Max[axis])
      {
        return {};
      }
      continue;
    }
    const double low = (box.Min[axis] - origin) / direction;
    const double high = (box.Max[axis] - origin) / direction;
    range.Enter = std::max(range.Enter, direction > 0 ? low : high);
    range.Leave = std::min(range.Leave, direction > 0 ? high : low);
  }
  return range;
}

}

#endif
