#include "Core/culling/walk/InsertionBudget.h"

#include <gtest/gtest.h>

using vitrine::InsertionBudget;

namespace
{
/** The most that a budget allows. */
std::size_t MostOf(const InsertionBudget& budget)
{
  std::size_t most = 0;
  for (std::size_t step = 1u << 24; step > 0; step /= 2)
  {
    most += budget.Allows(most + step) ? step : 0;
  }
  return most;
}

std::size_t MostOfFirst(std::size_t parts)
{
  InsertionBudget budget;
  budget.Begin(parts);
  return MostOf(budget);
}

/** Leaves what a frame gets in which nothing is hidden, and tells what that is. */
std::size_t SpendAll(InsertionBudget& budget, std::size_t parts)
{
  budget.Begin(parts);
  budget.Spend(MostOf(budget));
  budget.Begin(parts);
  return MostOf(budget);
}
}

TEST(InsertionBudget, OfTheFirstFrameIsWhatItsPartsAreWorth)
{
  InsertionBudget few, many;
  few.Begin(10);
  many.Begin(1000);
  EXPECT_EQ(100 * MostOf(few), MostOf(many));
  EXPECT_GT(MostOf(few), 500u);
}

TEST(InsertionBudget, IsKeptUntilItIsSpent)
{
  InsertionBudget budget;
  budget.Begin(1000);
  const std::size_t all = MostOf(budget);
  for (int frame = 0; frame < 10; ++frame)
  {
    budget.AddHidden(1000);
    budget.Begin(1000);
    EXPECT_EQ(MostOf(budget), all);
  }
}

TEST(InsertionBudget, GrowsByWhatIsHiddenAndByALittle)
{
  InsertionBudget budget;
  const std::size_t trial = SpendAll(budget, 1000);
  const std::size_t all = MostOfFirst(1000);
  EXPECT_GT(trial, 0u);
  EXPECT_LT(10 * trial, all);
  budget.AddHidden(100);
  budget.AddHidden(200);
  budget.Begin(1000);
  const std::size_t earned =
    all / 4 * 3 / 10; // a quarter of what there is at first, of 300 parts in 1000
  EXPECT_EQ(MostOf(budget), 2 * trial + earned);
  budget.Begin(1000);
  EXPECT_EQ(MostOf(budget), 3 * trial + earned);
}

TEST(InsertionBudget, OfEachBandIsAShareOfWhatIsTried)
{
  InsertionBudget whole, band;
  const std::size_t trial = SpendAll(whole, 1000);
  band.Begin(1000, 4);
  EXPECT_EQ(MostOf(band), MostOfFirst(1000)) << "all may be in one band";
  band.Spend(MostOf(band));
  band.Begin(1000, 4);
  EXPECT_EQ(4 * MostOf(band), trial);
}

TEST(InsertionBudget, IsSpentButNeverMoreThanThereIs)
{
  InsertionBudget budget;
  budget.Begin(10);
  const std::size_t all = MostOf(budget);
  budget.Spend(all - 5);
  EXPECT_TRUE(budget.Allows(5));
  EXPECT_FALSE(budget.Allows(6));
  budget.Spend(100);
  EXPECT_EQ(MostOf(budget), 0u);
  EXPECT_TRUE(budget.Allows(0));
}

TEST(InsertionBudget, WhatIsSpentBeyondItTheNextFramesPay)
{
  InsertionBudget budget;
  const std::size_t trial = SpendAll(budget, 100);
  budget.Spend(3 * trial + trial / 4);
  for (const std::size_t left : { std::size_t{ 0 }, std::size_t{ 0 }, trial - trial / 4 })
  {
    budget.Begin(100);
    EXPECT_EQ(MostOf(budget), left);
  }
}

TEST(InsertionBudget, SparesWhatIsMoreThanHalf)
{
  InsertionBudget budget;
  budget.Begin(100);
  const std::size_t half = MostOf(budget) / 2;
  EXPECT_TRUE(budget.CanSpare(half));
  EXPECT_FALSE(budget.CanSpare(half + 1));
  budget.Spend(half - 10);
  EXPECT_TRUE(budget.CanSpare(10));
  EXPECT_FALSE(budget.CanSpare(11));
  budget.Spend(2 * half);
  EXPECT_FALSE(budget.CanSpare(0));
}

TEST(InsertionBudget, KeepsAnEighthForWhatCoversMuch)
{
  InsertionBudget budget;
  budget.Begin(100);
  const std::size_t most = MostOf(budget), eighth = most / 8;
  EXPECT_TRUE(budget.AllowsSmall(most - eighth));
  EXPECT_FALSE(budget.AllowsSmall(most - eighth + 1));
  budget.Spend(most - eighth + 1);
  EXPECT_FALSE(budget.AllowsSmall(1));
  EXPECT_TRUE(budget.Allows(eighth - 1));
  budget.Spend(most);
  EXPECT_TRUE(budget.AllowsSmall(0)) << "what takes next to nothing";
}

// However much one try takes, and though it is known only afterwards.
TEST(InsertionBudget, IsKeptToInTheLongRun)
{
  for (const std::size_t tries : { 1u, 7u, 300u })
  {
    InsertionBudget budget;
    const std::size_t trial = SpendAll(budget, 40);
    std::size_t spent = 0;
    for (int frame = 0; frame < 1000; ++frame)
    {
      if (budget.Allows(trial))
      {
        budget.Spend(tries * trial);
        spent += tries * trial;
      }
      budget.Begin(40);
    }
    EXPECT_LE(spent, (1000 + tries) * trial);
    EXPECT_GE(spent, (1000 - tries) * trial);
  }
}

TEST(InsertionBudget, BeginsAnewWhereManyPartsHaveCome)
{
  InsertionBudget budget;
  budget.Begin(10);
  budget.Spend(1000000);
  budget.Begin(100);
  EXPECT_EQ(MostOf(budget), MostOfFirst(100));
}

TEST(InsertionBudget, OfNothingIsSmall)
{
  InsertionBudget budget;
  budget.Begin(0);
  EXPECT_LT(MostOf(budget), 1000u);
}
