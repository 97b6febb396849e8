#include "Core/octree/Triangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace vitrine
{

namespace
{

bool AreFinite(const Triangle& triangle)
{
  return IsFinite(triangle[0]) && IsFinite(triangle[1]) && IsFinite(triangle[2]);
}

bool IsSeparatedAlong(const glm::dvec3& axis, const Triangle& a, const Triangle& b)
{
  const std::array<double, 3> onA{ glm::dot(axis, a[0]), glm::dot(axis, a[1]),
    glm::dot(axis, a[2]) };
  const std::array<double, 3> onB{ glm::dot(axis, b[0]), glm::dot(axis, b[1]),
    glm::dot(axis, b[2]) };
  const auto [minA, maxA] = std::minmax({ onA[0], onA[1], onA[2] });
  const auto [minB, maxB] = std::minmax({ onB[0], onB[1], onB[2] });
  return maxA < minB || maxB < minA;
}

}

Box BoxOf(const Triangle& triangle)
{
  if (!AreFinite(triangle))
  {
    const glm::vec3 unknown(std::numeric_limits<float>::quiet_NaN());
    return { unknown, unknown };
  }
  return Box::Around(glm::min(glm::min(triangle[0], triangle[1]), triangle[2]),
    glm::max(glm::max(triangle[0], triangle[1]), triangle[2]));
}

std::optional<double> RayMeets(const Ray& ray, const Triangle& triangle)
{
  const glm::dvec3 side = triangle[1] - triangle[0];
  const glm::dvec3 otherSide = triangle[2] - triangle[0];
  const glm::dvec3 toOrigin = ray.Origin - triangle[0];
  const glm::dvec3 across = glm::cross(ray.Direction, otherSide);
  const glm::dvec3 along = glm::cross(toOrigin, side);
  const double volume = glm::dot(side, across);
  const double u = glm::dot(toOrigin, across) / volume;
  const double v = glm::dot(ray.Direction, along) / volume;
  const double t = glm::dot(otherSide, along) / volume;
  const bool isMet = u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= ray.Furthest;
  return isMet && std::isfinite(t) ? std::optional<double>(t) : std::nullopt;
}

bool TrianglesMeet(const Triangle& a, const Triangle& b)
{
  if (!AreFinite(a) || !AreFinite(b))
  {
    return false;
  }
  // Relative coordinates make rounding depend on the size of the triangles and not on their place.
  Triangle nearA;
  Triangle nearB;
  for (int corner = 0; corner < 3; ++corner)
  {
    nearA[corner] = a[corner] - a[0];
    nearB[corner] = b[corner] - a[0];
  }
  const Triangle edgesA{ nearA[1] - nearA[0], nearA[2] - nearA[1], nearA[0] - nearA[2] };
  const Triangle edgesB{ nearB[1] - nearB[0], nearB[2] - nearB[1], nearB[0] - nearB[2] };
  const glm::dvec3 normalA = glm::cross(edgesA[0], edgesA[1]);
  const glm::dvec3 normalB = glm::cross(edgesB[0], edgesB[1]);
  bool isSeparated =
    IsSeparatedAlong(normalA, nearA, nearB) || IsSeparatedAlong(normalB, nearA, nearB);
  for (int i = 0; i < 3 && !isSeparated; ++i)
  {
    isSeparated = IsSeparatedAlong(glm::cross(normalA, edgesA[i]), nearA, nearB) ||
      IsSeparatedAlong(glm::cross(normalB, edgesB[i]), nearA, nearB);
    for (int j = 0; j < 3 && !isSeparated; ++j)
    {
      isSeparated = IsSeparatedAlong(glm::cross(edgesA[i], edgesB[j]), nearA, nearB);
    }
  }
  return !isSeparated;
}

}
