#include "Core/lighting/LightFalloff.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr double Unbounded = std::numeric_limits<double>::infinity();

bool IsFloat(double value)
{
  return std::isfinite(static_cast<float>(value));
}
}

LightFalloff::LightFalloff(
  const glm::dvec3& colour, double intensity, const glm::dvec3& attenuation)
  : Greatest(0.0)
  , Coefficients(attenuation)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    const double strength = std::abs(colour[channel] * intensity);
    this->Greatest = strength <= this->Greatest ? this->Greatest : strength; // keeps NaN
    if (std::isnan(strength))
    {
      return;
    }
  }
}

double LightFalloff::At(double distance) const
{
  return this->Greatest /
    (this->Coefficients.x + distance * (this->Coefficients.y + distance * this->Coefficients.z));
}

double LightFalloff::MostFrom(double distance) const
{
  if (this->Greatest == 0.0)
  {
    return 0.0;
  }
  const double most = this->OnlyFalls() ? this->At(distance) : Unbounded;
  return most >= 0.0 ? most : Unbounded;
}

/** Returns true if the strength never increases with the distance. */
bool LightFalloff::OnlyFalls() const
{
  const glm::dvec3& a = this->Coefficients;
  return a.x >= 0.0 && a.y >= 0.0 && a.z >= 0.0 && a.x < Unbounded && a.y < Unbounded &&
    a.z < Unbounded;
}

double LightFalloff::RangeAt(double threshold) const
{
  if (this->Greatest == 0.0)
  {
    return 0.0;
  }
  if (!this->CanBeCut() || !(threshold > 0.0))
  {
    return Unbounded;
  }
  const glm::dvec3& a = this->Coefficients;
  const double missing = this->Greatest / threshold - a.x; // missing part of the denominator
  if (missing <= 0.0)
  {
    return 0.0;
  }
  double range = 2.0 * missing / (a.y + std::sqrt(a.y * a.y + 4.0 * a.z * missing));
  // Rounding may make the range slightly too short. A square may also overflow.
  for (int step = 0; step < 8 && this->At(range) > threshold; ++step)
  {
    range *= 1.0 + 1e-15;
  }
  return this->At(range) <= threshold ? range : Unbounded;
}

bool LightFalloff::CanBeCut() const
{
  return this->OnlyFalls() && std::isfinite(this->Greatest);
}

bool LightFalloff::IsDegenerate() const
{
  const glm::vec3 a(this->Coefficients);
  const bool isFinite =
    IsFloat(this->Greatest) && std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
  return !isFinite || (a.x == 0.0f && a.y == 0.0f && a.z == 0.0f);
}

}
