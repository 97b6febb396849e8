// What an s-buffer hides where samples are at centres of pixels alone, and what it says of whole tiles.

#include "NonFinite.h"

#include "Core/culling/buffer/SBuffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{

using vitrine::HideableSegment;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::ScreenRectangle;

/** Of 40 columns and 4 lines. */
SBuffer BufferOf(const SampleGrid& samples)
{
  return SBuffer(40, 4, samples, 1u << 12);
}

/**
 * Returns true if nearer spans cover all samples in a rectangle. There are `perColumn` samples per column and per line.
 * The first one is at `offset` of the spacing.
 */
bool AreSamplesHidden(
  const SBuffer& buffer, int perColumn, float offset, const ScreenRectangle& rectangle)
{
  for (int j = 0; j < buffer.Lines() * perColumn; ++j)
  {
    const float y = (static_cast<float>(j) + offset) / static_cast<float>(perColumn);
    for (int i = 0; i < buffer.Columns() * perColumn; ++i)
    {
      const float x = (static_cast<float>(i) + offset) / static_cast<float>(perColumn);
      if (rectangle.Left <= x && x <= rectangle.Right && rectangle.Bottom <= y &&
        y <= rectangle.Top)
      {
        bool isHidden = false;
        for (const vitrine::Span& span : buffer.SpansOf(static_cast<int>(y)))
        {
          isHidden =
            isHidden || (span.Left <= x && x <= span.Right && span.DepthAt(x) > rectangle.Nearest);
        }
        if (!isHidden)
        {
          return false;
        }
      }
    }
  }
  return true;
}

/** Whether nothing on line 1 hides a segment at a place. */
bool IsShownAt(const SBuffer& buffer, const HideableSegment& segment, float x)
{
  const std::vector<vitrine::Span> spans = buffer.SpansOf(1);
  return segment.Left <= x && x <= segment.Right &&
    std::none_of(spans.begin(), spans.end(),
      [&](const vitrine::Span& span)
      { return span.Left <= x && x <= span.Right && span.DepthAt(x) > segment.NearestAt(x); });
}

/** The first centre where it shows; below 0 if it is hidden at all. */
float FirstShown(const SBuffer& buffer, int pixels, const HideableSegment& segment)
{
  for (int i = 0; i < buffer.Columns() * pixels; ++i)
  {
    const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(pixels);
    if (IsShownAt(buffer, segment, x))
    {
      return x;
    }
  }
  return -1.0f;
}

}

TEST(SBufferSamples, NothingShowsBetweenCentres)
{
  SBuffer one = BufferOf(SampleGrid::AtCentres(1));
  EXPECT_TRUE(one.Hides({ 3.6f, 4.4f, 0.0f, 4.0f, 0.9f })) << "between columns";
  EXPECT_TRUE(one.Hides({ 3.0f, 9.0f, 1.6f, 2.4f, 0.9f })) << "between lines";
  EXPECT_TRUE(one.Hides({ 3.6f, 4.4f, 1.6f, 2.4f, 0.9f }));
  EXPECT_TRUE(one.Hides({ 39.6f, 45.0f, 0.0f, 4.0f, 0.9f })) << "behind the last column";
  EXPECT_TRUE(one.Hides({ -2.0f, 0.4f, 0.0f, 4.0f, 0.9f })) << "before the first one";
  EXPECT_FALSE(one.Hides({ 3.4f, 3.6f, 1.4f, 1.6f, 0.9f }));
  SBuffer two = BufferOf(SampleGrid::AtCentres(2));
  EXPECT_TRUE(two.Hides({ 3.3f, 3.7f, 0.0f, 4.0f, 0.9f }));
  EXPECT_FALSE(two.Hides({ 3.6f, 4.4f, 0.0f, 4.0f, 0.9f }));
  SBuffer anywhere = BufferOf({});
  EXPECT_FALSE(anywhere.Hides({ 3.6f, 3.60001f, 1.6f, 1.60001f, 0.9f }));
}

TEST(SBufferSamples, OneCentreIsLookedAt)
{
  for (const int pixels : { 0, 1, 2, 4 })
  {
    SCOPED_TRACE(pixels);
    const SampleGrid grid = pixels == 0 ? SampleGrid() : SampleGrid::AtCentres(pixels);
    const float y = grid.From(1.1f);
    for (const float from : { 0.0f, 4.1f, 7.4f, 8.0f, 20.3f, 39.2f })
    {
      SCOPED_TRACE(from);
      SBuffer buffer = BufferOf(grid);
      const float x = grid.From(from);
      const ScreenRectangle place{ x, x, y, y, 0.4f };
      EXPECT_FALSE(buffer.Hides(place)) << "nothing is there";
      buffer.Insert(1, { x + 0.01f, x + 3.0f, 0.5f, 0.5f, 0 });
      buffer.Insert(1, { x - 3.0f, x - 0.01f, 0.5f, 0.5f, 0 });
      EXPECT_FALSE(buffer.Hides(place)) << "it stands beside";
      buffer.Insert(1, { x - 1.0f, x + 1.0f, 0.3f, 0.3f, 0 });
      EXPECT_FALSE(buffer.Hides(place)) << "it stands behind";
      buffer.Insert(1, { x - 1.0f, x + 1.0f, 0.5f, 0.5f, 0 });
      EXPECT_TRUE(buffer.Hides(place));
    }
  }
}

TEST(SBufferSamples, OnlyCentresNeedBeCovered)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 3.45f, 6.55f, 0.5f, 0.5f, 0 });
  EXPECT_TRUE(buffer.Hides({ 2.6f, 7.4f, 0.6f, 2.4f, 0.4f }));
  EXPECT_FALSE(buffer.Hides({ 2.4f, 7.4f, 0.6f, 2.4f, 0.4f }));
  EXPECT_FALSE(buffer.Hides({ 2.6f, 7.6f, 0.6f, 2.4f, 0.4f }));
  EXPECT_FALSE(buffer.Hides({ 2.6f, 7.4f, 0.4f, 2.4f, 0.4f }));
  EXPECT_FALSE(buffer.Hides({ 2.6f, 7.4f, 0.6f, 2.6f, 0.4f }));
}

TEST(SBufferSamples, GapsBetweenCentresHideNothingLess)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 0.0f, 2.9f, 0.5f, 0.5f, 0 });
  buffer.Insert(1, { 3.1f, 8.0f, 0.5f, 0.5f, 0 });
  EXPECT_TRUE(buffer.Hides({ 2.2f, 3.8f, 1.2f, 1.8f, 0.4f })) << "part of a tile";
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 0, 0.5f)) << "a whole one";
  buffer.Insert(2, { 0.0f, 2.45f, 0.5f, 0.5f, 0 });
  buffer.Insert(2, { 2.55f, 8.0f, 0.5f, 0.5f, 0 });
  EXPECT_FALSE(buffer.Hides({ 2.2f, 3.8f, 2.2f, 2.8f, 0.4f })) << "a centre lies in it";
  EXPECT_FALSE(buffer.IsCoveredBefore(2, 0, 0.1f));
}

TEST(SBufferSamples, WhatIsFartherBetweenCentresDoesNotShow)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 0.0f, 8.0f, 0.2f, 0.2f, 0 });
  buffer.Insert(1, { 0.0f, 2.9f, 0.5f, 0.5f, 0 });
  buffer.Insert(1, { 3.1f, 8.0f, 0.5f, 0.5f, 0 });
  ASSERT_GT(buffer.SpansOf(1).size(), 3u) << "what is farther is there";
  EXPECT_TRUE(buffer.Hides({ 2.2f, 3.8f, 1.2f, 1.8f, 0.4f }));
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 0, 0.5f));
}

TEST(SBufferSamples, WhatSlantsCountsAsFarAsTheLastCentre)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 0.0f, 4.0f, 0.8f, 0.4f, 0 }); // 0.75 at the first centre, 0.45 at the last one
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 0, 0.449f));
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 0, 0.451f));
}

TEST(SBufferSamples, SegmentsBetweenCentresAreLeftOut)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 2.6f, 3.4f, 0.5f, 0.5f, 0 });
  EXPECT_TRUE(buffer.SpansOf(1).empty());
  EXPECT_EQ(buffer.Counts().Inserted, 0u);
  buffer.Insert(1, { 2.5f, 2.51f, 0.5f, 0.5f, 0 });
  EXPECT_TRUE(buffer.Hides({ 2.2f, 2.8f, 1.2f, 1.8f, 0.4f })) << "a centre lies on its end";
}

TEST(SBufferSamples, WhatIsHiddenIsWhatIsHiddenAtEveryCentre)
{
  std::mt19937 random(3);
  const auto between = [&](float least, float greatest)
  { return least + (greatest - least) * (static_cast<float>(random()) / 4294967296.0f); };
  int hidden = 0;
  for (int round = 0; round < 1500; ++round)
  {
    const int pixels = static_cast<int>(1 + random() % 8);
    SBuffer buffer = BufferOf(SampleGrid::AtCentres(pixels));
    for (int i = 0; i < 24; ++i)
    {
      const float left = between(-2.0f, 40.0f);
      buffer.Insert(static_cast<int>(random() % 4),
        { left, left + between(0.1f, 20.0f), between(0.1f, 0.9f), between(0.1f, 0.9f), 0 });
    }
    for (int i = 0; i < 10; ++i)
    {
      const float left = between(-1.0f, 40.0f), bottom = between(-1.0f, 4.0f);
      const ScreenRectangle rectangle{ left, left + between(0.0f, 3.0f), bottom,
        bottom + between(0.0f, 1.5f), between(0.0f, 0.9f) };
      const bool isHidden = AreSamplesHidden(buffer, pixels, 0.5f, rectangle);
      ASSERT_EQ(buffer.Hides(rectangle), isHidden) << round;
      hidden += isHidden;
    }
  }
  EXPECT_GT(hidden, 2000);
}

TEST(SBufferSamples, SegmentsAreHiddenThatAreFartherAtEveryCentre)
{
  std::mt19937 random(5);
  const auto between = [&](float least, float greatest)
  { return least + (greatest - least) * (static_cast<float>(random()) / 4294967296.0f); };
  int hidden = 0, shown = 0;
  for (int round = 0; round < 1500; ++round)
  {
    const int pixels = static_cast<int>(1 + random() % 8);
    SBuffer buffer = BufferOf(SampleGrid::AtCentres(pixels));
    for (int i = 0; i < 8; ++i)
    {
      const float left = between(-2.0f, 40.0f);
      buffer.Insert(
        1, { left, left + between(0.1f, 20.0f), between(0.1f, 0.9f), between(0.1f, 0.9f), 0 });
    }
    for (int i = 0; i < 10; ++i)
    {
      const float left = between(-1.0f, 40.0f);
      const HideableSegment segment{ left, left + between(0.0f, 6.0f), left + between(0.0f, 6.0f),
        between(0.0f, 0.6f), between(-0.04f, 0.04f), random() % 2 ? 3e38f : between(0.1f, 0.8f) };
      float place = -1.0f;
      const bool isHidden = buffer.Hides(1, segment, place);
      const float found = FirstShown(buffer, pixels, segment);
      if (isHidden)
      {
        ASSERT_LT(found, 0.0f) << round;
      }
      else if (segment.Nearest > 1.0f) // of two bounds, that of more columns may count
      {
        ASSERT_GE(found, 0.0f) << round;
        ASSERT_TRUE(IsShownAt(buffer, segment, place)) << round;
      }
      hidden += isHidden;
      shown += !isHidden;
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(shown, 1000);
}

TEST(SBufferSamples, ASegmentIsAsFarAsEitherOfItsBounds)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(1));
  buffer.Insert(1, { 0.0f, 8.0f, 0.5f, 0.5f, 0 });
  const auto isHidden = [&](const HideableSegment& segment)
  {
    float shown;
    return buffer.Hides(1, segment, shown);
  };
  EXPECT_TRUE(isHidden({ 1.0f, 7.0f, 1.0f, 0.49f, -0.01f, 3e38f })) << "the line";
  EXPECT_TRUE(isHidden({ 1.0f, 7.0f, 1.0f, 0.9f, -0.01f, 0.49f })) << "the nearest";
  EXPECT_TRUE(isHidden({ 1.0f, 7.0f, 1.0f, NotANumber, NotANumber, 0.49f }));
  EXPECT_FALSE(isHidden({ 1.0f, 7.0f, 1.0f, 0.9f, -0.01f, 0.51f }));
  EXPECT_FALSE(isHidden({ 1.0f, 7.0f, 1.0f, NotANumber, NotANumber, 0.51f }));
  EXPECT_FALSE(isHidden({ 1.0f, NotANumber, 1.0f, 0.1f, 0.0f, 0.1f }));
  EXPECT_TRUE(isHidden({ 41.0f, 43.0f, 1.0f, 0.9f, 0.0f, 3e38f })) << "beyond the screen";
}

TEST(SBufferSamples, OfNumbersThatAreNoneHidesNothing)
{
  SBuffer buffer = BufferOf(SampleGrid::AtCentres(2));
  for (int line = 0; line < 4; ++line)
  {
    buffer.Insert(line, { 0.0f, 40.0f, 0.9f, 0.9f, 0 });
  }
  const ScreenRectangle whole{ 1.0f, 9.0f, 1.0f, 3.0f, 0.1f };
  EXPECT_TRUE(buffer.Hides(whole));
  for (float ScreenRectangle::*side : { &ScreenRectangle::Left, &ScreenRectangle::Right,
         &ScreenRectangle::Bottom, &ScreenRectangle::Top, &ScreenRectangle::Nearest })
  {
    ScreenRectangle bad = whole;
    bad.*side = NotANumber;
    EXPECT_FALSE(buffer.Hides(bad));
  }
}

TEST(SBufferTiles, AreCoveredBeforeWhatIsNoNearer)
{
  SBuffer buffer(10, 2); // the last tile is half a one
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 0, 0.0f)) << "nothing is there";
  buffer.Insert(1, { 0.0f, 10.0f, 0.8f, 0.4f, 0 }); // 0.64 at column 4, 0.48 at 8
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 0, 0.639f));
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 0, 0.641f));
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 1, 0.479f));
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 1, 0.481f));
  EXPECT_TRUE(buffer.IsCoveredBefore(1, 2, 0.399f));
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 2, 0.401f));
  EXPECT_FALSE(buffer.IsCoveredBefore(0, 0, 0.1f)) << "another line";
  EXPECT_FALSE(buffer.IsCoveredBefore(1, 0, NotANumber));
}

TEST(SBufferTiles, AreCoveredOnceTheyAreFull)
{
  SBuffer buffer(8, 1);
  buffer.Insert(0, { 0.0f, 3.9f, 0.5f, 0.5f, 0 });
  EXPECT_FALSE(buffer.IsCoveredBefore(0, 0, 0.1f)) << "a gap at its end";
  buffer.Insert(0, { 3.8f, 5.0f, 0.3f, 0.3f, 0 });
  EXPECT_TRUE(buffer.IsCoveredBefore(0, 0, 0.3f)) << "as near is enough";
  EXPECT_FALSE(buffer.IsCoveredBefore(0, 0, 0.31f));
  EXPECT_FALSE(buffer.IsCoveredBefore(0, 1, 0.1f));
  buffer.Insert(0, { 3.0f, 4.0f, 0.4f, 0.4f, 0 });
  EXPECT_TRUE(buffer.IsCoveredBefore(0, 0, 0.4f)) << "known anew";
  buffer.Clear();
  EXPECT_FALSE(buffer.IsCoveredBefore(0, 0, 0.1f));
}

TEST(SBufferTiles, HaveLinesThatAreOpenToWhatIsNearer)
{
  SBuffer buffer(12, 11);
  buffer.Insert(1, { 0.0f, 8.0f, 0.5f, 0.5f, 0 });
  buffer.Insert(2, { 0.0f, 12.0f, 0.7f, 0.7f, 0 });
  buffer.Insert(9, { 0.0f, 4.0f, 0.5f, 0.5f, 0 });
  EXPECT_EQ(buffer.OpenLines(0, 3, 1.0f, 7.0f, 0.5f), 0b1001u);
  EXPECT_EQ(buffer.OpenLines(0, 3, 1.0f, 7.0f, 0.6f), 0b1011u);
  EXPECT_EQ(buffer.OpenLines(0, 3, 1.0f, 9.0f, 0.4f), 0b1011u) << "another tile";
  EXPECT_EQ(buffer.OpenLines(1, 2, 1.0f, 7.0f, 0.4f), 0u);
  EXPECT_EQ(buffer.OpenLines(8, 10, -5.0f, 1.0f, 0.4f), 0b101u);
  EXPECT_EQ(buffer.OpenLines(2, 10, 9.0f, 50.0f, 0.4f), 0b11111110u) << "eight at most";
  EXPECT_EQ(buffer.OpenLines(2, 2, 0.0f, 4.0f, NotANumber), 1u);
  EXPECT_EQ(buffer.OpenLines(1, 2, NotANumber, NotANumber, 0.4f), 1u);
}
