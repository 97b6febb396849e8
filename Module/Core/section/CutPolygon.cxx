#include "Core/section/CutPolygon.h"

#include <glm/common.hpp>

#include <cstddef>

namespace vitrine
{

namespace
{

using Polygon = std::vector<glm::dvec3>;

/** Returns the part of a convex polygon in which `sign` * (coordinate of an axis) <= `limit`. */
Polygon ClipBy(const Polygon& polygon, int axis, double sign, double limit)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& a = polygon[i];
    const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
    const double beyondA = sign * a[axis] - limit;
    const double beyondB = sign * b[axis] - limit;
    if (beyondA <= 0.0)
    {
      kept.push_back(a);
    }
    if ((beyondA < 0.0 && beyondB > 0.0) || (beyondA > 0.0 && beyondB < 0.0))
    {
      kept.push_back(glm::mix(a, b, beyondA / (beyondA - beyondB)));
    }
  }
  return kept;
}
}

PlaneAxes AxesOf(const CutPlane& plane, const glm::dvec3& up)
{
  const glm::dvec3 normal = glm::normalize(plane.Normal);
  const glm::dvec3 size = glm::abs(normal);
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  glm::dvec3 other(0.0);
  other[least] = 1.0;
  const glm::dvec3 level = glm::cross(up, normal);
  const bool isLevel = glm::length(level) < 0.1 * glm::length(up);
  const glm::dvec3 u = glm::normalize(isLevel ? glm::cross(other, normal) : level);
  return { u, glm::cross(normal, u) };
}

Polygon CutPolygon(const CutPlane& plane, const glm::dvec3& min, const glm::dvec3& max)
{
  const glm::dvec3 middle = 0.5 * (min + max);
  const double reach = glm::length(max - min);
  const double length = glm::length(plane.Normal);
  const glm::dvec3 foot = middle - plane.Normal * (plane.At(middle) / (length * length));
  const auto [u, v] = AxesOf(plane, { 0.0, 0.0, 1.0 });
  Polygon polygon = { foot - reach * (u + v), foot + reach * (u - v), foot + reach * (u + v),
    foot + reach * (v - u) };
  for (int axis = 0; axis < 3; ++axis)
  {
    polygon = ClipBy(ClipBy(polygon, axis, 1.0, max[axis]), axis, -1.0, -min[axis]);
  }
  return polygon.size() < 3 ? Polygon() : polygon;
}

}
