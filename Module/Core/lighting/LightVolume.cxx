// The test of a cone against a ball is from B. Wronski: Cull that cone! Improved cone/spotlight visibility tests for
// tiled and clustered lighting, 2017. The distance from the axis is taken from a cross product, which stays exact in
// narrow cones.

#include "Core/lighting/LightVolume.h"

#include "Core/lighting/FloatSlack.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/** The squares of larger numbers overflow a float. */
constexpr float Farthest = 1e18f;

float SumOf(const glm::vec3& v)
{
  return v.x + v.y + v.z;
}
}

bool BallPart::CutBy(const glm::vec4& plane)
{
  const float distance = glm::dot(glm::vec3(plane), this->Centre) + plane.w;
  if (distance >= 0.0f)
  {
    return true;
  }
  // Move the centre to the nearest point of the plane. The rest of the ball lies within a smaller ball around that
  // point.
  this->Centre -= distance * glm::vec3(plane);
  this->Square -= distance * distance;
  this->Radius = std::sqrt(std::max(0.0f, this->Square));
  return this->Square >= 0.0f;
}

LightShape::LightShape(const LightVolume& volume)
  : Kind(Kinds::Everywhere)
  , Position(volume.Position)
  , Range(volume.Range)
  , Axis(0.0f)
  , Cosine(-1.0f)
  , Sine(0.0f)
{
  const float away = SumOf(glm::abs(this->Position));
  const bool isPlaced = away < Farthest;
  if (volume.Range <= 0.0f)
  {
    this->Kind = Kinds::Nowhere;
    return;
  }
  this->Range += RangeSlack * volume.Range + PlaceSlack * away;
  const bool isFinite = this->Range < Farthest;
  if (!isFinite || !isPlaced)
  {
    this->Range = std::numeric_limits<float>::infinity();
  }
  const bool isCone = this->NarrowToCone(volume);
  if (this->Kind != Kinds::Nowhere && isPlaced)
  {
    this->Kind = isCone ? Kinds::Cone : isFinite ? Kinds::Ball : Kinds::Everywhere;
  }
}

/**
 * Narrows the shape to the volume's cone. Returns false if the volume is not a cone, or is a cone that lights nothing.
 */
bool LightShape::NarrowToCone(const LightVolume& volume)
{
  if (!(volume.ConeAngle < 90.0f) || !std::isfinite(volume.ConeAngle))
  {
    return false;
  }
  const glm::dvec3 axis(volume.Axis);
  const double length = glm::length(axis);
  const double least = std::cos(glm::radians(static_cast<double>(volume.ConeAngle))) - CosineSlack;
  const bool isSomewhere = length > 0.0 ? least / length <= 1.0 : length == 0.0 && least <= 0.0;
  if (!isSomewhere)
  {
    this->Kind = Kinds::Nowhere;
    return false;
  }
  if (least <= 0.0 || !std::isfinite(length)) // half of space or more
  {
    return false;
  }
  const double cosine = least / length;
  this->Axis = glm::vec3(axis / length);
  this->Cosine = static_cast<float>(cosine);
  this->Sine = static_cast<float>(std::sqrt(1.0 - cosine * cosine));
  return true;
}

float LightShape::SupportAlong(const glm::vec3& direction) const
{
  const float along = glm::dot(direction, this->Axis);
  const float aside = glm::length(glm::cross(direction, this->Axis));
  if (along >= this->Cosine) // the direction lies in the cone
  {
    return this->Range;
  }
  const float share = along * this->Cosine + aside * this->Sine + PlaceSlack;
  return share > 0.0f ? this->Range * std::min(share, 1.0f) : 0.0f;
}

bool LightShape::MayTouch(const glm::vec3& centre, float radius) const
{
  const glm::vec3 away = centre - this->Position;
  const float along = glm::dot(away, this->Axis);
  const float aside = glm::length(glm::cross(away, this->Axis));
  const float slack = PlaceSlack * (SumOf(glm::abs(centre)) + SumOf(glm::abs(this->Position)));
  const float reach = radius + slack;
  const bool isBeside = this->Cosine * aside - this->Sine * along > reach;
  const bool isBefore = along < -reach;
  const bool isBeyond = along > this->Range + reach;
  return !(isBeside || isBefore || isBeyond);
}

BallPart LightShape::Enclosing() const
{
  if (this->Kind != Kinds::Cone || this->Range > Farthest)
  {
    return { this->Position, this->Range, this->Range * this->Range };
  }
  // In a cone of more than 45 degrees, the smallest ball is bounded by the rim. In a narrower one it touches the apex,
  // too.
  const bool isWide = this->Cosine < this->Sine;
  const float along = this->Range * (isWide ? this->Cosine : 0.5f / this->Cosine);
  const float radius = this->Range * (isWide ? this->Sine : 0.5f / this->Cosine);
  const float grown = radius * (1.0f + RangeSlack) + PlaceSlack * SumOf(glm::abs(this->Position));
  return { this->Position + along * this->Axis, grown, grown * grown };
}

Box LightShape::Bounds() const
{
  Box box{ this->Position - this->Range, this->Position + this->Range };
  if (this->Kind == Kinds::Cone)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::vec3 direction(0.0f);
      direction[axis] = 1.0f;
      const float slack = PlaceSlack * std::abs(this->Position[axis]);
      box.Max[axis] = this->Position[axis] + this->SupportAlong(direction) + slack;
      box.Min[axis] = this->Position[axis] - this->SupportAlong(-direction) - slack;
    }
  }
  return box;
}

}
