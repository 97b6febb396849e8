#include "Core/lists/ScreenBands.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{

using vitrine::BandPlan;
using vitrine::CoveringBands;
using vitrine::PixelRegion;
using vitrine::PlanBands;

std::uint64_t SumOver(const std::vector<std::uint32_t>& need, int width, const PixelRegion& rect)
{
  std::uint64_t sum = 0;
  for (int y = rect.Y; y < rect.Y + rect.Height; ++y)
  {
    for (int x = rect.X; x < rect.X + rect.Width; ++x)
    {
      sum += need[static_cast<std::size_t>(y) * width + x];
    }
  }
  return sum;
}

// Covering bands hold every pixel of the region once, and the needs of the bands that they are made of.
void ExpectWholeCover(const std::vector<PixelRegion>& bands, const std::vector<std::uint32_t>& need,
  int width, int height, std::uint64_t capacity, const PixelRegion& region)
{
  std::vector<int> covered(need.size());
  for (const PixelRegion& band : bands)
  {
    EXPECT_LE(SumOver(need, width, band), capacity);
    for (int y = band.Y; y < band.Y + band.Height; ++y)
    {
      for (int x = band.X; x < band.X + band.Width; ++x)
      {
        ++covered[static_cast<std::size_t>(y) * width + x];
      }
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const bool isInside = x >= region.X && x - region.X < region.Width && y >= region.Y &&
        y - region.Y < region.Height;
      ASSERT_EQ(covered[static_cast<std::size_t>(y) * width + x], isInside ? 1 : 0)
        << x << ", " << y;
    }
  }
}

// All that a plan that fits promises: bounds, capacity, no empty band, each needy pixel once.
void ExpectExactCover(const BandPlan& plan, const std::vector<std::uint32_t>& need, int width,
  int height, std::uint64_t capacity, const PixelRegion& region)
{
  ASSERT_TRUE(plan.Fits);
  std::vector<int> covered(need.size());
  for (const PixelRegion& band : plan.Bands)
  {
    ASSERT_GE(band.X, 0);
    ASSERT_GE(band.Y, 0);
    ASSERT_GT(band.Width, 0);
    ASSERT_GT(band.Height, 0);
    ASSERT_LE(band.X + band.Width, width);
    ASSERT_LE(band.Y + band.Height, height);
    const std::uint64_t sum = SumOver(need, width, band);
    EXPECT_GT(sum, 0u);
    EXPECT_LE(sum, capacity);
    for (int y = band.Y; y < band.Y + band.Height; ++y)
    {
      for (int x = band.X; x < band.X + band.Width; ++x)
      {
        ++covered[static_cast<std::size_t>(y) * width + x];
      }
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      const bool isInside = x >= region.X && x - region.X < region.Width && y >= region.Y &&
        y - region.Y < region.Height;
      if (need[pixel] > 0 || !isInside)
      {
        ASSERT_EQ(covered[pixel], isInside ? 1 : 0) << x << ", " << y;
      }
      ASSERT_LE(covered[pixel], 1) << x << ", " << y;
    }
  }
}

TEST(ScreenBands, PictureWithoutPixelsFitsAnywhere)
{
  for (const auto& [width, height] : { std::pair(0, 0), std::pair(0, 7), std::pair(7, 0) })
  {
    const BandPlan plan = PlanBands({}, width, height, 0);
    EXPECT_TRUE(plan.Fits);
    EXPECT_TRUE(plan.Bands.empty());
    EXPECT_EQ(plan.LargestPixel, 0u);
  }
}

TEST(ScreenBands, PictureWithoutNeedHasNoBands)
{
  const BandPlan plan = PlanBands(std::vector<std::uint32_t>(12, 0), 4, 3, 0);
  EXPECT_TRUE(plan.Fits);
  EXPECT_TRUE(plan.Bands.empty());
}

TEST(ScreenBands, WhatFitsAtOnceIsOneBandAroundTheNeed)
{
  std::vector<std::uint32_t> need(10 * 8, 0);
  need[2 * 10 + 3] = 5;
  need[6 * 10 + 7] = 5;
  const BandPlan plan = PlanBands(need, 10, 8, 10);
  ASSERT_EQ(plan.Bands.size(), 1u);
  EXPECT_EQ(plan.Bands[0].X, 3);
  EXPECT_EQ(plan.Bands[0].Y, 2);
  EXPECT_EQ(plan.Bands[0].Width, 5);
  EXPECT_EQ(plan.Bands[0].Height, 5);
  EXPECT_EQ(plan.LargestPixel, 5u);
}

TEST(ScreenBands, OneUnitLessThanNeededCutsInTwo)
{
  const std::vector<std::uint32_t> need(4 * 4, 3);
  EXPECT_EQ(PlanBands(need, 4, 4, 48).Bands.size(), 1u);
  const BandPlan plan = PlanBands(need, 4, 4, 47);
  ASSERT_EQ(plan.Bands.size(), 2u);
  EXPECT_EQ(plan.Bands[0].Height, 3);
  EXPECT_EQ(plan.Bands[1].Height, 1);
}

TEST(ScreenBands, RowTooLargeIsCutAlongX)
{
  const std::vector<std::uint32_t> need(8 * 2, 2);
  const BandPlan plan = PlanBands(need, 8, 2, 7); // 3 pixels each: 3 + 3 + 2 in either row
  ExpectExactCover(plan, need, 8, 2, 7, { 0, 0, 8, 2 });
  EXPECT_EQ(plan.Bands.size(), 6u);
}

TEST(ScreenBands, CapacityOfOnePixelMakesBandsOfOnePixel)
{
  const std::vector<std::uint32_t> need(5 * 3, 9);
  const BandPlan plan = PlanBands(need, 5, 3, 9);
  ExpectExactCover(plan, need, 5, 3, 9, { 0, 0, 5, 3 });
  EXPECT_EQ(plan.Bands.size(), 15u);
}

TEST(ScreenBands, PixelAboveTheCapacityIsReportedNotDropped)
{
  std::vector<std::uint32_t> need(6 * 6, 1);
  need[20] = 100;
  const BandPlan plan = PlanBands(need, 6, 6, 99);
  EXPECT_FALSE(plan.Fits);
  EXPECT_EQ(plan.LargestPixel, 100u);
  EXPECT_TRUE(plan.Bands.empty());
  EXPECT_TRUE(PlanBands(need, 6, 6, 100).Fits);
  EXPECT_FALSE(PlanBands(need, 6, 6, 0).Fits);
}

TEST(ScreenBands, SumsDoNotWrapAt32Bits)
{
  const std::uint32_t huge = std::numeric_limits<std::uint32_t>::max();
  const std::vector<std::uint32_t> need(16, huge);
  EXPECT_EQ(PlanBands(need, 4, 4, std::uint64_t{ huge } * 16).Bands.size(), 1u);
  const std::uint64_t fiveAtMost = std::uint64_t{ huge } * 5;
  const BandPlan plan = PlanBands(need, 4, 4, fiveAtMost);
  ExpectExactCover(plan, need, 4, 4, fiveAtMost, { 0, 0, 4, 4 });
  EXPECT_EQ(plan.Bands.size(), 4u);
  EXPECT_EQ(PlanBands(need, 4, 4, std::numeric_limits<std::uint64_t>::max()).Bands.size(), 1u);
}

TEST(ScreenBands, RandomPicturesAreCoveredExactly)
{
  const unsigned seed = 1905;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 400; ++trial)
  {
    SCOPED_TRACE(trial);
    const int width = 1 + random() % 40;
    const int height = 1 + random() % 40;
    const unsigned sparsity = 1 + random() % 20;
    std::vector<std::uint32_t> need(static_cast<std::size_t>(width) * height);
    std::uint64_t total = 0;
    for (std::uint32_t& value : need)
    {
      value = random() % sparsity == 0 ? random() % 50 : 0;
      total += value;
    }
    const std::uint64_t capacity = 50 + random() % 2000;
    const BandPlan plan = PlanBands(need, width, height, capacity);
    ExpectExactCover(plan, need, width, height, capacity, { 0, 0, width, height });
    const std::vector<PixelRegion> covering = CoveringBands(plan.Bands, { 0, 0, width, height });
    ExpectWholeCover(covering, need, width, height, capacity, { 0, 0, width, height });
    EXPECT_EQ(covering.size(), total > 0 ? plan.Bands.size() : 1u);
    // A pair of neighbours overflows unless an overlarge row, at most total / capacity of them,
    // lies between.
    EXPECT_LE(plan.Bands.size(), 1 + 4 * total / capacity);
  }
}

TEST(ScreenBands, RegionIsClippedAndTheRestLeftOut)
{
  const unsigned seed = 77;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<std::uint32_t> need(20 * 15);
  for (std::uint32_t& value : need)
  {
    value = random() % 9;
  }
  need[0] = 1000; // outside each region that begins at 1 or later
  const int most = std::numeric_limits<int>::max();
  for (const PixelRegion& region : { PixelRegion{ 3, 4, 9, 5 }, PixelRegion{ 1, 1, most, most },
         PixelRegion{ 19, 14, 1, 1 }, PixelRegion{ 5, 5, 0, 3 }, PixelRegion{ 30, 30, 5, 5 },
         PixelRegion{ 5, 5, -2, 3 }, PixelRegion{ -5, 1, 10, 10 } })
  {
    const BandPlan plan = PlanBands(need, 20, 15, 60, region);
    ExpectExactCover(plan, need, 20, 15, 60, region);
    EXPECT_LE(plan.LargestPixel, 8u);
  }
  const PixelRegion inner = { 3, 4, 9, 5 };
  const BandPlan plan = PlanBands(need, 20, 15, 60, inner);
  ExpectWholeCover(CoveringBands(plan.Bands, inner), need, 20, 15, 60, inner);
  EXPECT_FALSE(PlanBands(need, 20, 15, 60, { -1, -1, 2, 2 }).Fits);
}

}
