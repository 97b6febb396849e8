#ifndef VITRINE_CORE_LIGHTING_LIGHT_VOLUME_H
#define VITRINE_CORE_LIGHTING_LIGHT_VOLUME_H

#include "Core/geometry/Box.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <limits>

namespace vitrine
{

/** What a light reaches, in view coordinates (VC): the eye is at the origin and looks along -z. It is lit all around unless said otherwise. */
struct LightVolume
{
  glm::vec3 Position{ 0.0f };
  float Range = std::numeric_limits<float>::infinity(); ///< infinity: everywhere; 0: nowhere
  glm::vec3 Axis{ 0.0f, 0.0f, -1.0f };                  ///< of a cone, unit
  float ConeAngle = 180.0f; ///< from the axis, in degrees; from 90 on all around
};

/** What is left of a ball within some planes: it lies in this ball. */
struct BallPart
{
  glm::vec3 Centre;
  float Radius;
  float Square; ///< of the radius

  /** Leaves what is within one more plane, with a normal of 1; whether there is any. */
  bool CutBy(const glm::vec4& plane);
};

/**
 * What a volume comes to by VTK's formula, which darkens a point where dot(direction to the point, Axis) >= cos(ConeAngle) does not hold, but
 * asks that only if ConeAngle < 90. Floats of a shader may be off, so a cone is a little wider than it was asked for; one of 0 degrees is a
 * tenth of a degree wide. What is no number reaches everywhere, except an axis, which then lights nothing.
 */
struct LightShape
{
  enum class Kinds
  {
    Nowhere,
    Everywhere,
    Ball,
    Cone ///< of half a sphere at most; its range may be infinite
  };

  explicit LightShape(const LightVolume& volume);

  /** Of a cone: how far it reaches from its position along a unit vector. */
  float SupportAlong(const glm::vec3& direction) const;

  /** Of a cone: whether it may touch a ball. False is certain. */
  bool MayTouch(const glm::vec3& centre, float radius) const;

  /** The smallest ball around what is reached; of a ball or a cone. Of an infinite range it is infinite. */
  BallPart Enclosing() const;

  /** The smallest box around what is reached; of a ball or a cone. */
  Box Bounds() const;

  Kinds Kind;
  glm::vec3 Position;
  float Range; ///< a little longer, for rounding in tests with floats
  glm::vec3 Axis;
  float Cosine; ///< of a cone's angle
  float Sine;

private:
  bool NarrowToCone(const LightVolume& volume);
};

}

#endif
