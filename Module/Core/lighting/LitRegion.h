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
 * A box, which may stand askew, around all that is lit: all of space unless said otherwise. Beyond it lights need not reach, so that a spot light
 * that shines at a wall from near by ends there, though nothing darkens it.
 */
class LitRegion
{
public:
  LitRegion() = default;

  /**
   * @param box     empty if nothing is lit
   * @param toView  from the box's coordinates to those of lights; affine
   */
  LitRegion(const Box& box, const glm::dmat4& toView);

  /**
   * No less than the distance from a light to the farthest point of the region that it reaches, whatever range it has: 0 where there is none, infinity in all of
   * space and where numbers are not finite.
   */
  double ReachOf(const LightVolume& volume) const;

  /** Around it in the coordinates of lights, with what shaders' floats may be off. */
  Box Bounds() const;

private:
  double FarthestFrom(const glm::dvec3& point) const;
  double WayOut(const LightShape& cone) const;

  bool IsBounded = false;
  bool IsEmpty = false;
  std::array<glm::dvec4, 6>
    Sides{}; ///< normals of length 1 that point outwards; dot(side, (point, 1)) is the distance outside
  std::array<glm::dvec3, 8> Corners{};
  double Slack = 0.0; ///< how far outside rounding may put what is within
};

}

#endif
