#include "Core/culling/InsertionBudget.h"

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
}

TEST(InsertionBudget, OfTheFirstFrameIsWhatItsPartsAreWorth)
{
  InsertionBudget few, many;
  few.Begin(10);
  many.Begin(1000);
  EXPECT_EQ(100 * MostOf(few), MostOf(many));
  EXPECT_GT(MostOf(few), 500u);
}

TEST(InsertionBudget, IsLessWhereNothingWasHiddenAndMoreWhereMuchWas)
{
  InsertionBudget budget;
  budget.Begin(1000);
  const std::size_t first = MostOf(budget);
  budget.Begin(1000);
  const std::size_t trial = MostOf(budget);
  EXPECT_LT(10 * trial, first + 10000);
  EXPECT_GT(trial, 0u);
  budget.AddHidden(300);
  budget.AddHidden(200);
  budget.Begin(1000);
  EXPECT_EQ(MostOf(budget), trial + first / 2);
  budget.Begin(1000);
  EXPECT_EQ(MostOf(budget), trial);
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
  budget.Begin(100);
  budget.Begin(100);
  const std::size_t trial = MostOf(budget);
  budget.Spend(3 * trial + trial / 4);
  for (const std::size_t left : { std::size_t{ 0 }, std::size_t{ 0 }, trial - trial / 4, trial })
  {
    budget.Begin(100);
    EXPECT_EQ(MostOf(budget), left);
  }
}

TEST(InsertionBudget, WhatIsHiddenPaysForWhatHidesIt)
{
  InsertionBudget budget;
  budget.Begin(100);
  budget.Begin(100);
  const std::size_t trial = MostOf(budget);
  budget.AddHidden(50);
  budget.Begin(100);
  const std::size_t worth = MostOf(budget) - trial;
  for (int frame = 0; frame < 10; ++frame) // takes as much as it is worth
  {
    budget.Spend(worth + trial);
    budget.AddHidden(50);
    budget.Begin(100);
    EXPECT_EQ(MostOf(budget), worth + trial);
  }
}

// However much one try takes, and though it is known only afterwards.
TEST(InsertionBudget, IsKeptToInTheLongRun)
{
  for (const std::size_t tries : { 1u, 7u, 300u })
  {
    InsertionBudget budget;
    budget.Begin(40);
    budget.Begin(40);
    const std::size_t trial = MostOf(budget);
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
    EXPECT_GE(spent, 1000 * trial - tries * trial);
  }
}

TEST(InsertionBudget, BeginsAnewWhereManyPartsHaveCome)
{
  InsertionBudget budget, fresh;
  budget.Begin(10);
  budget.Begin(10);
  budget.Spend(1000000);
  budget.Begin(100);
  fresh.Begin(100);
  EXPECT_EQ(MostOf(budget), MostOf(fresh));
}

TEST(InsertionBudget, OfNothingIsSmall)
{
  InsertionBudget budget;
  budget.Begin(0);
  EXPECT_LT(MostOf(budget), 1000u);
}
