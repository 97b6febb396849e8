#include "Core/reveal/MostContext.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using vitrine::FadedPart;
using vitrine::FadedParts;
using vitrine::FrontStacks;
using vitrine::MostContext;

constexpr double infinite = std::numeric_limits<double>::infinity();

FrontStacks StacksOf(const std::vector<std::vector<std::uint32_t>>& pixels)
{
  FrontStacks stacks;
  for (const auto& layers : pixels)
  {
    stacks.Add(layers.data(), layers.size());
  }
  return stacks;
}

// Calls MostContext() with the same limit for all stacks.
FadedParts MostContextOf(
  const FrontStacks& stacks, const std::vector<FadedPart>& parts, double deepest, double gap = 0.01)
{
  return MostContext(stacks, parts, std::vector<double>(stacks.Count(), deepest), gap);
}

// Depths are within their ranges, no stack is too deep, and the context and its bound are what is said of them.
void ExpectProved(const FrontStacks& stacks, const std::vector<FadedPart>& parts, double deepest,
  double gap, const FadedParts& faded)
{
  double context = 0.0;
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    EXPECT_GE(faded.Depths[j], parts[j].Least);
    EXPECT_LE(faded.Depths[j], parts[j].Most);
    context += parts[j].Weight * (1.0 - std::exp(-faded.Depths[j]));
  }
  for (std::size_t i = 0; i < stacks.Count(); ++i)
  {
    EXPECT_LE(DepthOf(stacks, i, faded.Depths), deepest);
  }
  EXPECT_NEAR(faded.Context, context, 1e-9 * context);
  EXPECT_GE(faded.Context, (1.0 - gap) * faded.Bound);
  EXPECT_LE(faded.Context, faded.Bound * (1.0 + 1e-12));
}

TEST(MostContext, FadesOnePartToTheShare)
{
  const FrontStacks stacks = StacksOf({ { 4 }, { 4, 4, 4 } });
  const std::vector<FadedPart> parts{ { 10.0, 0.0, infinite } };
  const double deepest = -std::log(0.7);
  const FadedParts faded = MostContextOf(stacks, parts, deepest, 1e-6);
  ExpectProved(stacks, parts, deepest, 1e-6, faded);
  // Three layers pass 0.7 together.
  EXPECT_NEAR(std::exp(-faded.Depths[0]), std::cbrt(0.7), 1e-6);
  EXPECT_NEAR(faded.Deepest, deepest, 1e-6);
}

TEST(MostContext, SharesAStackByWeights)
{
  // The gain of a further unit of depth is weight * (1 - opacity), and it is the same for both at the optimum.
  const FrontStacks stacks = StacksOf({ { 1, 2 } });
  const std::vector<FadedPart> parts{ { 3.0, 0.0, infinite }, { 2.0, 0.0, infinite } };
  const double deepest = -std::log(0.1);
  const FadedParts faded = MostContextOf(stacks, parts, deepest, 1e-9);
  ExpectProved(stacks, parts, deepest, 1e-9, faded);
  const double difference = std::log(3.0 / 2.0);
  EXPECT_NEAR(faded.Depths[0], (deepest + difference) / 2.0, 1e-4);
  EXPECT_NEAR(faded.Depths[1], (deepest - difference) / 2.0, 1e-4);
}

TEST(MostContext, LeavesTheLighterPartNothingWhereTheStackIsShallow)
{
  // Even at the end of the stack's depth the heavier part gains 0.7 * 10, which is more than 1.
  const FrontStacks stacks = StacksOf({ { 1, 2 }, { 2, 3 } });
  const std::vector<FadedPart> parts{ { 10.0, 0.0, infinite }, { 1.0, 0.0, infinite },
    { 1.0, 0.0, infinite } };
  const double deepest = -std::log(0.7);
  const FadedParts faded = MostContextOf(stacks, parts, deepest, 1e-9);
  ExpectProved(stacks, parts, deepest, 1e-9, faded);
  EXPECT_NEAR(faded.Depths[0], deepest, 1e-6);
  EXPECT_NEAR(faded.Depths[1], 0.0, 1e-6);
  EXPECT_NEAR(faded.Depths[2], deepest, 1e-6);
}

TEST(MostContext, KeepsWithinTheRangesOfDepths)
{
  const FrontStacks stacks = StacksOf({ { 1, 2, 3 } });
  const std::vector<FadedPart> parts{ { 10.0, 0.0, 0.05 }, { 1.0, 0.1, infinite },
    { 5.0, 0.2, 0.2 } };
  const FadedParts faded = MostContextOf(stacks, parts, 0.4, 1e-9);
  ExpectProved(stacks, parts, 0.4, 1e-9, faded);
  EXPECT_NEAR(faded.Depths[0], 0.05, 1e-6);
  EXPECT_NEAR(faded.Depths[1], 0.15, 1e-6);
  EXPECT_EQ(faded.Depths[2], 0.2);
}

TEST(MostContext, NothingToDecideIsAnswered)
{
  const FadedParts none = MostContextOf(StacksOf({ {}, {} }), {}, 0.3);
  EXPECT_TRUE(none.Depths.empty());
  EXPECT_EQ(none.ProvedShare(), 1.0);
  // All light shall pass: nothing may remain.
  const FadedParts all = MostContextOf(StacksOf({ { 1 } }), { { 1.0, 0.0, infinite } }, 0.0);
  EXPECT_EQ(all.Depths, std::vector<double>{ 0.0 });
  EXPECT_EQ(all.ProvedShare(), 1.0);
}

TEST(MostContext, PartsWithoutAreaAreFadedToo)
{
  const FrontStacks stacks = StacksOf({ { 1, 2 }, { 1 } });
  const std::vector<FadedPart> parts{ { 0.0, 0.0, infinite }, { 0.0, 0.0, infinite } };
  const FadedParts faded = MostContextOf(stacks, parts, 0.3);
  EXPECT_LE(faded.Deepest, 0.3);
}

// A linear congruential generator, so that figures/context_optima.py makes the same reveals.
class CongruentialNumbers
{
public:
  explicit CongruentialNumbers(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Next()
  {
    this->State = this->State * 6364136223846793005u + 1442695040888963407u;
    return this->State >> 33;
  }

private:
  std::uint64_t State;
};

struct Optimum
{
  int Seed;
  std::uint32_t Parts;
  int Stacks;
  double Share;
  double Reached; // by HiGHS
  double Bound;
};

const Optimum optima[] = {
#include "figures/ContextOptima.inc"
};

TEST(MostContext, IsThatOfHighs)
{
  for (const Optimum& optimum : optima)
  {
    SCOPED_TRACE(optimum.Seed);
    CongruentialNumbers random(optimum.Seed);
    FrontStacks stacks;
    for (int i = 0; i < optimum.Stacks; ++i)
    {
      std::vector<std::uint32_t> layers(2 + random.Next() % 12);
      for (std::uint32_t& layer : layers)
      {
        layer = static_cast<std::uint32_t>(random.Next() % optimum.Parts);
      }
      stacks.Add(layers.data(), layers.size());
    }
    std::vector<FadedPart> ofNumbers(optimum.Parts);
    for (FadedPart& part : ofNumbers)
    {
      part.Weight = 1.0 + static_cast<double>(random.Next() % 1000);
    }
    for (FadedPart& part : ofNumbers)
    {
      const double opacity = static_cast<double>(1 + random.Next() % 10) / 10.0;
      part.Most = opacity < 1.0 ? -std::log1p(-opacity) : infinite;
    }
    std::vector<FadedPart> parts;
    for (const std::uint32_t number : stacks.Parts())
    {
      parts.push_back(ofNumbers[number]);
    }
    const double deepest = -std::log(optimum.Share);
    for (const double gap : { 0.01, 1e-6 })
    {
      const FadedParts faded = MostContextOf(stacks, parts, deepest, gap);
      ExpectProved(stacks, parts, deepest, gap, faded);
      EXPECT_LE(faded.Context, optimum.Bound * (1.0 + 1e-7));
      EXPECT_GE(faded.Bound, optimum.Reached * (1.0 - 1e-7));
      EXPECT_GE(faded.Context, (1.0 - gap - 1e-5) * optimum.Reached);
    }
  }
}

}
