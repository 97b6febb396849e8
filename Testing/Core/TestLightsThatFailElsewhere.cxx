// Cases that other implementations of clustered lighting got wrong.

#include "LightJudge.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::AllLitViews;
using light_scenes::BallAt;
using light_scenes::ConeAt;
using light_scenes::ExpectLit;
using light_scenes::ExpectNoneMissing;
using light_scenes::GridFor;
using light_scenes::ListsOf;
using light_scenes::LitView;
using light_scenes::RandomLights;
using light_scenes::SquareView;
using light_scenes::UniformIn;
using vitrine::ClusterGrid;
using vitrine::LightLists;
using vitrine::LightVolume;

}

TEST(LightsThatFailElsewhere, CameraInsideALight)
{
  for (const LitView& view : AllLitViews())
  {
    const float size = static_cast<float>(view.Far);
    ExpectLit(view,
      { BallAt({ 0, 0, 0 }, 0.5f * size), BallAt({ 0.1f, 0.1f, 0.1f }, 2 * size),
        ConeAt({ 0, 0, 0 }, 2 * size, { 0, 0, -1 }, 60), BallAt({ 0, 0, -size }, 3 * size) });
  }
}

TEST(LightsThatFailElsewhere, LightsBehindTheCamera)
{
  ExpectLit(SquareView(),
    { BallAt({ 0, 0, 5 }, 20), BallAt({ 3, -8, 20 }, 40), ConeAt({ 0, 0, 5 }, 60, { 0, 0, -1 }, 40),
      ConeAt({ -30, 0, 10 }, 60, { 1, 0, -1 }, 60) });
  const ClusterGrid grid = GridFor(SquareView());
  EXPECT_TRUE(ListsOf(grid, { BallAt({ 0, 0, 5 }, 4.9f) }).Indices.empty());
}

TEST(LightsThatFailElsewhere, LightsThatCrossTheNearPlane)
{
  ExpectLit(SquareView(),
    { BallAt({ 0, 0, -1 }, 0.5f), BallAt({ 0.9f, 0.9f, -0.9f }, 0.5f),
      BallAt({ 0, 0, -0.5f }, 0.8f), ConeAt({ 0, 0, -0.2f }, 5, { 0, 0.2f, -1 }, 10) });
}

TEST(LightsThatFailElsewhere, SpotsOfAllAngles)
{
  std::mt19937 random(20);
  for (const float angle :
    { 0.1f, 0.5f, 1.0f, 45.0f, 59.0f, 60.0f, 61.0f, 89.0f, 89.99f, 90.0f, 120.0f, 179.0f })
  {
    SCOPED_TRACE(angle);
    const LitView view = SquareView();
    std::vector<LightVolume> lights = RandomLights(view, 60, random);
    for (LightVolume& light : lights)
    {
      light.ConeAngle = angle;
    }
    ExpectLit(view, lights, 3);
  }
}

TEST(LightsThatFailElsewhere, SpotsFarAwayThatAreNarrow)
{
  std::vector<LightVolume> lights;
  for (int i = 0; i < 50; ++i)
  {
    lights.push_back(
      ConeAt({ 2.0f * i - 50, 900, -600 }, Infinity, { 0.01f * i, -900, 540 }, 0.1f));
  }
  ExpectLit(SquareView(), lights, 1);
}

TEST(LightsThatFailElsewhere, LargeSpotsAndANearFarPlane)
{
  const LitView view = SquareView(1, 5);
  ExpectLit(view,
    { ConeAt({ 0, 0, -3 }, 500, { 0, 1, 0 }, 40), ConeAt({ 0, 0, -50 }, 500, { 0, 0, 1 }, 30),
      ConeAt({ 100, 0, -3 }, 500, { -1, 0, 0 }, 2), ConeAt({ 0, 0, 400 }, 500, { 0, 0, -1 }, 3) });
}

TEST(LightsThatFailElsewhere, ParallelProjectionWithNearBehindTheEye)
{
  const LitView view{ "near behind", glm::ortho(-8.0, 8.0, -6.0, 6.0, -20.0, 20.0), 320, 240, -20,
    20 };
  ExpectLit(view,
    { BallAt({ 0, 0, 15 }, 4), BallAt({ 7, 5, -19 }, 3), BallAt({ -8.5f, 0, 0 }, 1),
      ConeAt({ 0, 7, 10 }, 20, { 0, -1, -1 }, 30) });
}

TEST(LightsThatFailElsewhere, LightsBeyondTheFarPlaneReachBeforeIt)
{
  ExpectLit(
    SquareView(), { BallAt({ 0, 0, -120 }, 40), ConeAt({ 20, 0, -150 }, 90, { 0, 0, 1 }, 20) });
}

TEST(LightsThatFailElsewhere, LightsAtTheEdgeOfTheView)
{
  // What is round is not round on the screen of a wide view; rows and columns are then not those of its middle.
  const LitView view{ "wide", glm::perspective(glm::radians(140.0), 1.0, 0.5, 50.0), 512, 512, 0.5,
    50 };
  std::vector<LightVolume> lights;
  for (int i = 0; i < 60; ++i)
  {
    const float angle = 0.1047f * static_cast<float>(i);
    lights.push_back(BallAt(
      { 24 * std::cos(angle), 24 * std::sin(angle), -10 }, 0.5f + 0.1f * static_cast<float>(i)));
  }
  ExpectLit(view, lights);
}

TEST(LightsThatFailElsewhere, VeryWideViewsToOneSide)
{
  // The sides of rows meet at more than 90 degrees. So the nearest point of the upper ones to what lies below is behind
  // the eye.
  const double sides[][4] = { { -40, 0.2, -40, 40 }, { -0.2, 40, -40, 40 }, { -40, 40, -40, 0.2 },
    { 10, 40, -40, 40 } };
  std::mt19937 random(23);
  for (const auto& side : sides)
  {
    const LitView view{ "one side", glm::frustum(side[0], side[1], side[2], side[3], 1.0, 50.0),
      256, 256, 1, 50 };
    std::vector<LightVolume> lights;
    for (int i = 0; i < 1500; ++i)
    {
      const double x = UniformIn(random, -60, 60), y = UniformIn(random, -60, 60);
      const glm::vec3 position(x, y, UniformIn(random, -3, 1));
      lights.push_back(BallAt(position, glm::length(position) * UniformIn(random, 0.3, 1.3)));
    }
    const ClusterGrid grid = GridFor(view, { 16, 16 });
    ExpectNoneMissing(view, grid, lights, ListsOf(grid, lights), random);
  }
}

TEST(LightsThatFailElsewhere, EndlessLightsAreInAllLists)
{
  const ClusterGrid grid = GridFor(SquareView());
  const LightLists lists = ListsOf(grid,
    { BallAt({ 0, 0, 9 }, Infinity), BallAt({ Infinity, 0, 9 }, 5), BallAt({ 0, 0, 9 }, NotANumber),
      BallAt({ NotANumber, 0, 9 }, 5), BallAt({ 0, 0, -9 }, 0) });
  for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
  {
    ASSERT_EQ(std::vector<std::uint32_t>(lists.BeginOf(cluster), lists.EndOf(cluster)),
      (std::vector<std::uint32_t>{ 0, 1, 2, 3 }));
  }
}

TEST(LightsThatFailElsewhere, FarAMillionTimesNear)
{
  const LitView view = SquareView(1e-3, 1e3);
  std::mt19937 random(21);
  ExpectLit(view, RandomLights(view, 100, random));
}

TEST(LightsThatFailElsewhere, ClippingRangesThatJitterAndTilesOfAllSizes)
{
  std::mt19937 random(22);
  const LitView view = SquareView(1, 50);
  const std::vector<LightVolume> lights = RandomLights(view, 80, random);
  for (int i = 0; i < 12; ++i)
  {
    LitView jittered = SquareView(UniformIn(random, 0.3, 1), UniformIn(random, 50, 90));
    jittered.Name = "jittered";
    const ClusterGrid grid = GridFor(jittered, { 10 + 17 * i, 2 + 3 * i });
    ExpectNoneMissing(view, grid, lights, ListsOf(grid, lights), random);
  }
}
