#include "scene/Random.h"
#include "scene/hall/HallLights.h"
#include "scene/hall/HallPlan.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{

using Plan = program::HallPlan;

struct Lit
{
  double Lights = 0.0; ///< that a place notices
  double Brightness = 0.0;
};

/** What a light gives to a place that faces somewhere, by VTK's formula. */
double Arriving(const program::Light& light, const glm::dvec3& place, const glm::dvec3& normal)
{
  const glm::dvec3 from(light.Position[0], light.Position[1], light.Position[2]);
  const glm::dvec3 axis(light.Direction[0], light.Direction[1], light.Direction[2]);
  const double distance = glm::length(place - from);
  const glm::dvec3 way = (place - from) / distance;
  const double cosine = glm::dot(way, glm::normalize(axis));
  double share = light.Intensity /
    (light.Attenuation[0] + light.Attenuation[1] * distance +
      light.Attenuation[2] * distance * distance);
  if (light.ConeAngle < 90.0)
  {
    share *= cosine >= std::cos(light.ConeAngle * 3.14159265358979 / 180.0)
      ? std::pow(cosine, light.Exponent)
      : 0.0;
  }
  return share * std::max(0.0, -glm::dot(way, normal));
}

/** On average over places of the floor and of a wall. */
Lit LightOf(const std::vector<program::Light>& lights, int places)
{
  program::Random dice(5);
  Lit lit;
  for (int i = 0; i < places; ++i)
  {
    const double across = dice.Between(-Plan::NaveHalfWidth, Plan::NaveHalfWidth);
    const double along = dice.Between(-0.8, 0.8) * Plan::HalfLength;
    const bool isFloor = i % 2 == 0;
    const glm::dvec3 place = isFloor ? glm::dvec3(across, 0.0, along)
                                     : glm::dvec3(Plan::HalfWidth, 3.0 + 0.5 * across, along);
    const glm::dvec3 normal = isFloor ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(-1.0, 0.0, 0.0);
    for (const program::Light& light : lights)
    {
      const double share = Arriving(light, place, normal);
      lit.Lights += share > 2.0 / 255.0;
      lit.Brightness += share;
    }
  }
  return { lit.Lights / places, lit.Brightness / places };
}

bool IsSame(const program::Light& a, const program::Light& b)
{
  return a.Position == b.Position && a.Direction == b.Direction && a.Color == b.Color &&
    a.Intensity == b.Intensity && a.Attenuation == b.Attenuation && a.ConeAngle == b.ConeAngle &&
    a.Exponent == b.Exponent;
}
}

TEST(HallLights, AreAsManyAsAskedForAndTheSameForTheSameSeed)
{
  for (const std::size_t count : { 0, 1, 7, 64, 5000 })
  {
    const std::vector<program::Light> lights = program::MakeHallLights(count, 1);
    ASSERT_EQ(lights.size(), count);
    const std::vector<program::Light> again = program::MakeHallLights(count, 1);
    EXPECT_TRUE(std::equal(lights.begin(), lights.end(), again.begin(), IsSame));
    const std::vector<program::Light> others = program::MakeHallLights(count, 2);
    EXPECT_EQ(std::equal(lights.begin(), lights.end(), others.begin(), IsSame), count == 0);
  }
}

TEST(HallLights, AreMostlySpotLightsAndAllWithinTheHall)
{
  const std::vector<program::Light> lights = program::MakeHallLights(1000, 1);
  std::size_t spots = 0;
  for (const program::Light& light : lights)
  {
    spots += light.ConeAngle < 90.0;
    EXPECT_TRUE(light.ConeAngle == 90.0 || (light.ConeAngle >= 15.0 && light.ConeAngle <= 35.0));
    EXPECT_LT(std::abs(light.Position[0]), Plan::HalfWidth);
    EXPECT_LT(std::abs(light.Position[2]), Plan::HalfLength);
    EXPECT_TRUE(light.Position[1] > 0.0 && light.Position[1] < Plan::Top);
    EXPECT_GT(light.Attenuation[2], 0.0);
  }
  EXPECT_EQ(spots, 997);
}

TEST(HallLights, LightPlacesByAboutAsManyAndAsBrightly)
{
  for (const std::size_t count : { 64, 1024, 16384, 131072 })
  {
    SCOPED_TRACE(count);
    const Lit lit = LightOf(program::MakeHallLights(count, 1), count > 10000 ? 60 : 400);
    EXPECT_TRUE(lit.Lights > 1.0 && lit.Lights < 2.0) << lit.Lights;
    EXPECT_TRUE(lit.Brightness > 0.35 && lit.Brightness < 0.6) << lit.Brightness;
  }
}
