// How far lights reach before they have left all that is lit: in closed form, and at points of boxes that stand askew.

#include "Core/lighting/LitRegion.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace
{

using light_scenes::LightReaches;
using light_scenes::RandomDirection;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::LightVolume;
using vitrine::LitRegion;

const Box Room{ { -20, 0, -30 }, { 20, 10, 30 } };

LightVolume SpotAt(const glm::vec3& position, const glm::vec3& axis, float angle)
{
  LightVolume spot;
  spot.Position = position;
  spot.Axis = glm::normalize(axis);
  spot.ConeAngle = angle;
  return spot;
}
}

TEST(LitRegion, IsAllOfSpaceUnlessSaidOtherwise)
{
  EXPECT_EQ(LitRegion().ReachOf(SpotAt({ 1, 2, 3 }, { 0, -1, 0 }, 20)), Infinity);
  EXPECT_EQ(LitRegion().ReachOf(LightVolume{}), Infinity);
}

TEST(LitRegion, HasNothingToBeReachedIfItIsEmpty)
{
  const LitRegion region(Box{}, glm::dmat4(1.0));
  EXPECT_EQ(region.ReachOf(LightVolume{}), 0.0);
  EXPECT_EQ(region.ReachOf(SpotAt({ 1, 2, 3 }, { 0, -1, 0 }, 20)), 0.0);
}

TEST(LitRegion, EndsALampAtTheFarthestCorner)
{
  const LitRegion region(Room, glm::dmat4(1.0));
  LightVolume lamp;
  lamp.Position = { 20, 0, 0 };
  EXPECT_NEAR(region.ReachOf(lamp), std::sqrt(1600.0 + 100.0 + 900.0), 1e-3);
}

TEST(LitRegion, EndsASpotLightWhereItsFlattestRayLeaves)
{
  const LitRegion region(Room, glm::dmat4(1.0));
  // 2 above the floor: the rim of the cone is 2 / cos(60) away.
  EXPECT_NEAR(region.ReachOf(SpotAt({ 0, 2, 0 }, { 0, -1, 0 }, 60)), 4.0, 4e-3);
  const double slope = std::cos(glm::radians(45.0 + 20.0));
  EXPECT_NEAR(region.ReachOf(SpotAt({ 0, 2, 0 }, { 1, -1, 0 }, 20)), 2.0 / slope, 4e-3);
}

TEST(LitRegion, DoesNotEndASpotLightThatAimsAlongASide)
{
  const LitRegion region(Room, glm::dmat4(1.0));
  // Some of its rays go up, so that the far wall, not the floor, ends it: at 25 / cos(30).
  EXPECT_NEAR(region.ReachOf(SpotAt({ 0, 2, -5 }, { 0, 0, -1 }, 30)),
    25.0 / std::cos(glm::radians(30.0)), 0.1);
}

TEST(LitRegion, IsNotReachedBySpotLightsThatShineAwayFromIt)
{
  const LitRegion region(Room, glm::dmat4(1.0));
  EXPECT_EQ(region.ReachOf(SpotAt({ 0, -1, 0 }, { 0, -1, 0 }, 30)), 0.0);
  EXPECT_GT(region.ReachOf(SpotAt({ 0, -1, 0 }, { 0, 1, 0 }, 30)), 10.0);
}

TEST(LitRegion, EndsNoLightBeforeAPointThatItReaches)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const double size = std::pow(10.0, UniformIn(random, -3, 4));
    glm::dmat4 toView =
      glm::rotate(glm::dmat4(1.0), UniformIn(random, 0, 7), glm::dvec3(RandomDirection(random)));
    toView[3] = glm::dvec4(size * UniformIn(random, -2, 2), size * UniformIn(random, -2, 2), 0, 1);
    toView[1] *= seed % 2 ? 1.0 : -0.3; // mirrored, and flatter
    const glm::dvec3 half(size * UniformIn(random, 0, 1), size * UniformIn(random, 0.1, 1), size);
    const LitRegion region({ glm::vec3(-half), glm::vec3(half) }, toView);
    for (int i = 0; i < 200; ++i)
    {
      const auto within = [&](double share)
      {
        const glm::dvec3 at(UniformIn(random, -share, share), UniformIn(random, -share, share),
          UniformIn(random, -share, share));
        return glm::dvec3(toView * glm::dvec4(at * half, 1.0));
      };
      const LightVolume light = SpotAt(glm::vec3(within(1.5)), RandomDirection(random),
        static_cast<float>(UniformIn(random, 0.5, 130)));
      const double reach = region.ReachOf(light);
      for (int j = 0; j < 50; ++j)
      {
        const glm::dvec3 point = within(1.0);
        ASSERT_TRUE(
          !LightReaches(light, point) || glm::distance(point, glm::dvec3(light.Position)) <= reach);
      }
    }
  }
}

TEST(LitRegion, KnowsNoEndWhereNumbersAreNotFinite)
{
  const LightVolume spot = SpotAt({ 0, 2, 0 }, { 0, -1, 0 }, 20);
  for (const float bad : { static_cast<float>(NotANumber), static_cast<float>(Infinity) })
  {
    const Box box{ { -1, -1, -1 }, { 1, bad, 1 } };
    EXPECT_EQ(LitRegion(box, glm::dmat4(1.0)).ReachOf(spot), Infinity);
    glm::dmat4 toView(1.0);
    toView[1][1] = bad;
    EXPECT_EQ(LitRegion(Room, toView).ReachOf(spot), Infinity);
    LightVolume far = spot;
    far.Position.x = bad;
    EXPECT_EQ(LitRegion(Room, glm::dmat4(1.0)).ReachOf(far), Infinity);
  }
  EXPECT_EQ(LitRegion(Room, glm::dmat4(0.0)).ReachOf(spot), Infinity);
}

TEST(LitRegion, MayBeFlatOrAPoint)
{
  const LitRegion floor({ { -5, 0, -5 }, { 5, 0, 5 } }, glm::dmat4(1.0));
  EXPECT_NEAR(floor.ReachOf(SpotAt({ 0, 2, 0 }, { 0, -1, 0 }, 60)), 4.0, 4e-3);
  const LitRegion point({ { 3, 4, 0 }, { 3, 4, 0 } }, glm::dmat4(1.0));
  EXPECT_NEAR(point.ReachOf(LightVolume{}), 5.0, 1e-3);
}
