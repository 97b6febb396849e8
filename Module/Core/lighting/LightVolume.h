/**
 * The regions that lights reach, and their tests against balls and planes.
 */
#ifndef VITRINE_CORE_LIGHTING_LIGHT_VOLUME_H
#define VITRINE_CORE_LIGHTING_LIGHT_VOLUME_H

#include "Core/geometry/Box.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <limits>

namespace vitrine
{

/**
 * The region that a light reaches, in view coordinates (VC): the eye is at the origin and looks along -z. By default it
 * is all of space.
 */
struct LightVolume
{
  glm::vec3 Position{ 0.0f };
  /** Infinity means everywhere, 0 means nowhere. */
  float Range = std::numeric_limits<float>::infinity();
  glm::vec3 Axis{ 0.0f, 0.0f, -1.0f }; ///< axis of the cone, of length 1
  float ConeAngle = 180.0f;            ///< angle from the axis in degrees; 90 or more means no cone
};

/** A ball that contains the intersection of a ball with some half-spaces. */
struct BallPart
{
  glm::vec3 Centre;
  float Radius;
  float Square; ///< square of the radius; negative if nothing is left

  /** Intersects the ball with one more half-space, whose normal has length 1. Returns false if nothing is left. */
  bool CutBy(const glm::vec4& plane);
};

/**
 * The shape of a volume by VTK's formula. If ConeAngle < 90, VTK darkens a point unless dot(direction to the point,
 * Axis) >= cos(ConeAngle).
 *
 * A cone is slightly wider than given, since a shader's floats are inexact. A cone of 0 degrees becomes 0.1 degrees
 * wide. A position, range or angle of NaN reaches everywhere. An axis of NaN lights nothing.
 */
struct LightShape
{
  enum class Kinds
  {
    Nowhere,
    Everywhere,
    Ball,
    Cone ///< at most a half-space; the range may be infinite
  };

  explicit LightShape(const LightVolume& volume);

  /** For a cone: returns how far it extends from its position along a unit vector. */
  float SupportAlong(const glm::vec3& direction) const;

  /** For a cone: returns true if it may touch a ball. False is certain. */
  bool MayTouch(const glm::vec3& centre, float radius) const;

  /** For a ball or a cone: returns the smallest enclosing ball. It is infinite if the range is infinite. */
  BallPart Enclosing() const;

  /** For a ball or a cone: returns the smallest enclosing box. */
  Box Bounds() const;

  Kinds Kind;
  glm::vec3 Position;
  float Range; ///< slightly enlarged to allow for rounding in float tests
  glm::vec3 Axis;
  float Cosine; ///< cosine of the cone's angle
  float Sine;

private:
  bool NarrowToCone(const LightVolume& volume);
};

}

#endif
