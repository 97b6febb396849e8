#ifndef VITRINE_CORE_MEASURE_RAY_CROSSING_H
#define VITRINE_CORE_MEASURE_RAY_CROSSING_H

#include "Core/octree/Triangle.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <optional>

namespace vitrine
{

/** Where a ray passes through a triangle. */
struct RayCrossing
{
  double Distance; ///< in lengths of the ray's direction
  bool FromBehind; ///< The corners appear clockwise.
  bool IsClear;    ///< It is far enough from the triangle's edges for rounding not to matter.
};

/**
 * Tests triangles against one line without gaps: a line that passes between two triangles of a common edge with equal
 * corners meets at least one of them. It may meet both, exactly on the edge. (S. Woop, C. Benthin, I. Wald: Watertight
 * ray/triangle intersection, Journal of Computer Graphics Techniques 2(1), 2013)
 */
class RayCrossings
{
public:
  explicit RayCrossings(const Ray& ray)
    : Line(ray)
  {
    const glm::dvec3 size = glm::abs(ray.Direction);
    this->Z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    this->X = (this->Z + 1) % 3;
    this->Y = (this->Z + 2) % 3;
    this->ShearX = ray.Direction[this->X] / ray.Direction[this->Z];
    this->ShearY = ray.Direction[this->Y] / ray.Direction[this->Z];
    this->IsTurned = ray.Direction[this->Z] < 0;
  }

  /** Returns the crossing, also one before the ray's origin. A near miss is a crossing that is not clear. */
  std::optional<RayCrossing> With(const Triangle& triangle) const
  {
    double x[3];
    double y[3];
    double z[3];
    double size = 0;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 corner = triangle[i] - this->Line.Origin;
      z[i] = corner[this->Z];
      x[i] = corner[this->X] - this->ShearX * z[i];
      y[i] = corner[this->Y] - this->ShearY * z[i];
      size = std::max({ size, std::abs(x[i]), std::abs(y[i]) });
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    const double sum = u + v + w;
    const double slack = 1e-12 * size * size;
    const bool isBeside = (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
    const bool isNearEdge = std::abs(u) <= slack || std::abs(v) <= slack || std::abs(w) <= slack;
    const double distance = (u * z[0] + v * z[1] + w * z[2]) / sum / this->Line.Direction[this->Z];
    if (sum == 0 || !std::isfinite(distance))
    {
      return this->Unclear(isNearEdge && std::min({ x[0], x[1], x[2] }) <= 0 &&
        std::max({ x[0], x[1], x[2] }) >= 0 && std::min({ y[0], y[1], y[2] }) <= 0 &&
        std::max({ y[0], y[1], y[2] }) >= 0);
    }
    if (isBeside)
    {
      const bool isClearlyBeside =
        (u < -slack || v < -slack || w < -slack) && (u > slack || v > slack || w > slack);
      return this->Unclear(!isClearlyBeside);
    }
    // (u, v, w) are the areas of the corners' opposite triangles, clockwise as seen along +Z.
    return RayCrossing{ distance, (sum < 0) != this->IsTurned, !isNearEdge };
  }

private:
  static constexpr double None = std::numeric_limits<double>::quiet_NaN();

  std::optional<RayCrossing> Unclear(bool is) const
  {
    return is ? std::optional<RayCrossing>({ None, false, false }) : std::nullopt;
  }

  Ray Line;
  int X, Y, Z;
  double ShearX, ShearY;
  bool IsTurned;
};

}

#endif
