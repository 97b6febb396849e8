#include "NonFinite.h"

#include "Core/geometry/SampleGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using vitrine::LaneCount;
using vitrine::Lanes;
using vitrine::SampleGrid;

/** A grid, and where its samples are. */
struct Kind
{
  SampleGrid Grid;
  int PerColumn;
  float Offset; ///< of the first one

  double SampleAt(int i) const { return (i + double{ this->Offset }) / this->PerColumn; }
};

std::vector<Kind> AllKinds()
{
  std::vector<Kind> kinds;
  for (int pixels = 1; pixels <= 24; ++pixels)
  {
    kinds.push_back({ SampleGrid::AtCentres(pixels), pixels, 0.5f });
    kinds.push_back({ SampleGrid::InCells(pixels, 2), pixels, 0.5f });
  }
  return kinds;
}

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

TEST(SampleGrid, IsAwayFromTheSidesOfLines)
{
  EXPECT_EQ(SampleGrid::AtCentres(1).Inset(), 0.5f);
  EXPECT_EQ(SampleGrid::AtCentres(2).Inset(), 0.25f);
  EXPECT_EQ(SampleGrid::AtCentres(4).Inset(), 0.125f);
}

TEST(SampleGrid, OfCellsIsThatOfSmallerPixels)
{
  const SampleGrid thin = SampleGrid::InCells(1, 4), thick = SampleGrid::InCells(8, 4);
  EXPECT_TRUE(thin.HasOneRowPerLine());
  EXPECT_EQ(thin.LinesPerPixel(), 4);
  EXPECT_EQ(thin.PixelSize(), 4.0f);
  EXPECT_EQ(thick.PixelSize(), 0.5f);
  EXPECT_EQ(SampleGrid::AtCentres(4).PixelSize(), 0.25f);
  EXPECT_EQ(SampleGrid().PixelSize(), 1.0f);
  EXPECT_EQ(thin.BinaryPixelsPerColumn(), 1);
  EXPECT_EQ(thick.Inset(), 0.0625f);
  EXPECT_EQ(thick.LinesPerPixel(), 1);
  EXPECT_FALSE(thin.HasOneSamplePerPixel() || thick.HasOneSamplePerPixel());
  EXPECT_TRUE(SampleGrid::AtCentres(1).HasOneSamplePerPixel());
  EXPECT_TRUE(SampleGrid::AtCentres(3).HasOneSamplePerPixel());
  EXPECT_FALSE(SampleGrid().HasOneSamplePerPixel()) << "who knows";
}

TEST(SampleGrid, HasOneRowOnALineOfPixelsWithOneSample)
{
  EXPECT_TRUE(SampleGrid::AtCentres(1).HasOneRowPerLine());
  EXPECT_FALSE(SampleGrid::AtCentres(2).HasOneRowPerLine());
  EXPECT_FALSE(SampleGrid::InCells(16, 4).HasOneRowPerLine());
  EXPECT_FALSE(SampleGrid().HasOneRowPerLine());
}

TEST(SampleGrid, IsAsWideAsFromOneSampleToTheNext)
{
  EXPECT_EQ(SampleGrid().Width(), 0.0f);
  for (const SampleGrid& grid : { SampleGrid::AtCentres(1), SampleGrid::AtCentres(4),
         SampleGrid::InCells(8, 4), SampleGrid::AtCentres(3) })
  {
    const float sample = grid.From(7.1f);
    EXPECT_EQ(grid.Behind(sample), sample + grid.Width());
    EXPECT_NEAR(grid.From(sample + 1e-3f), grid.Behind(sample), 1e-5f);
  }
  EXPECT_EQ(SampleGrid::AtCentres(4).Width(), 0.25f);
  EXPECT_EQ(SampleGrid::InCells(8, 4).Width(), 0.125f);
}

TEST(SampleGrid, GoesFromAPlaceToTheNextSampleOnEitherSide)
{
  const SampleGrid centres1 = SampleGrid::AtCentres(1), centres2 = SampleGrid::AtCentres(2),
                   centres4 = SampleGrid::AtCentres(4);
  const struct
  {
    SampleGrid Grid;
    float Place, From, UpTo;
  } cases[] = {
    { centres1, 0.0f, 0.5f, -0.5f },
    { centres1, 0.5f, 0.5f, 0.5f }, // a centre is both
    { centres1, 0.51f, 1.5f, 0.5f },
    { centres1, 7.0f, 7.5f, 6.5f },
    { centres2, 0.0f, 0.25f, -0.25f },
    { centres2, 3.3f, 3.75f, 3.25f },
    { centres2, 3.75f, 3.75f, 3.75f },
    { centres4, 3.0f, 3.125f, 2.875f },
    { centres4, 3.2f, 3.375f, 3.125f },
    { centres1, -0.2f, 0.5f, -0.5f },
    { centres1, -3.5f, -3.5f, -3.5f },
    { centres1, -3.6f, -3.5f, -4.5f },
    { centres4, -0.2f, -0.125f, -0.375f },
  };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Place);
    EXPECT_EQ(one.Grid.From(one.Place), one.From);
    EXPECT_EQ(one.Grid.UpTo(one.Place), one.UpTo);
  }
}

TEST(SampleGrid, LeavesNoSampleOut)
{
  std::mt19937 random(1);
  for (const Kind& kind : AllKinds())
  {
    SCOPED_TRACE(kind.PerColumn);
    for (int i = 0; i < 4000; ++i)
    {
      const double exact = kind.SampleAt(static_cast<int>(random() % 8192) - 500);
      const float sample = static_cast<float>(exact);
      const float aside = std::ldexp(1.0f, -static_cast<int>(random() % 24));
      for (const float place : { sample, sample - aside, sample + aside,
             std::nextafter(sample, -1e9f), std::nextafter(sample, 1e9f) })
      {
        if (double{ place } <= exact)
        {
          EXPECT_LE(kind.Grid.From(place), sample);
        }
        if (double{ place } >= exact)
        {
          EXPECT_GE(kind.Grid.UpTo(place), sample);
        }
      }
    }
  }
}

TEST(SampleGrid, KeepsSamplesWhereTheyAre)
{
  for (const Kind& kind : AllKinds())
  {
    for (int i = -100; i < 4096; ++i)
    {
      const float sample =
        (static_cast<float>(i) + kind.Offset) / static_cast<float>(kind.PerColumn);
      ASSERT_EQ(kind.Grid.From(sample), sample) << i << " of " << kind.PerColumn;
      ASSERT_EQ(kind.Grid.UpTo(sample), sample) << i << " of " << kind.PerColumn;
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

TEST(SampleGrid, MayHaveSamplesWhereThereIsOne)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<float> place(-20.0f, 500.0f), length(0.0f, 2.0f);
  int without = 0;
  for (const Kind& kind : AllKinds())
  {
    for (int i = 0; i < 3000; ++i)
    {
      const float from = place(random), to = from + length(random) / kind.PerColumn;
      const float first = std::max(kind.Grid.From(from), 0.0f);
      const bool hasSampleOnScreen = first > 0.0f && first <= kind.Grid.UpTo(to);
      const bool mayHaveAny = MayHaveAny(kind.Grid, from, to);
      ASSERT_TRUE(mayHaveAny || !hasSampleOnScreen) << from << " to " << to;
      without += !mayHaveAny;
    }
    for (int i = 1; i < 2000; ++i)
    {
      const auto at = static_cast<float>(kind.SampleAt(i));
      ASSERT_TRUE(MayHaveAny(kind.Grid, at, at)) << at;
    }
  }
  EXPECT_GT(without, 10000);
}

// So many that integers would not hold their numbers.
TEST(SampleGrid, MayHaveSamplesFarOffWhereLinesAreThick)
{
  const SampleGrid grid = SampleGrid::AtCentres(10000);
  for (const float from : { 10.0f, 1e5f, 2.1e5f, 5e5f, 1e6f, 1e9f })
  {
    EXPECT_TRUE(MayHaveAny(grid, from, 1.01f * from)) << from;
  }
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
