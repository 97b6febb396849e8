#include "chart/ParetoFront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using program::CostAndError;
using program::FindParetoFront;
using Indices = std::vector<std::size_t>;

bool Beats(const CostAndError& a, const CostAndError& b)
{
  return a.Cost <= b.Cost && a.Error <= b.Error && (a.Cost < b.Cost || a.Error < b.Error);
}

/** By the definition, one choice against all others. */
bool IsOnFront(const std::vector<CostAndError>& choices, std::size_t index)
{
  for (const CostAndError& other : choices)
  {
    if (Beats(other, choices[index]))
    {
      return false;
    }
  }
  return true;
}
}

TEST(ParetoFront, IsEmptyWithoutChoices)
{
  EXPECT_TRUE(FindParetoFront({}).empty());
}

TEST(ParetoFront, LeavesOutWhatIsBeatenInBoth)
{
  EXPECT_EQ(
    FindParetoFront({ { 3, 1 }, { 1, 3 }, { 2, 2 }, { 3, 3 }, { 2, 2.5 } }), (Indices{ 1, 2, 0 }));
}

TEST(ParetoFront, LeavesOutWhatIsBeatenInOneAndEqualInTheOther)
{
  EXPECT_EQ(FindParetoFront({ { 2, 1 }, { 1, 1 } }), (Indices{ 1 }));
  EXPECT_EQ(FindParetoFront({ { 1, 2 }, { 1, 1 } }), (Indices{ 1 }));
}

TEST(ParetoFront, KeepsEqualsInTheirOrder)
{
  EXPECT_EQ(FindParetoFront({ { 2, 0 }, { 1, 1 }, { 2, 0 }, { 1, 1 } }), (Indices{ 1, 3, 0, 2 }));
}

TEST(ParetoFront, TakesZeroAndInfinityAsNumbers)
{
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(FindParetoFront({ { 0, infinite }, { infinite, 0 }, { 0, 5 } }), (Indices{ 2, 1 }));
}

TEST(ParetoFront, LeavesOutWhatIsNotTold)
{
  EXPECT_EQ(
    FindParetoFront({ { std::nan(""), 0 }, { 0, std::nan("") }, { 1, 1 } }), (Indices{ 2 }));
}

TEST(ParetoFront, IsThatOfTheDefinition)
{
  const unsigned seed = 5;
  RecordProperty("seed", seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<CostAndError> choices;
    for (int i = 0; i < 12; ++i)
    {
      choices.push_back({ static_cast<double>(random() % 6), static_cast<double>(random() % 6) });
    }
    const Indices front = FindParetoFront(choices);
    for (std::size_t i = 0; i < choices.size(); ++i)
    {
      const bool isThere = std::find(front.begin(), front.end(), i) != front.end();
      EXPECT_EQ(isThere, IsOnFront(choices, i)) << "round " << round << ", choice " << i;
    }
  }
}
