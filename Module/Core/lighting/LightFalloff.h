#ifndef VITRINE_CORE_LIGHTING_LIGHT_FALLOFF_H
#define VITRINE_CORE_LIGHTING_LIGHT_FALLOFF_H

#include <glm/vec3.hpp>

namespace vitrine
{

/** How strong a light is, and what is left of that at a distance d, by VTK's formula 1 / (a0 + a1 d + a2 d^2). */
class LightFalloff
{
public:
  LightFalloff(const glm::dvec3& colour, double intensity, const glm::dvec3& attenuation);

  /** The greatest of what it gives to red, green and blue; taken away, if the intensity is negative. */
  double Strength() const { return this->Greatest; }

  /** What reaches a distance. */
  double At(double distance) const;

  /** The most that reaches any distance from here on; infinity where nothing is known. */
  double MostFrom(double distance) const;

  /**
   * The least distance beyond which nothing above a threshold arrives: 0 where there is none at all, infinity where it has no end, as
   * with VTK's own (1, 0, 0). The latter, too, where the threshold is 0 or a coefficient is negative, so that such a light is never cut.
   */
  double RangeAt(double threshold) const;

  /** Whether it can have a range that is not infinite. */
  bool CanBeCut() const;

  /** Whether what arrives is the same at all distances. */
  bool IsFlat() const { return this->Coefficients.y == 0.0 && this->Coefficients.z == 0.0; }

  const glm::dvec3& Attenuation() const { return this->Coefficients; }

  /** Whether VTK's shaders make NaN of it, in all that is lit: in its floats it is not finite, or the attenuation is all zeros. */
  bool IsDegenerate() const;

private:
  bool OnlyFalls() const;

  double Greatest;
  glm::dvec3 Coefficients;
};

}

#endif
