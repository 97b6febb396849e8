#ifndef VITRINE_CORE_GEOMETRY_BOX_H
#define VITRINE_CORE_GEOMETRY_BOX_H

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

/**
 * A closed axis-aligned box: the points p with Min <= p <= Max on each axis. The box is empty if a Min exceeds its Max
 * or either is NaN. VTK's uninitialised bounds (1, -1) are such a box.
 */
struct Box
{
  glm::vec3 Min{ std::numeric_limits<float>::infinity() };
  glm::vec3 Max{ -std::numeric_limits<float>::infinity() };

  /** Returns a box of all points. */
  static Box Everything()
  {
    return { glm::vec3(-std::numeric_limits<float>::infinity()),
      glm::vec3(std::numeric_limits<float>::infinity()) };
  }

  /**
   * Returns the smallest box of floats around a box of doubles. Values beyond floats become infinite, NaN stays NaN.
   */
  static Box Around(const glm::dvec3& min, const glm::dvec3& max)
  {
    Box box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Min[axis] = static_cast<float>(min[axis]);
      box.Max[axis] = static_cast<float>(max[axis]);
      if (box.Min[axis] > min[axis])
      {
        box.Min[axis] = std::nextafter(box.Min[axis], -std::numeric_limits<float>::infinity());
      }
      if (box.Max[axis] < max[axis])
      {
        box.Max[axis] = std::nextafter(box.Max[axis], std::numeric_limits<float>::infinity());
      }
    }
    return box;
  }

  bool IsEmpty() const
  {
    return !(
      this->Min.x <= this->Max.x && this->Min.y <= this->Max.y && this->Min.z <= this->Max.z);
  }

  /** Returns true if the box can be put into a cell: it is neither empty nor infinite on any side. */
  bool IsPlaceable() const
  {
    // A finite number times 0 is 0. Infinity and NaN times 0 are NaN.
    const float zero = this->Min.x * 0 + this->Min.y * 0 + this->Min.z * 0 + this->Max.x * 0 +
      this->Max.y * 0 + this->Max.z * 0;
    return zero == 0 && !this->IsEmpty();
  }

  /** Grows to contain another box. An empty box made of NaN changes nothing. */
  void Add(const Box& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Min[axis] = std::min(this->Min[axis], other.Min[axis]);
      this->Max[axis] = std::max(this->Max[axis], other.Max[axis]);
    }
  }

  /** Returns the intersection with `other`, which must not contain NaN. */
  Box ClippedTo(const Box& other) const
  {
    Box box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Min[axis] = std::max(this->Min[axis], other.Min[axis]);
      box.Max[axis] = std::min(this->Max[axis], other.Max[axis]);
    }
    return box;
  }

  bool operator==(const Box& other) const
  {
    return this->Min == other.Min && this->Max == other.Max;
  }
};
static_assert(sizeof(Box) == 24, "boxes are read by the million");

/** Returns true if the boxes share a point. */
inline bool Touches(const Box& a, const Box& b)
{
  return a.Min.x <= b.Max.x && b.Min.x <= a.Max.x && a.Min.y <= b.Max.y && b.Min.y <= a.Max.y &&
    a.Min.z <= b.Max.z && b.Min.z <= a.Max.z && !a.IsEmpty() && !b.IsEmpty();
}

/** Returns true if `inner` is not empty and lies in `outer`. */
inline bool Contains(const Box& outer, const Box& inner)
{
  return outer.Min.x <= inner.Min.x && inner.Max.x <= outer.Max.x && outer.Min.y <= inner.Min.y &&
    inner.Max.y <= outer.Max.y && outer.Min.z <= inner.Min.z && inner.Max.z <= outer.Max.z &&
    !inner.IsEmpty();
}

}

#endif
