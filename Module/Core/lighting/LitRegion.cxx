#include "Core/lighting/LitRegion.h"

#include "Core/lighting/FloatSlack.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr double EndlessReach = std::numeric_limits<double>::infinity();

/** A ray that leaves a side at a flatter slope counts as not leaving it. */
constexpr double LeastSlope = 1e-3;

double SizeOf(const glm::dvec3& v)
{
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}
}

LitRegion::LitRegion(const Box& box, const glm::dmat4& toView)
  : IsEmpty(glm::any(glm::greaterThan(box.Min, box.Max)))
{
  double sizes = 0.0;
  bool hasSides = true;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 corner(
      i & 1 ? box.Max.x : box.Min.x, i & 2 ? box.Max.y : box.Min.y, i & 4 ? box.Max.z : box.Min.z);
    this->Corners[i] = glm::dvec3(toView * glm::dvec4(corner, 1.0));
    sizes += SizeOf(corner) + SizeOf(this->Corners[i]); // keeps NaN
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // A side's normal is orthogonal to the other two edges of the box, which may be sheared.
    const glm::dvec3 one(toView[(axis + 1) % 3]), other(toView[(axis + 2) % 3]);
    glm::dvec3 normal = glm::normalize(glm::cross(one, other));
    normal *= glm::dot(normal, glm::dvec3(toView[axis])) < 0.0 ? -1.0 : 1.0;
    this->Sides[2 * axis] = { normal, -glm::dot(normal, this->Corners[7]) };
    this->Sides[2 * axis + 1] = { -normal, glm::dot(normal, this->Corners[0]) };
    hasSides &= glm::dot(normal, normal) > 0.5; // false for NaN
  }
  this->Slack = PlaceSlack * sizes / 8.0;
  this->IsBounded = this->IsEmpty || (std::isfinite(sizes) && hasSides);
}

double LitRegion::ReachOf(const LightVolume& volume) const
{
  LightVolume endless = volume;
  endless.Range = std::numeric_limits<float>::infinity();
  const LightShape shape(endless);
  if (this->IsEmpty || shape.Kind == LightShape::Kinds::Nowhere)
  {
    return 0.0;
  }
  if (!this->IsBounded || !std::isfinite(SizeOf(shape.Position)))
  {
    return EndlessReach;
  }
  const double farthest = this->FarthestFrom(shape.Position);
  return shape.Kind == LightShape::Kinds::Cone ? std::min(farthest, this->WayOut(shape)) : farthest;
}

Box LitRegion::Bounds() const
{
  if (this->IsEmpty)
  {
    return {};
  }
  if (!this->IsBounded)
  {
    return Box::Everything();
  }
  glm::dvec3 least(this->Corners[0]), most(this->Corners[0]);
  for (const glm::dvec3& corner : this->Corners)
  {
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  return Box::Around(least - this->Slack, most + this->Slack);
}

double LitRegion::FarthestFrom(const glm::dvec3& point) const
{
  double farthest = 0.0; // squared
  for (const glm::dvec3& corner : this->Corners)
  {
    farthest = std::max(farthest, glm::dot(corner - point, corner - point));
  }
  return std::sqrt(farthest) + this->Slack;
}

/**
 * Returns the distance at which all rays of a cone have left the region. If all rays leave through one side, the
 * flattest ray leaves it last.
 */
double LitRegion::WayOut(const LightShape& cone) const
{
  double way = EndlessReach;
  for (const glm::dvec4& side : this->Sides)
  {
    const glm::dvec3 normal(side), axis(cone.Axis);
    const double along = glm::dot(axis, normal);
    const double aside = glm::length(glm::cross(axis, normal));
    const double slope = along * cone.Cosine - aside * cone.Sine; // slope of the flattest ray
    if (slope > LeastSlope)
    {
      const double inside = this->Slack - glm::dot(side, glm::dvec4(cone.Position, 1.0));
      way = std::min(way, std::max(0.0, inside) / (slope - CosineSlack));
    }
  }
  return way;
}

}
