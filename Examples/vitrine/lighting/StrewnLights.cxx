#include "lighting/StrewnLights.h"

#include "Errors.h"
#include "scene/Random.h"

#include <cmath>

namespace program
{

namespace
{
// Of the scene's diagonal, how far one light reaches; of N, the cube root of N times less.
const double ReachOfOne = 0.9;

double Diagonal(const Scene& scene, const std::array<double, 6>& bounds)
{
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (!std::isfinite(diagonal) || bounds[0] > bounds[1])
  {
    throw InputError(scene.Name, "lights cannot be strewn through it: it has no bounds");
  }
  return diagonal > 0.0 ? diagonal : 1.0;
}

std::array<double, 3> PlaceWithin(const std::array<double, 6>& bounds, Random& dice)
{
  std::array<double, 3> place;
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = dice.Between(bounds[2 * axis], bounds[2 * axis + 1]);
  }
  return place;
}

/** Uniform on the sphere. */
std::array<double, 3> AnyDirection(Random& dice)
{
  const double z = dice.Between(-1.0, 1.0);
  const double angle = dice.Between(0.0, 2.0 * 3.14159265358979323846);
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

Light StrewnLight(const std::array<double, 6>& bounds, double reach, bool isSpot, Random& dice)
{
  Light light;
  light.Position = PlaceWithin(bounds, dice);
  for (double& channel : light.Color)
  {
    channel = dice.Between(0.4, 1.0);
  }
  light.Intensity = 1.0;
  double core = 0.12 * reach; // at that distance it has half its intensity
  if (isSpot)
  {
    light.Direction = AnyDirection(dice);
    light.ConeAngle = dice.Between(20.0, 40.0);
    light.Exponent = dice.Between(1.0, 8.0);
    core *= 2.0; // it lights less around it, and reaches farther
  }
  light.Attenuation = { 1.0, 0.0, 1.0 / (core * core) };
  return light;
}
}

void StrewLights(Scene& scene, std::size_t count, std::uint64_t seed)
{
  const std::array<double, 6> bounds = SceneBounds(scene);
  const double reach = ReachOfOne * Diagonal(scene, bounds) / std::cbrt(static_cast<double>(count));
  Random dice(seed);
  scene.Lights.clear();
  scene.Lights.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    scene.Lights.push_back(StrewnLight(bounds, reach, i % 2 == 0, dice));
  }
}

}
