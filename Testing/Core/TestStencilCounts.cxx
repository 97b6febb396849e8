// Where the pixels lie that have so many fragments.
#include "Core/lists/StencilCounts.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

void ExpectRegion(const vitrine::PixelRegion& region, int x, int y, int width, int height)
{
  EXPECT_EQ(region.X, x);
  EXPECT_EQ(region.Y, y);
  EXPECT_EQ(region.Width, width);
  EXPECT_EQ(region.Height, height);
}

TEST(CountedRegions, AreEmptyWithoutPixels)
{
  EXPECT_TRUE(vitrine::CountedRegions().Around(0).IsEmpty());
  const vitrine::CountedRegions regions({ 0, 0, 3, 0 }, 2);
  EXPECT_TRUE(regions.Around(4).IsEmpty());
  EXPECT_TRUE(regions.Around(1, 2).IsEmpty());
  EXPECT_TRUE(regions.Around(300, 400).IsEmpty());
}

TEST(CountedRegions, AreTheSmallestAround)
{
  const std::vector<std::uint8_t> counts = {
    0,
    0,
    5,
    0, //
    0,
    9,
    0,
    0, //
    0,
    0,
    0,
    255,
  };
  const vitrine::CountedRegions regions(counts, 4);
  ExpectRegion(regions.Around(1), 1, 0, 3, 3);
  ExpectRegion(regions.Around(5), 1, 0, 3, 3);
  ExpectRegion(regions.Around(6), 1, 1, 3, 2);
  ExpectRegion(regions.Around(10), 3, 2, 1, 1);
  ExpectRegion(regions.Around(1, 9), 1, 0, 2, 2);
  ExpectRegion(regions.Around(-3, 0), 0, 0, 4, 3);
}

TEST(CountedRegions, HoldAllPixelsTheyAreAsked)
{
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round)
  {
    const int width = 1 + static_cast<int>(random() % 9);
    const int height = 1 + static_cast<int>(random() % 9);
    std::vector<std::uint8_t> counts(static_cast<std::size_t>(width * height));
    for (std::uint8_t& count : counts)
    {
      count = static_cast<std::uint8_t>(random() % 8 ? 0 : random());
    }
    const vitrine::CountedRegions regions(counts, width);
    const int first = static_cast<int>(random() % 256);
    const int last = first + static_cast<int>(random() % 100);
    const vitrine::PixelRegion region = regions.Around(first, last);
    bool touches[4] = { false, false, false, false };
    for (int i = 0; i < width * height; ++i)
    {
      const int count = counts[static_cast<std::size_t>(i)];
      if (count < first || count > last)
      {
        continue;
      }
      const int x = i % width;
      const int y = i / width;
      ASSERT_TRUE(x >= region.X && x < region.X + region.Width);
      ASSERT_TRUE(y >= region.Y && y < region.Y + region.Height);
      touches[0] = touches[0] || x == region.X;
      touches[1] = touches[1] || y == region.Y;
      touches[2] = touches[2] || x == region.X + region.Width - 1;
      touches[3] = touches[3] || y == region.Y + region.Height - 1;
    }
    for (const bool touched : touches)
    {
      EXPECT_NE(touched, region.IsEmpty());
    }
  }
}

}
