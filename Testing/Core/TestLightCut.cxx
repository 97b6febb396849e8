// That all that is cut off at a point sums up to the budget at most: in closed form, and by summing it up.

#include "Core/lighting/LightCut.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using light_scenes::LightReaches;
using light_scenes::RandomDirection;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::CommonThreshold;
using vitrine::CutLights;
using vitrine::LightFalloff;
using vitrine::LightVolume;
using vitrine::LitRegion;

struct LitRoom
{
  std::vector<LightVolume> Volumes;
  std::vector<LightFalloff> Falloffs;
  Box Bounds{ { 0, 0, 0 }, { 100, 100, 20 } };

  void Add(const glm::vec3& position, double intensity, const glm::dvec3& attenuation)
  {
    LightVolume volume;
    volume.Position = position;
    this->Volumes.push_back(volume);
    this->Falloffs.emplace_back(glm::dvec3(1, 1, 1), intensity, attenuation);
  }

  void Cut(double budget)
  {
    CutLights(this->Falloffs, LitRegion(this->Bounds, glm::dmat4(1.0)), budget, this->Volumes);
  }

  /** What is cut off at a point. */
  double CutAt(const glm::dvec3& point) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Volumes.size(); ++i)
    {
      LightVolume whole = this->Volumes[i];
      whole.Range = static_cast<float>(Infinity);
      const double distance = glm::length(point - glm::dvec3(whole.Position));
      const bool isCut = LightReaches(whole, point) && distance > this->Volumes[i].Range;
      sum += isCut ? this->Falloffs[i].At(distance) : 0.0;
    }
    return sum;
  }
};

glm::vec3 PointOf(const Box& box, std::mt19937& random)
{
  glm::vec3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = static_cast<float>(UniformIn(random, box.Min[axis], box.Max[axis]));
  }
  return point;
}

/** Spot lights and others all over the room, or in one corner. */
LitRoom RoomOf(std::size_t count, double attenuation, bool isCrowded, std::mt19937& random)
{
  LitRoom room;
  const float size = isCrowded ? 15.0f : 100.0f;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 a(
      UniformIn(random, 0.1, 1), UniformIn(random, 0, 1), attenuation * UniformIn(random, 0.5, 2));
    room.Add(PointOf({ { 0, 0, 0 }, { size, size, 20 } }, random), UniformIn(random, 0.1, 3), a);
    room.Volumes.back().Axis = RandomDirection(random);
    room.Volumes.back().ConeAngle = i % 2 ? 180.0f : static_cast<float>(UniformIn(random, 5, 80));
  }
  return room;
}
}

TEST(LightCut, SharesTheBudgetEquallyByLightsThatCanBeCut)
{
  LitRoom room;
  for (int i = 0; i < 4; ++i)
  {
    room.Add({ 50, 50, 10 }, 1, { 0, 0, 1 });
  }
  room.Add({ 0, 0, 0 }, 1, { -1, 0, 1 });         // never cut
  room.Add({ 0, 0, 0 }, NotANumber, { 0, 0, 1 }); // likewise
  room.Add({ 0, 0, 0 }, 0, { 0, 0, 1 });          // gives nothing
  room.Cut(0.4);
  EXPECT_NEAR(room.Volumes[0].Range, std::sqrt(10.0), 1e-2);
  EXPECT_NEAR(room.Volumes[4].Range, std::sqrt(20400.0), 0.1); // to the farthest corner
  EXPECT_NEAR(room.Volumes[5].Range, std::sqrt(20400.0), 0.1);
  EXPECT_EQ(room.Volumes[6].Range, 0.0f);
}

TEST(LightCut, LeavesItsShareToOthersWhereALightIsStrongAsFarAsItReaches)
{
  LitRoom room;
  for (int i = 0; i < 100; ++i) // at the floor, which ends them after 1.2
  {
    room.Add({ 50, 50, 1 }, 1, { 0, 0, 1 });
    room.Volumes.back().Axis = { 0, 0, -1 };
    room.Volumes.back().ConeAngle = 30.0f;
  }
  room.Add({ 50, 50, 10 }, 1, { 0, 0, 1 });
  room.Cut(0.01);
  EXPECT_NEAR(room.Volumes[0].Range, 1.0 / std::cos(glm::radians(30.0)), 0.01);
  EXPECT_NEAR(room.Volumes[100].Range, 10.0, 0.03);
}

TEST(LightCut, HasAThresholdThatIsTheLargest)
{
  EXPECT_EQ(CommonThreshold(0.1, {}), 0.1);
  EXPECT_EQ(CommonThreshold(0.1, { 0.0f }), 0.1);
  EXPECT_EQ(CommonThreshold(0.1, { 1.0f, 1.0f, 1.0f }), 0.1);
  EXPECT_NEAR(CommonThreshold(0.1, { 0.0f, 0.0f, 1.0f, 1.0f }), 0.05, 1e-3);
  // Two may be cut at 0.05 each; a third would be at 0.04 already.
  EXPECT_NEAR(CommonThreshold(0.1, { 0.0f, 0.0f, 0.04f }), 0.04, 1e-3);
  EXPECT_NEAR(CommonThreshold(0.1, { 0.0f, 0.0f, static_cast<float>(NotANumber) }), 0.1 / 3, 1e-3);
}

TEST(LightCut, CutsNothingWithoutABudget)
{
  std::mt19937 random(1);
  LitRoom room = RoomOf(100, 10.0, false, random);
  room.Cut(0.0);
  for (int i = 0; i < 1000; ++i)
  {
    ASSERT_EQ(room.CutAt(glm::dvec3(PointOf(room.Bounds, random))), 0.0);
  }
}

TEST(LightCut, LeavesFlatLightsInUnlessTheyAreWeakerThanAll)
{
  LitRoom room;
  room.Add({ 0, 0, 0 }, 1, { 1, 0, 0 });
  room.Add({ 0, 0, 0 }, 0.06, { 1, 0, 0 });
  room.Cut(0.05);
  EXPECT_GT(room.Volumes[1].Range, 140.0f);
  room.Cut(0.1);
  EXPECT_GT(room.Volumes[0].Range, 140.0f);
  EXPECT_EQ(room.Volumes[1].Range, 0.0f);
}

TEST(LightCut, IsNeverExceededAnywhere)
{
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::size_t counts[] = { 1, 8, 9, 64, 300, 1500 };
    LitRoom room =
      RoomOf(counts[seed % 6], std::pow(10.0, UniformIn(random, -2, 3)), random() % 2 == 0, random);
    const double budget = std::pow(10.0, UniformIn(random, -4, 0));
    room.Cut(budget);
    double most = 0.0;
    for (int i = 0; i < 150; ++i)
    {
      most = std::max(most, room.CutAt(glm::dvec3(PointOf(room.Bounds, random))));
    }
    ASSERT_LE(most, budget * (1 + 1e-5));
  }
}

TEST(LightCut, LetsSpotLightsEndAtWallsWhereverTheBudgetWouldNot)
{
  std::mt19937 random(1);
  LitRoom room = RoomOf(2000, 1.0, false, random);
  room.Cut(0.5 / 255);
  const auto ended = std::count_if(room.Volumes.begin(), room.Volumes.end(),
    [](const LightVolume& volume) { return volume.Range < 20.0f; });
  EXPECT_GT(ended, 150);
}
