#ifndef VITRINE_CORE_LIGHTING_LIGHT_FALLOFF_H
#define VITRINE_CORE_LIGHTING_LIGHT_FALLOFF_H

#include <glm/vec3.hpp>

namespace vitrine
{

/** The strength of a light as a function of the distance d, by VTK's formula 1 / (a0 + a1 d + a2 d^2). */
class LightFalloff
{
public:
  LightFalloff(const glm::dvec3& colour, double intensity, const glm::dvec3& attenuation);

  /** Returns the greatest absolute contribution to red, green or blue at an attenuation of 1. */
  double Strength() const { return this->Greatest; }

  /** Returns the strength at a distance. */
  double At(double distance) const;

  /** Returns an upper bound of the strength at a distance or beyond. It is infinite if no bound is known. */
  double MostFrom(double distance) const;

  /**
   * Returns the smallest distance beyond which the strength does not exceed a threshold.
   * - It is 0 if the strength exceeds the threshold nowhere.
   * - It is infinity if the strength has no limit in space, as with VTK's default attenuation (1, 0, 0).
   * - It is infinity as well if the threshold is 0 or a coefficient is negative, so such a light is never cut.
   */
  double RangeAt(double threshold) const;

  /** Returns true if the range can be finite. */
  bool CanBeCut() const;

  /** Returns true if the strength is the same at all distances. */
  bool IsFlat() const { return this->Coefficients.y == 0.0 && this->Coefficients.z == 0.0; }

  const glm::dvec3& Attenuation() const { return this->Coefficients; }

  /**
   * Returns true if VTK's shaders would turn everything that is lit into NaN. This occurs if the light is not finite in
   * 32-bit floats, or if all attenuation coefficients are 0.
   */
  bool IsDegenerate() const;

private:
  bool OnlyFalls() const;

  double Greatest;
  glm::dvec3 Coefficients;
};

}

#endif
