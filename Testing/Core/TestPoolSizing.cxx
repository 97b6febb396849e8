#include "Core/lists/PoolSizing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{

using vitrine::PoolSizing;

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

// A frame as a pass plays it: grow if it overflows, then end. Returns how often the size changed.
int PlayFrame(PoolSizing& sizing, std::uint64_t used)
{
  int changes = 0;
  if (used > sizing.Capacity())
  {
    EXPECT_TRUE(sizing.Grow(used));
    ++changes;
  }
  EXPECT_GE(sizing.Capacity(), used);
  changes += sizing.EndFrame(used);
  return changes;
}

TEST(PoolSizing, BeginsAtTheMinimumAndGrowsByAnEighth)
{
  PoolSizing sizing(1000);
  EXPECT_EQ(sizing.Capacity(), 1000u);
  EXPECT_TRUE(sizing.Grow(1000));
  EXPECT_EQ(sizing.Capacity(), 1000u);
  EXPECT_TRUE(sizing.Grow(80000));
  EXPECT_EQ(sizing.Capacity(), 90112u); // 90,000 rounded up to 22 granules
  EXPECT_TRUE(sizing.Grow(90112));
  EXPECT_EQ(sizing.Capacity(), 90112u);
}

TEST(PoolSizing, GrowsByAQuarterWhenItGrowsAgainSoon)
{
  PoolSizing sizing;
  sizing.Grow(4096 * 80);
  EXPECT_EQ(sizing.Capacity(), 4096u * 90);
  sizing.EndFrame(4096 * 80);
  sizing.Grow(4096 * 100);
  EXPECT_EQ(sizing.Capacity(), 4096u * 125);
  for (int frame = 0; frame < PoolSizing::Window; ++frame)
  {
    sizing.EndFrame(4096 * 100);
  }
  sizing.Grow(4096 * 160);
  EXPECT_EQ(sizing.Capacity(), 4096u * 180);
}

TEST(PoolSizing, PoolOfNothingNeedsNothing)
{
  PoolSizing sizing(0);
  EXPECT_TRUE(sizing.Grow(0));
  for (int frame = 0; frame < 100; ++frame)
  {
    EXPECT_FALSE(sizing.EndFrame(0));
  }
  EXPECT_EQ(sizing.Capacity(), 0u);
  EXPECT_TRUE(sizing.Grow(1));
  EXPECT_EQ(sizing.Capacity(), PoolSizing::Granule);
}

TEST(PoolSizing, LimitIsKept)
{
  PoolSizing sizing(100);
  sizing.SetLimit(50001);
  EXPECT_EQ(sizing.Limit(), 50001u);
  EXPECT_TRUE(sizing.Grow(50001)); // no room for a reserve, nor for whole granules
  EXPECT_EQ(sizing.Capacity(), 50001u);
  EXPECT_FALSE(sizing.Grow(50002));
  EXPECT_EQ(sizing.Capacity(), 50001u);
  EXPECT_FALSE(sizing.EndFrame(60000)); // drawn in bands

  sizing.SetLimit(40000);
  EXPECT_EQ(sizing.Capacity(), 40000u);
  sizing.SetLimit(50); // below the minimum: the limit wins
  EXPECT_EQ(sizing.Capacity(), 50u);
  sizing.SetLimit(0);
  EXPECT_EQ(sizing.Capacity(), 0u);
  EXPECT_FALSE(sizing.Grow(1));
  sizing.SetLimit(most);
  EXPECT_EQ(sizing.Capacity(), 0u);
  EXPECT_TRUE(sizing.Grow(1));
}

TEST(PoolSizing, SteadyNeedSettlesWithinAWindowAtMost30PercentAbove)
{
  for (std::uint64_t need : { 24000ull, 100000ull, 11180000ull, 1ull << 33, 1ull << 50 })
  {
    for (double before : { 1.05, 1.2, 1.4, 3.0, 7.0, 9.0, 1000.0 })
    {
      SCOPED_TRACE(testing::Message() << need << " after " << before << " times that");
      PoolSizing sizing;
      PlayFrame(sizing, static_cast<std::uint64_t>(need * before));
      for (int frame = 0; frame < PoolSizing::Window; ++frame)
      {
        PlayFrame(sizing, need);
      }
      EXPECT_GE(sizing.Capacity(), need);
      EXPECT_LE(sizing.Capacity(), need * 13 / 10 + 1);
      for (int frame = 0; frame < 200; ++frame)
      {
        EXPECT_EQ(PlayFrame(sizing, need), 0);
      }
    }
  }
}

TEST(PoolSizing, FarTooLargePoolShrinksAfterFourFrames)
{
  PoolSizing sizing;
  sizing.Grow(1 << 24);
  EXPECT_FALSE(sizing.EndFrame(80000));
  EXPECT_FALSE(sizing.EndFrame(160000));
  EXPECT_FALSE(sizing.EndFrame(80000));
  EXPECT_TRUE(sizing.EndFrame(80000));
  EXPECT_EQ(sizing.Capacity(), 180224u); // 160,000 * 1.125 as whole granules
}

// As where one heavy viewport and several light ones share a pass.
TEST(PoolSizing, HeavyFramesAmongManyLightOnesThrashOnceAtMost)
{
  for (int period = 5; period <= PoolSizing::Window; ++period)
  {
    SCOPED_TRACE(period);
    PoolSizing sizing;
    int changes = 0;
    for (int frame = 0; frame < 40 * PoolSizing::Window; ++frame)
    {
      changes += PlayFrame(sizing, frame % period == 0 ? 1000000 : 0);
    }
    EXPECT_LE(changes, 3); // grown, shrunk, and grown again for good
    EXPECT_GE(sizing.Capacity(), 1000000u);
    for (int frame = 0; frame < PoolSizing::Window; ++frame)
    {
      PlayFrame(sizing, 0);
    }
    EXPECT_EQ(sizing.Capacity(), 0u);
  }
}

TEST(PoolSizing, OneLargeFrameStartsTheCountAgain)
{
  PoolSizing sizing;
  sizing.Grow(1000000);
  const std::uint64_t size = sizing.Capacity();
  for (int frame = 0; frame < 1000; ++frame)
  {
    // Never four frames in a row under an eighth, never a window under 1/1.3.
    std::uint64_t used = frame % 4 == 3 ? size / 8 : 1000;
    used = frame % PoolSizing::Window == 0 ? size / 13 * 10 + 10 : used;
    EXPECT_FALSE(sizing.EndFrame(used)) << frame;
  }
  EXPECT_EQ(sizing.Capacity(), size);
}

TEST(PoolSizing, ChangeOfSizeStartsTheCountAgain)
{
  PoolSizing low;
  low.Grow(1000000);
  for (int frame = 1; frame < PoolSizing::Window; ++frame)
  {
    EXPECT_FALSE(low.EndFrame(400000));
  }
  low.SetLimit(600000);
  for (int frame = 1; frame < PoolSizing::Window; ++frame)
  {
    EXPECT_FALSE(low.EndFrame(400000)) << frame;
  }
  EXPECT_TRUE(low.EndFrame(400000));

  PoolSizing gross;
  gross.Grow(1000000);
  for (int frame = 1; frame < PoolSizing::GrossWindow; ++frame)
  {
    EXPECT_FALSE(gross.EndFrame(10000));
  }
  gross.SetLimit(600000);
  for (int frame = 1; frame < PoolSizing::GrossWindow; ++frame)
  {
    EXPECT_FALSE(gross.EndFrame(10000)) << frame;
  }
  EXPECT_TRUE(gross.EndFrame(10000));
}

TEST(PoolSizing, ShrinksToTheLargestUseOfTheWindow)
{
  PoolSizing sizing;
  sizing.Grow(1000000);
  for (int frame = 1; frame < PoolSizing::Window; ++frame)
  {
    EXPECT_FALSE(sizing.EndFrame(frame == 7 ? 640000 : 400000)) << frame;
  }
  EXPECT_TRUE(sizing.EndFrame(400000));
  EXPECT_EQ(sizing.Capacity(), 720896u); // 640,000 * 1.125 as whole granules
}

TEST(PoolSizing, SwingsWithinAWindowDoNotThrash)
{
  const std::uint64_t low = 500000;
  for (int period = 2; period <= PoolSizing::Window; ++period)
  {
    for (double swing : { 1.1, 1.3, 1.5, 1.99 })
    {
      SCOPED_TRACE(testing::Message() << "period " << period << ", swing " << swing);
      PoolSizing sizing;
      int changesOnceSettled = 0;
      int changes = 0;
      for (int frame = 0; frame < 40 * PoolSizing::Window; ++frame)
      {
        const double phase = 2 * 3.14159265358979 * frame / period;
        const auto used =
          static_cast<std::uint64_t>(low * (1 + (swing - 1) * (0.5 - 0.5 * std::cos(phase))));
        const int changed = PlayFrame(sizing, used);
        changes += changed;
        changesOnceSettled += frame >= 2 * PoolSizing::Window ? changed : 0;
      }
      EXPECT_LE(changes, 5);
      EXPECT_EQ(changesOnceSettled, 0);
    }
  }
}

TEST(PoolSizing, WhateverTheUseDoesTwoChangesInAWindowAreTheMostOnceWarm)
{
  const unsigned seed = 9;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE(trial);
    PoolSizing sizing;
    std::vector<int> changes;
    std::uint64_t used = 600000;
    for (int frame = 0; frame < 2000; ++frame)
    {
      if (random() % (1 + trial) == 0)
      {
        used = random() % 2 ? 500000 : 999999;
      }
      changes.push_back(PlayFrame(sizing, used));
    }
    for (std::size_t first = PoolSizing::Window; first + PoolSizing::Window <= changes.size();
         ++first)
    {
      int inWindow = 0;
      for (int i = 0; i < PoolSizing::Window; ++i)
      {
        inWindow += changes[first + i];
      }
      ASSERT_LE(inWindow, 2) << first;
    }
  }
}

TEST(PoolSizing, NumbersNearTheTopDoNotWrap)
{
  PoolSizing sizing;
  EXPECT_TRUE(sizing.Grow(most - 5000));
  EXPECT_EQ(sizing.Capacity(), most);
  EXPECT_TRUE(sizing.Grow(most));
  EXPECT_FALSE(sizing.EndFrame(most));
  for (int frame = 0; frame < PoolSizing::Window; ++frame)
  {
    sizing.EndFrame(most / 2);
  }
  EXPECT_GE(sizing.Capacity(), most / 2);
  EXPECT_LT(sizing.Capacity(), most / 10 * 6);
}

}
