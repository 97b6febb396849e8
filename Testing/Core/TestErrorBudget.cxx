// That all that is cut off at a point sums up to the budget at most: in closed form, and by summing it up.

#include "Core/lighting/ErrorBudget.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::ErrorBudget;
using vitrine::LightFalloff;

struct LitRoom
{
  std::vector<glm::vec3> Positions;
  std::vector<LightFalloff> Falloffs;
  std::vector<Box> Cells;

  void Add(const glm::vec3& position, double intensity, const glm::dvec3& attenuation)
  {
    this->Positions.push_back(position);
    this->Falloffs.emplace_back(glm::dvec3(1, 1, 1), intensity, attenuation);
  }

  ErrorBudget Budget() const { return ErrorBudget(this->Positions, this->Falloffs); }

  /** What is cut off at a point of lights that are cut at a threshold. */
  double CutAt(const glm::dvec3& point, double threshold) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      const double distance = glm::length(point - glm::dvec3(this->Positions[i]));
      sum += distance > this->Falloffs[i].RangeAt(threshold) ? this->Falloffs[i].At(distance) : 0.0;
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

/** A room of 100 x 100 x 20 of which cells are known, with lights all over, or in one corner. */
LitRoom RoomOf(std::size_t count, double attenuation, bool isCrowded, std::mt19937& random)
{
  LitRoom room;
  const float size = isCrowded ? 15.0f : 100.0f;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 a(
      UniformIn(random, 0.1, 1), UniformIn(random, 0, 1), attenuation * UniformIn(random, 0.5, 2));
    room.Add(PointOf({ { 0, 0, 0 }, { size, size, 20 } }, random), UniformIn(random, 0.1, 3), a);
  }
  for (int i = 0; i < 10 * 10 * 2; ++i)
  {
    const glm::vec3 low(10.0f * (i % 10), 10.0f * (i / 10 % 10), 10.0f * (i / 100));
    room.Cells.push_back({ low, low + 10.0f });
  }
  return room;
}
}

TEST(ErrorBudget, IsSharedEquallyByLightsThatCanBeCut)
{
  LitRoom room;
  for (int i = 0; i < 4; ++i)
  {
    room.Add({ i, 0, 0 }, 1, { 0, 0, 1 });
  }
  room.Add({ 0, 0, 0 }, 1, { -1, 0, 1 });         // never cut
  room.Add({ 0, 0, 0 }, NotANumber, { 0, 0, 1 }); // likewise
  room.Add({ 0, 0, 0 }, 0, { 0, 0, 1 });          // gives nothing
  EXPECT_DOUBLE_EQ(room.Budget().UniformThreshold(0.4), 0.1);
}

TEST(ErrorBudget, OfOneLightIsItsThreshold)
{
  LitRoom room;
  room.Add({ 0, 0, 0 }, 1, { 0, 0, 1 });
  EXPECT_EQ(room.Budget().CommonThreshold(0.01, { { { -50, -50, -50 }, { 50, 50, 50 } } }), 0.01);
}

TEST(ErrorBudget, OfLightsFarApartIsThatOfThoseNear)
{
  // At most two are cut where something is lit: those of one place, since all others together give less than a hundredth.
  LitRoom room;
  for (int i = 0; i < 50; ++i)
  {
    room.Add({ 1e4f * i, 0, 0 }, 1, { 0, 0, 1 });
    room.Add({ 1e4f * i, 1, 0 }, 1, { 0, 0, 1 });
    room.Cells.push_back({ { 1e4f * i - 20, -20, -20 }, { 1e4f * i + 20, 20, 20 } });
  }
  const double threshold = room.Budget().CommonThreshold(0.01, room.Cells);
  EXPECT_GT(threshold, 0.98 * 0.005);
  EXPECT_LE(threshold, 0.005);
}

TEST(ErrorBudget, OfWhatIsFarFromAllThatIsLitIsThatOfTheirSum)
{
  LitRoom room;
  for (int i = 0; i < 100; ++i)
  {
    room.Add({ 1000, 0, i % 10 }, 1, { 0, 0, 1 });
  }
  const Box cell{ { 0, 0, 0 }, { 1, 1, 1 } };
  EXPECT_NEAR(room.Budget().BoundIn(cell, 1.0, 1.0), 100 / (999.0 * 999.0), 1e-6);
  EXPECT_EQ(room.Budget().CommonThreshold(1.1e-4, { cell }), 1.1e-4); // all of them may go
}

TEST(ErrorBudget, LeavesFlatLightsInUnlessTheyAreWeakerThanAll)
{
  LitRoom room;
  room.Add({ 0, 0, 0 }, 1, { 1, 0, 0 });
  room.Add({ 0, 0, 0 }, 1, { 0, 0, 1 });
  const Box cell{ { -9, -9, -9 }, { 9, 9, 9 } };
  EXPECT_NEAR(room.Budget().BoundIn(cell, 0.1, 1.0), 0.1, 1e-6);
  EXPECT_NEAR(room.Budget().CommonThreshold(0.1, { cell }), 0.1, 1e-3);
  room.Add({ 0, 0, 0 }, 0.06, { 1, 0, 0 });
  EXPECT_LT(room.Budget().CommonThreshold(0.1, { cell }), 0.0601);
}

TEST(ErrorBudget, IsNeverExceededAnywhere)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::size_t counts[] = { 1, 8, 9, 64, 300, 1500 };
    const LitRoom room =
      RoomOf(counts[seed % 6], std::pow(10.0, UniformIn(random, -2, 3)), random() % 2 == 0, random);
    const double budget = std::pow(10.0, UniformIn(random, -4, 0));
    const ErrorBudget errors = room.Budget();
    const double common = errors.CommonThreshold(budget, room.Cells);
    ASSERT_GE(common, errors.UniformThreshold(budget));
    for (int i = 0; i < 150; ++i)
    {
      const Box& cell = room.Cells[random() % room.Cells.size()];
      const glm::dvec3 point(PointOf(cell, random));
      ASSERT_LE(room.CutAt(point, common), budget * (1 + 1e-12));
      for (const double threshold : { common, 0.1 * common, 10 * common })
      {
        ASSERT_LE(room.CutAt(point, threshold), errors.BoundIn(cell, threshold, Infinity));
      }
    }
  }
}

TEST(ErrorBudget, LetsListsGetShorterThanEqualSharesDo)
{
  std::mt19937 random(1);
  const LitRoom room = RoomOf(2000, 400.0, false, random);
  const ErrorBudget errors = room.Budget();
  const double budget = 0.5 / 255;
  const double uniform = errors.UniformThreshold(budget);
  const double common = errors.CommonThreshold(budget, room.Cells);
  std::size_t before = 0, after = 0;
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec3 point(PointOf({ { 0, 0, 0 }, { 100, 100, 20 } }, random));
    for (std::size_t light = 0; light < room.Positions.size(); ++light)
    {
      const double distance = glm::length(point - glm::dvec3(room.Positions[light]));
      before += distance <= room.Falloffs[light].RangeAt(uniform);
      after += distance <= room.Falloffs[light].RangeAt(common);
    }
  }
  EXPECT_LT(3 * after, 2 * before);
}

TEST(ErrorBudget, OfNothingIsTheBudget)
{
  EXPECT_EQ(ErrorBudget({}, {}).CommonThreshold(0.1, { Box{ { 0, 0, 0 }, { 1, 1, 1 } } }), 0.1);
  LitRoom room;
  room.Add({ 0, 0, 0 }, 1, { 0, 0, 1 });
  room.Add({ 0, 0, 0 }, 1, { 0, 0, 1 });
  EXPECT_EQ(room.Budget().CommonThreshold(0.1, {}), 0.1);
  EXPECT_EQ(room.Budget().CommonThreshold(0.1, { Box() }), 0.1);
  EXPECT_EQ(room.Budget().CommonThreshold(0.0, { Box{ { 0, 0, 0 }, { 1, 1, 1 } } }), 0.0);
}
