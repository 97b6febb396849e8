// What an s-buffer holds and hides that keeps the depths of samples in place of spans, by brute force at every sample.

#include "SampledLines.h"

#include "Core/culling/buffer/SBufferImage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace
{

using sampled_lines::Sample;
using sampled_lines::SampledLines;
using sampled_lines::SampleRandom;
using vitrine::HideableSegment;
using vitrine::LaneCount;
using vitrine::SampleDepths;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::ScreenRectangle;
using vitrine::Span;

const float DepthRounding = 1e-6f;

bool IsBySample(const SampleGrid& samples)
{
  return SBuffer::WithFewSamples(9, 5, samples).BySample() != nullptr;
}

/** Columns and lines; most end with a part of a tile, and of eight lines. */
struct LinesSize
{
  int Columns, Lines;
};

const LinesSize AllSizes[] = { { 1, 1 }, { 3, 2 }, { 8, 8 }, { 7, 9 }, { 13, 5 }, { 41, 17 },
  { 70, 11 } };

/** Does something with lines of each size and number of samples into which segments were put at random. */
template <class Work>
void ForRandomLines(int rounds, const Work& work)
{
  for (const LinesSize& size : AllSizes)
  {
    for (const int pixels : { 1, 2, 4 })
    {
      for (unsigned seed = 1; seed <= static_cast<unsigned>(rounds); ++seed)
      {
        SCOPED_TRACE(testing::Message()
          << size.Columns << " by " << size.Lines << ", " << pixels << " pixels, seed " << seed);
        SampleRandom random(seed);
        SampledLines lines(size.Columns, size.Lines, pixels);
        lines.InsertRandomly(static_cast<int>(random.Between(0.0f, 9.0f) * size.Lines), random);
        work(lines, random);
        if (testing::Test::HasFatalFailure())
        {
          return;
        }
      }
    }
  }
}

/** Narrow or wide, within the screen or beyond; some begin and end at samples. */
ScreenRectangle RandomRectangle(const SampledLines& lines, SampleRandom& random)
{
  const auto columns = static_cast<float>(lines.Buffer.Columns());
  const auto count = static_cast<float>(lines.Buffer.Lines());
  const auto start = [&](float size)
  {
    const float place = random.Between(-0.2f * size - 1.0f, 1.1f * size);
    return random.OneIn(3) ? lines.Buffer.Samples().From(place) : place;
  };
  const float left = start(columns), bottom = start(count);
  const float most = random.OneIn(2) ? 8.0f / static_cast<float>(lines.Pixels) : 1.3f * columns;
  const float width = random.Between(0.0f, most), height = random.Between(0.0f, 0.6f * count);
  return { left, left + (random.OneIn(5) ? 0.0f : width), bottom,
    bottom + (random.OneIn(5) ? 0.0f : height), random.Between(0.0f, 0.6f) };
}

/** Covers all with what is near, so that most is hidden. */
void CoverMost(SampledLines& lines, SampleRandom& random)
{
  const auto columns = static_cast<float>(lines.Buffer.Columns());
  for (int line = 0; line < lines.Buffer.Lines(); ++line)
  {
    const float start = random.Between(0.0f, 1.0f);
    const float gap = random.OneIn(3) ? random.Between(0.0f, 0.7f) : 0.0f;
    lines.Insert(line, { -1.0f, columns * start - gap, 0.6f, random.Between(0.3f, 0.9f), 0 });
    lines.Insert(line, { columns * start, columns + 1.0f, random.Between(0.3f, 0.9f), 0.7f, 0 });
  }
}

}

TEST(SampleDepths, StandInPlaceOfSpansWhereALineHasFewPlacesWithSamples)
{
  for (const int pixels : { 1, 2, 4 })
  {
    EXPECT_TRUE(IsBySample(SampleGrid::AtCentres(pixels))) << pixels;
  }
  for (const int pixels : { 3, 5, 6, 8, 16 })
  {
    EXPECT_FALSE(IsBySample(SampleGrid::AtCentres(pixels))) << pixels;
  }
  EXPECT_TRUE(IsBySample(SampleGrid::InCells(1, 4)));
  EXPECT_FALSE(IsBySample(SampleGrid::InCells(8, 8)));
  EXPECT_FALSE(IsBySample({}));
  EXPECT_EQ(SBuffer(9, 5, SampleGrid::AtCentres(1)).BySample(), nullptr) << "not asked for";
}

TEST(SampleDepths, AreThoseOfTheNearestAtEachSample)
{
  int covered = 0, owned = 0;
  ForRandomLines(12,
    [&](SampledLines& lines, SampleRandom&)
    {
      for (int line = 0; line < lines.Buffer.Lines(); ++line)
      {
        const std::vector<Span> spans = lines.Buffer.SpansOf(line);
        std::size_t next = 0;
        for (int i = 0; i < lines.PerLine; ++i)
        {
          const Sample& sample = lines.At(line, i);
          if (sample.Depth < 0.0f)
          {
            continue;
          }
          ASSERT_LT(next, spans.size());
          const Span& span = spans[next++];
          ASSERT_EQ(span.Left, lines.PlaceOf(i));
          ASSERT_EQ(span.Right, span.Left);
          ASSERT_EQ(span.Slope, 0.0f);
          ASSERT_NEAR(span.Depth, sample.Depth, DepthRounding);
          ++covered;
          if (sample.Second < sample.Depth - 2.0f * DepthRounding)
          {
            ASSERT_EQ(span.Face, sample.Face);
            ++owned;
          }
        }
        ASSERT_EQ(next, spans.size()) << "more are covered than should be";
      }
    });
  EXPECT_GT(covered, 10000);
  EXPECT_GT(owned, 9000);
}

// As spans are: their slopes would be no numbers, or 0.
TEST(SampleDepths, OfSegmentsWithoutEndAreLeftOut)
{
  for (const int pixels : { 1, 2, 4 })
  {
    SBuffer buffer = SBuffer::WithFewSamples(10, 1, SampleGrid::AtCentres(pixels));
    buffer.Insert(0, { 2.0f, Infinity, 0.5f, 0.1f, 0 });
    buffer.Insert(0, { -Infinity, 8.0f, 0.5f, 0.1f, 0 });
    buffer.Insert(0, { -Infinity, Infinity, 0.5f, 0.1f, 0 });
    buffer.Insert(0, { -3e38f, 3e38f, 0.9f, 0.1f, 0 }); // its length is none in floats
    EXPECT_TRUE(buffer.SpansOf(0).empty());
    EXPECT_EQ(buffer.Counts().Inserted, 0u);
  }
}

TEST(SampleDepths, HideRectanglesOfWhichAllSamplesAreCoveredByWhatIsNearer)
{
  int hidden = 0, shown = 0;
  ForRandomLines(6,
    [&](SampledLines& lines, SampleRandom& random)
    {
      for (const bool isMostCovered : { false, true })
      {
        if (isMostCovered)
        {
          CoverMost(lines, random);
        }
        for (int i = 0; i < 60; ++i)
        {
          const ScreenRectangle rectangle = RandomRectangle(lines, random);
          const bool isHidden = lines.AreHidden(rectangle);
          ASSERT_EQ(lines.Buffer.Hides(rectangle), isHidden)
            << rectangle.Left << " to " << rectangle.Right << ", " << rectangle.Bottom << " to "
            << rectangle.Top << " at " << rectangle.Nearest;
          hidden += isHidden;
          shown += !isHidden;
        }
      }
    });
  EXPECT_GT(hidden, 2500);
  EXPECT_GT(shown, 2500);
}

// One sample that is missing, wherever it is, is seen in a rectangle that has it, and in none beside it.
TEST(SampleDepths, MissASampleWhereverItIs)
{
  for (const int pixels : { 1, 2, 4 })
  {
    const int columns = 22, count = 19;
    for (unsigned seed = 1; seed <= 150; ++seed)
    {
      SCOPED_TRACE(testing::Message() << pixels << " pixels, seed " << seed);
      SampleRandom random(seed);
      SampledLines lines(columns, count, pixels);
      const int line = random.Below(count), hole = random.Below(lines.PerLine);
      const float x = lines.PlaceOf(hole), beside = 0.25f / static_cast<float>(pixels);
      for (int i = 0; i < count; ++i)
      {
        lines.Insert(i, { -1.0f, i == line ? x - beside : 30.0f, 0.5f, 0.5f, 0 });
        lines.Insert(i, { x + beside, 30.0f, 0.5f, 0.5f, 0 });
      }
      ASSERT_FALSE(lines.Buffer.Hides({ 0.0f, columns, 0.0f, count, 0.4f }));
      for (int i = 0; i < 30; ++i)
      {
        ScreenRectangle rectangle = RandomRectangle(lines, random);
        rectangle.Nearest = 0.4f;
        ASSERT_EQ(lines.Buffer.Hides(rectangle), lines.AreHidden(rectangle));
      }
    }
  }
}

TEST(SampleDepths, HideAllBeyondTheScreenAndNothingOfNumbersThatAreNone)
{
  for (const int pixels : { 1, 2, 4 })
  {
    SampledLines lines(21, 10, pixels);
    for (const ScreenRectangle& beyond : { ScreenRectangle{ 21.0f, 30.0f, 1.0f, 2.0f, 0.9f },
           { -9.0f, -1.0f, 1.0f, 2.0f, 0.9f }, { 1.0f, 2.0f, 10.0f, 11.0f, 0.9f },
           { 1.0f, 2.0f, -3.0f, -0.1f, 0.9f }, { 3e38f, Infinity, 1.0f, 2.0f, 0.9f } })
    {
      EXPECT_TRUE(lines.Buffer.Hides(beyond)) << beyond.Left << " " << beyond.Bottom;
    }
    EXPECT_FALSE(lines.Buffer.Hides({ -Infinity, Infinity, -Infinity, Infinity, 0.1f }));
    for (int line = 0; line < 10; ++line)
    {
      lines.Insert(line, { -1.0f, 22.0f, 0.9f, 0.9f, 0 });
    }
    EXPECT_TRUE(lines.Buffer.Hides({ -Infinity, Infinity, -Infinity, Infinity, 0.1f }));
    for (const float right : { 4.0f, 19.0f })
    {
      const ScreenRectangle whole{ 1.0f, right, 1.0f, 9.0f, 0.1f };
      EXPECT_TRUE(lines.Buffer.Hides(whole));
      for (float ScreenRectangle::*field : { &ScreenRectangle::Left, &ScreenRectangle::Right,
             &ScreenRectangle::Bottom, &ScreenRectangle::Top, &ScreenRectangle::Nearest })
      {
        ScreenRectangle bad = whole;
        bad.*field = NotANumber;
        EXPECT_FALSE(lines.Buffer.Hides(bad));
      }
    }
  }
}

TEST(SampleDepths, HideSegmentsThatAreFartherAtEverySampleAndTellWhereOneShows)
{
  int hidden = 0, shown = 0;
  ForRandomLines(8,
    [&](SampledLines& lines, SampleRandom& random)
    {
      const auto columns = static_cast<float>(lines.Buffer.Columns());
      for (int i = 0; i < 60; ++i)
      {
        const int line = random.Below(lines.Buffer.Lines());
        const float left = random.Between(-0.1f * columns - 1.0f, 1.1f * columns);
        const HideableSegment segment{ left, left + random.Between(0.0f, 0.7f * columns),
          left + random.Between(0.0f, 6.0f), random.Between(0.0f, 0.6f),
          random.Between(-0.04f, 0.04f), random.OneIn(2) ? 3e38f : random.Between(0.1f, 0.8f) };
        const float first = lines.FirstShown(line, segment);
        float place = -1.0f;
        ASSERT_EQ(lines.Buffer.Hides(line, segment, place), first < 0.0f);
        ASSERT_TRUE(first < 0.0f || place == first) << place << " and not " << first;
        hidden += first < 0.0f;
        shown += first >= 0.0f;
      }
    });
  EXPECT_GT(hidden, 2000);
  EXPECT_GT(shown, 2000);
}

TEST(SampleDepths, SegmentsOfNumbersThatAreNoneShow)
{
  SampledLines lines(11, 1, 2);
  lines.Insert(0, { -1.0f, 12.0f, 0.5f, 0.5f, 0 });
  const auto isHidden = [&](const HideableSegment& segment)
  {
    float shown;
    return lines.Buffer.Hides(0, segment, shown);
  };
  EXPECT_TRUE(isHidden({ 1.0f, 7.0f, 1.0f, NotANumber, NotANumber, 0.49f }));
  EXPECT_FALSE(isHidden({ 1.0f, 7.0f, 1.0f, NotANumber, NotANumber, 0.51f }));
  EXPECT_FALSE(isHidden({ 1.0f, 7.0f, 1.0f, 0.6f, 0.0f, NotANumber }));
  EXPECT_FALSE(isHidden({ 1.0f, NotANumber, 1.0f, 0.1f, 0.0f, 0.1f }));
  EXPECT_FALSE(isHidden({ NotANumber, 7.0f, 1.0f, 0.1f, 0.0f, 0.1f }));
}

TEST(SampleDepths, TellTheLeastDepthOfEachTile)
{
  int full = 0;
  ForRandomLines(8,
    [&](SampledLines& lines, SampleRandom& random)
    {
      CoverMost(lines, random);
      const SBuffer& buffer = lines.Buffer;
      const int tiles = (buffer.Columns() + SBuffer::TileWidth - 1) / SBuffer::TileWidth;
      for (int tile = 0; tile < tiles; ++tile)
      {
        const float depth = random.Between(0.0f, 0.8f);
        for (int line = 0; line < buffer.Lines(); ++line)
        {
          const float least = lines.LeastOfTile(line, tile);
          float leasts[LaneCount];
          vitrine::StoreLanes(buffer.LeastDepths(line, tile), leasts);
          ASSERT_EQ(buffer.IsCoveredBefore(line, tile, depth), least >= depth);
          ASSERT_EQ(buffer.IsCoveredBefore(line, tile, least), least >= 0.0f) << "as near";
          ASSERT_TRUE(least < 0.0f ? leasts[0] < 0.0f : leasts[0] == least) << leasts[0];
          for (int above = 1; above < LaneCount; ++above)
          {
            const float there =
              line + above < buffer.Lines() ? lines.LeastOfTile(line + above, tile) : -1.0f;
            ASSERT_TRUE(there < 0.0f ? leasts[above] < 0.0f : leasts[above] == there);
          }
          const float left = static_cast<float>(tile * SBuffer::TileWidth) + 0.1f;
          const int last = std::min(line + random.Below(LaneCount), buffer.Lines() - 1);
          unsigned open = 0;
          for (int at = line; at <= last; ++at)
          {
            open |= lines.LeastOfTile(at, tile) >= depth ? 0u : 1u << (at - line);
          }
          ASSERT_EQ(buffer.OpenLines(line, last, left, left + 0.2f, depth), open);
          full += least >= 0.0f;
        }
      }
    });
  EXPECT_GT(full, 3000);
}

TEST(SampleDepths, AreGoneOnceTheBufferIsCleared)
{
  for (const int pixels : { 1, 2, 4 })
  {
    SampledLines lines(13, 9, pixels);
    SampleRandom random(7);
    CoverMost(lines, random);
    EXPECT_GT(lines.Buffer.Counts().Inserted, 0u);
    lines.Buffer.Clear();
    EXPECT_EQ(lines.Buffer.Counts().Inserted, 0u);
    EXPECT_EQ(lines.Buffer.Counts().Comparisons, 0u);
    for (int line = 0; line < 9; ++line)
    {
      EXPECT_TRUE(lines.Buffer.SpansOf(line).empty());
      EXPECT_FALSE(lines.Buffer.IsCoveredBefore(line, 0, 0.0f));
      EXPECT_FALSE(lines.Buffer.IsCoveredBefore(line, 3, 0.0f)) << "a part of a tile";
      lines.Buffer.Insert(line, { 11.6f, 13.0f, 0.2f, 0.2f, 0 });
      EXPECT_FALSE(lines.Buffer.Hides({ 9.0f, 13.0f, 0.0f, 9.0f, 0.1f }));
    }
    EXPECT_TRUE(lines.Buffer.Hides({ 12.0f, 13.0f, 0.0f, 9.0f, 0.1f }))
      << "farther than what was there";
  }
}
