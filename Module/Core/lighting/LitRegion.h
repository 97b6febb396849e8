#ifndef VITRINE_CORE_LIGHTING_LIT_REGION_H
#define VITRINE_CORE_LIGHTING_LIT_REGION_H

#include "Core/geometry/Box.h"
#include "Core/lighting/LightVolume.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace vitrine
{

/**
 * An oriented, possibly sheared box around everything that is lit. By default it is all of space. Lights need not reach
 * beyond it. For example, a spot light in front of a wall ends at the wall, although it has no attenuation.
 */
class LitRegion
{
public:
  LitRegion() = default;

  /**
   * @param box     empty if nothing is lit
   * @param toView  an affine matrix from the box's coordinates to the coordinates of the lights
   */
  LitRegion(const Box& box, const glm::dmat4& toView);

  /**
   * Returns an upper bound of the distance from a light to the farthest point of the region that it reaches, regardless
   * of its range. It is 0 if there is no such point, and infinity if the region is all of space or the light is not
   * finite.
   */
  double ReachOf(const LightVolume& volume) const;

  /** Returns the bounds in the coordinates of the lights, enlarged by the rounding errors of a shader's floats. */
  Box Bounds() const;

private:
  double FarthestFrom(const glm::dvec3& point) const;
  double WayOut(const LightShape& cone) const;

  bool IsBounded = false;
  bool IsEmpty = false;
  /** Planes with outward normals of length 1: dot(side, (point, 1)) is the distance outside the side. */
  std::array<glm::dvec4, 6> Sides{};
  std::array<glm::dvec3, 8> Corners{};
  double Slack = 0.0; ///< how far outside rounding may move a point of the region
};

}

#endif
