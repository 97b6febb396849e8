#include "Errors.h"
#include "lighting/StrewnLights.h"
#include "scene/DemoScene.h"
#include "scene/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace
{

program::Scene Strewn(std::size_t count, std::uint64_t seed)
{
  program::Scene scene = program::MakeDemoScene("demo:spheres,layers=2");
  program::StrewLights(scene, count, seed);
  return scene;
}

/** What a light gives to a place at most, whatever it faces. */
double AtMost(const program::Light& light, const std::array<double, 3>& place)
{
  double square = 0.0;
  double along = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double way = place[axis] - light.Position[axis];
    square += way * way;
    along += way * light.Direction[axis]; // unit
  }
  const bool isDark = light.ConeAngle < 90.0 &&
    along < std::cos(light.ConeAngle * 3.14159265358979 / 180.0) * std::sqrt(square);
  return isDark ? 0.0 : light.Intensity / (1.0 + light.Attenuation[2] * square);
}

/** On average, how many lights a place within the scene notices. */
double Noticed(const program::Scene& scene, int places)
{
  const std::array<double, 6> bounds = program::SceneBounds(scene);
  program::Random dice(9);
  double noticed = 0.0;
  for (int i = 0; i < places; ++i)
  {
    std::array<double, 3> place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = dice.Between(bounds[2 * axis], bounds[2 * axis + 1]);
    }
    for (const program::Light& light : scene.Lights)
    {
      noticed += AtMost(light, place) > 4.0 / 255.0;
    }
  }
  return noticed / places;
}
}

TEST(StrewnLights, AreTheSameForTheSameSeedAndHalfOfThemSpotLights)
{
  const program::Scene scene = Strewn(100, 1);
  const program::Scene again = Strewn(100, 1);
  const std::array<double, 6> bounds = program::SceneBounds(scene);
  ASSERT_EQ(scene.Lights.size(), 100);
  int spots = 0;
  for (std::size_t i = 0; i < 100; ++i)
  {
    spots += scene.Lights[i].ConeAngle < 90.0;
    EXPECT_EQ(scene.Lights[i].Position, again.Lights[i].Position);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(scene.Lights[i].Position[axis], bounds[2 * axis]);
      EXPECT_LE(scene.Lights[i].Position[axis], bounds[2 * axis + 1]);
    }
  }
  EXPECT_EQ(spots, 50);
  EXPECT_NE(Strewn(100, 2).Lights[0].Position, scene.Lights[0].Position);
}

TEST(StrewnLights, AreNoticedByAboutAsManyPlaces)
{
  for (const std::size_t count : { 64, 1024, 65536 })
  {
    SCOPED_TRACE(count);
    const double noticed = Noticed(Strewn(count, 1), count > 10000 ? 40 : 1000);
    EXPECT_TRUE(noticed > 4.0 && noticed < 12.0) << noticed;
  }
}

TEST(StrewnLights, NeedBounds)
{
  program::Scene scene = program::MakeDemoScene("demo:non-finite");
  EXPECT_THROW(program::StrewLights(scene, 8, 1), program::InputError);
}
