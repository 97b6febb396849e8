#include "NonFinite.h"

#include "Core/culling/SampleGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using vitrine::LaneCount;
using vitrine::Lanes;
using vitrine::SampleGrid;

}

TEST(SampleGrid, OfSamplesAnywhereLeavesPlacesWhereTheyAre)
{
  const SampleGrid anywhere;
  EXPECT_EQ(anywhere.Inset(), 0.0f);
  for (const float place : { -1e30f, -3.7f, -0.5f, 0.0f, 0.25f, 17.3f, 1e30f })
  {
    EXPECT_EQ(anywhere.From(place), place);
    EXPECT_EQ(anywhere.UpTo(place), place);
  }
}

TEST(SampleGrid, IsHalfAPixelFromTheSidesOfLines)
{
  EXPECT_EQ(SampleGrid::AtCentres(1).Inset(), 0.5f);
  EXPECT_EQ(SampleGrid::AtCentres(2).Inset(), 0.25f);
  EXPECT_EQ(SampleGrid::AtCentres(4).Inset(), 0.125f);
}

TEST(SampleGrid, GoesFromAPlaceToTheNextCentreOnEitherSide)
{
  const struct
  {
    int PixelsPerLine;
    float Place, From, UpTo;
  } cases[] = {
    { 1, 0.0f, 0.5f, -0.5f },
    { 1, 0.5f, 0.5f, 0.5f }, // a centre is both
    { 1, 0.51f, 1.5f, 0.5f },
    { 1, 7.0f, 7.5f, 6.5f },
    { 2, 0.0f, 0.25f, -0.25f },
    { 2, 3.3f, 3.75f, 3.25f },
    { 2, 3.75f, 3.75f, 3.75f },
    { 4, 3.0f, 3.125f, 2.875f },
    { 4, 3.2f, 3.375f, 3.125f },
    { 1, -0.2f, 0.5f, -0.5f },
    { 1, -3.5f, -3.5f, -3.5f },
    { 1, -3.6f, -3.5f, -4.5f },
    { 4, -0.2f, -0.125f, -0.375f },
  };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Place);
    const SampleGrid grid = SampleGrid::AtCentres(one.PixelsPerLine);
    EXPECT_EQ(grid.From(one.Place), one.From);
    EXPECT_EQ(grid.UpTo(one.Place), one.UpTo);
  }
}

TEST(SampleGrid, LeavesNoCentreOut)
{
  std::mt19937 random(1);
  for (const int pixels : { 1, 2, 3, 4, 7, 8 })
  {
    SCOPED_TRACE(pixels);
    const SampleGrid grid = SampleGrid::AtCentres(pixels);
    for (int i = 0; i < 4000; ++i)
    {
      const double exact = (static_cast<int>(random() % 8192) - 500 + 0.5) / pixels;
      const float centre = static_cast<float>(exact);
      const float aside = std::ldexp(1.0f, -static_cast<int>(random() % 24));
      for (const float place : { centre, centre - aside, centre + aside,
             std::nextafter(centre, -1e9f), std::nextafter(centre, 1e9f) })
      {
        if (double{ place } <= exact)
        {
          EXPECT_LE(grid.From(place), centre);
        }
        if (double{ place } >= exact)
        {
          EXPECT_GE(grid.UpTo(place), centre);
        }
      }
    }
  }
}

TEST(SampleGrid, KeepsCentresWhereTheyAre)
{
  for (int pixels = 1; pixels <= 16; ++pixels)
  {
    const SampleGrid grid = SampleGrid::AtCentres(pixels);
    for (int i = -100; i < 4096; ++i)
    {
      const float centre = (static_cast<float>(i) + 0.5f) / static_cast<float>(pixels);
      ASSERT_EQ(grid.From(centre), centre) << i << " of " << pixels;
      ASSERT_EQ(grid.UpTo(centre), centre) << i << " of " << pixels;
    }
  }
}

TEST(SampleGrid, OfPlacesFarAwayOrOfNoneIsThere)
{
  const SampleGrid grid = SampleGrid::AtCentres(2);
  for (const float place : { 1e7f, 1e15f, 1e30f, -1e7f, -1e15f, -1e30f })
  {
    EXPECT_NEAR(grid.From(place) / place, 1.0f, 1e-6f);
    EXPECT_NEAR(grid.UpTo(place) / place, 1.0f, 1e-6f);
  }
  EXPECT_EQ(grid.From(Infinity), Infinity);
  EXPECT_EQ(grid.UpTo(-Infinity), -Infinity);
  EXPECT_TRUE(std::isnan(grid.From(NotANumber)));
  EXPECT_TRUE(std::isnan(grid.UpTo(NotANumber)));
}

namespace
{

/** Of one pair of places, among others that have samples or none. */
bool MayHaveAny(const SampleGrid& grid, float from, float to)
{
  Lanes froms{}, tos{};
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    froms[lane] = lane == 3 ? from : static_cast<float>(lane);
    tos[lane] = lane == 3 ? to : static_cast<float>(lane) + 0.6f;
  }
  return (grid.MayHaveAny(froms, tos) >> 3 & 1u) != 0;
}

}

TEST(SampleGrid, MayHaveSamplesWhereThereIsACentre)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<float> place(-20.0f, 500.0f), length(0.0f, 2.0f);
  int without = 0;
  for (const int pixelsPerLine : { 1, 2, 4 })
  {
    const SampleGrid grid = SampleGrid::AtCentres(pixelsPerLine);
    for (int i = 0; i < 20000; ++i)
    {
      const float from = place(random), to = from + length(random) / pixelsPerLine;
      const bool hasCentreOnScreen = std::max(grid.From(from), 0.0f) <= grid.UpTo(to);
      const bool mayHaveAny = MayHaveAny(grid, from, to);
      ASSERT_TRUE(mayHaveAny || !hasCentreOnScreen) << from << " to " << to;
      without += !mayHaveAny;
    }
    for (int centre = 0; centre < 2000; ++centre)
    {
      const float at = (static_cast<float>(centre) + 0.5f) / static_cast<float>(pixelsPerLine);
      ASSERT_TRUE(MayHaveAny(grid, at, at)) << at;
    }
  }
  EXPECT_GT(without, 10000);
}

TEST(SampleGrid, MayHaveSamplesAnywhereAndInWhatIsNoNumber)
{
  EXPECT_TRUE(MayHaveAny(SampleGrid(), 0.1f, 0.1f));
  const SampleGrid grid = SampleGrid::AtCentres(1);
  EXPECT_FALSE(MayHaveAny(grid, 0.1f, 0.2f));
  EXPECT_FALSE(MayHaveAny(grid, -7.0f, -0.3f)) << "beyond the screen";
  EXPECT_FALSE(MayHaveAny(grid, -Infinity, 0.2f));
  EXPECT_TRUE(MayHaveAny(grid, -Infinity, 0.6f));
  EXPECT_TRUE(MayHaveAny(grid, 0.1f, Infinity));
  EXPECT_TRUE(MayHaveAny(grid, NotANumber, 0.2f));
  EXPECT_TRUE(MayHaveAny(grid, 0.1f, NotANumber));
  EXPECT_TRUE(MayHaveAny(grid, 0.1f, 1e30f));
}
