#include "Core/reveal/SteadyReveal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{

using vitrine::FrontStacks;
using vitrine::SteadyReveal;

constexpr double atOnce = std::numeric_limits<double>::infinity();

// Updates with opaque parts of the same area.
SteadyReveal::Change UpdateOpaque(SteadyReveal& reveal,
  const std::vector<std::vector<std::uint32_t>>& pixels, double degrees, double opacity = 1.0)
{
  FrontStacks stacks;
  for (const auto& layers : pixels)
  {
    stacks.Add(layers.data(), layers.size());
  }
  return reveal.Update(
    stacks, std::vector<SteadyReveal::FrontPart>(stacks.Parts().size(), { 1.0, opacity }), degrees);
}

double FadedTo(const SteadyReveal& reveal, std::uint32_t part)
{
  return reveal.Parts().at(part).Opacity;
}

TEST(SteadyReveal, PartsRiseByDegreesWhenLessIsInFront)
{
  SteadyReveal reveal(0.7, 0.05);
  UpdateOpaque(reveal, { { 1, 1, 1, 1 } }, atOnce);
  const double before = FadedTo(reveal, 1);
  EXPECT_NEAR(before, 1.0 - std::pow(0.7, 0.25), 1e-3);
  const SteadyReveal::Change change = UpdateOpaque(reveal, { { 1 } }, 2.0);
  EXPECT_NEAR(FadedTo(reveal, 1), before + 0.1, 2e-3);
  EXPECT_LE(change.MostOfOthers, 0.1 + 1e-9);
  UpdateOpaque(reveal, { { 1 } }, atOnce);
  EXPECT_NEAR(FadedTo(reveal, 1), 0.3, 5e-3);
}

TEST(SteadyReveal, APartThatIsNewlyInFrontDropsAtOnce)
{
  SteadyReveal reveal(0.7, 0.05);
  UpdateOpaque(reveal, { { 1 } }, atOnce);
  const double before = FadedTo(reveal, 1);
  const SteadyReveal::Change change = UpdateOpaque(reveal, { { 1 }, { 2 } }, 1.0);
  EXPECT_EQ(change.NewlyInFront, 1u);
  EXPECT_EQ(change.Dropped, 1u);
  EXPECT_EQ(change.Forced, 0u);
  EXPECT_NEAR(FadedTo(reveal, 1), before, 0.05 + 1e-9);
  EXPECT_NEAR(FadedTo(reveal, 2), 0.3, 5e-3);
}

TEST(SteadyReveal, TheShareWinsWherePartsComeTogether)
{
  SteadyReveal reveal(0.7, 0.05);
  UpdateOpaque(reveal, { { 1 }, { 2 }, { 3 } }, atOnce);
  // Parts 1 and 2 pass 0.49 together. One of them has to drop, and part 3 stays nearly as it was.
  const SteadyReveal::Change change = UpdateOpaque(reveal, { { 1, 2 }, { 3 } }, 1.0);
  EXPECT_EQ(change.Forced, 1u);
  EXPECT_LE(change.Proof.Deepest, -std::log(0.7));
  EXPECT_LE(change.MostOfOthers, 0.05 + 1e-9);
  EXPECT_GE((1.0 - FadedTo(reveal, 1)) * (1.0 - FadedTo(reveal, 2)), 0.7);
}

TEST(SteadyReveal, PartsThatAreNoMoreInFrontComeBackByDegrees)
{
  SteadyReveal reveal(0.7, 0.05);
  UpdateOpaque(reveal, { { 1 } }, atOnce, 0.5);
  const double before = FadedTo(reveal, 1);
  UpdateOpaque(reveal, { {} }, 1.0);
  EXPECT_NEAR(FadedTo(reveal, 1), before + 0.05, 1e-12);
  EXPECT_FALSE(reveal.Parts().at(1).IsInFront);
  UpdateOpaque(reveal, { {} }, 100.0);
  EXPECT_TRUE(reveal.Parts().empty());
}

TEST(SteadyReveal, OpacitiesNeverExceedTheOriginalOnes)
{
  SteadyReveal reveal(0.5, 0.05);
  UpdateOpaque(reveal, { { 1, 2 } }, atOnce, 0.1);
  EXPECT_LE(FadedTo(reveal, 1), 0.1);
  EXPECT_GE(FadedTo(reveal, 1), 0.099); // nothing has to be faded
}

TEST(SteadyReveal, KeepsItsLimitsInAnyRowOfViews)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    SteadyReveal reveal(0.6, 0.05);
    std::vector<std::vector<std::uint32_t>> pixels(40);
    for (int view = 0; view < 30; ++view)
    {
      for (auto& layers : pixels)
      {
        if (view == 0 || random() % 10 == 0)
        {
          layers.resize(random() % 6);
          std::generate(layers.begin(), layers.end(), [&] { return random() % 25; });
        }
      }
      const auto old = reveal.Parts();
      const SteadyReveal::Change change = UpdateOpaque(reveal, pixels, view == 0 ? atOnce : 1.0);
      EXPECT_LE(change.Proof.Deepest, -std::log(0.6) * (1.0 + 1e-12));
      std::size_t jumps = 0;
      for (const auto& [number, part] : reveal.Parts())
      {
        const auto before = old.find(number);
        const double opacity = before == old.end() ? 1.0 : before->second.Opacity;
        const bool jumped = std::abs(part.Opacity - opacity) > 0.05 + 1e-9;
        EXPECT_FALSE(jumped && part.Opacity > opacity && view > 0); // jumps are drops
        jumps += jumped;
      }
      if (view > 0)
      {
        EXPECT_EQ(jumps, change.Dropped + change.Forced);
      }
    }
  }
}

TEST(SteadyReveal, PartsThatMayComeTogetherFallInTime)
{
  // Parts 1 and 2 come nearer to each other, and together after four degrees.
  SteadyReveal reveal(0.7, 0.05);
  const auto update = [&](double degrees, bool isNear, bool areTogether)
  {
    FrontStacks stacks;
    const std::uint32_t both[] = { 1, 2 };
    stacks.Add(both, 1);
    stacks.Add(both + 1, 1);
    if (areTogether)
    {
      stacks.Add(both, 2);
    }
    if (isNear)
    {
      stacks.AddNear({ { 0, 1 }, { 1, 1 } });
    }
    return reveal.Update(stacks, { { 1.0, 1.0 }, { 1.0, 1.0 } }, degrees);
  };
  update(atOnce, false, false);
  EXPECT_NEAR(FadedTo(reveal, 1), 0.3, 5e-3);
  for (int degree = 0; degree < 4; ++degree)
  {
    EXPECT_EQ(update(1.0, true, false).Forced, 0u);
  }
  const SteadyReveal::Change change = update(1.0, false, true);
  EXPECT_EQ(change.Forced, 0u);
  EXPECT_LE(change.Proof.Deepest, -std::log(0.7));
}

TEST(SteadyReveal, BeginsWithRoomForWhatMayComeTogether)
{
  SteadyReveal reveal(0.7, 0.05);
  FrontStacks stacks;
  const std::uint32_t both[] = { 1, 2 };
  stacks.Add(both, 1);
  stacks.Add(both + 1, 1);
  stacks.AddNear({ { 0, 1 }, { 1, 1 } });
  const auto change = reveal.Update(stacks, { { 1.0, 1.0 }, { 1.0, 1.0 } }, atOnce);
  // Each has half of the depth of the share, and what it can fall by in a degree.
  for (const double depth : change.Proof.Depths)
  {
    EXPECT_NEAR(depth, -std::log(0.7) / 2.0 + 0.05, 3e-3);
  }
}

TEST(MakeRoom, LetsTheFewestPartsDrop)
{
  FrontStacks stacks;
  for (const std::vector<std::uint32_t>& layers :
    { std::vector<std::uint32_t>{ 1, 2 }, { 1, 3 }, { 1, 4 }, { 5 } })
  {
    stacks.Add(layers.data(), layers.size());
  }
  std::vector<vitrine::FadedPart> parts(5, { 1.0, 0.3, 1.0 });
  vitrine::MakeRoom(stacks, 0.4, parts);
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    EXPECT_EQ(parts[j].Least, stacks.Parts()[j] == 1 ? 0.0 : 0.3);
  }
}

}
