// Samples of eight lines that are covered, and asked for, together.

#include "FewFacetsScenes.h"
#include "SampledLines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using sampled_lines::SampledLines;
using sampled_lines::SampleRandom;
using vitrine::HideableSegment;
using vitrine::HideableSegmentLanes;
using vitrine::LaneCount;
using vitrine::Lanes;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::Span;

/** Where eight lines are covered; those that are not have none. */
struct EightRanges
{
  float Lefts[LaneCount], Rights[LaneCount];

  EightRanges(const SBuffer& buffer, int line, SampleRandom& random)
  {
    const auto columns = static_cast<float>(buffer.Columns());
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const bool isThere = line + lane < buffer.Lines() && !random.OneIn(5);
      const float left = random.Between(0.0f, columns), right = random.Between(0.0f, columns);
      this->Lefts[lane] = isThere ? std::min(left, right) : 3e38f;
      this->Rights[lane] = isThere ? std::max(left, right) : -3e38f;
    }
  }
};

std::vector<Span> AllSpansOf(const SBuffer& buffer)
{
  std::vector<Span> spans;
  for (int line = 0; line < buffer.Lines(); ++line)
  {
    for (const Span& span : buffer.SpansOf(line))
    {
      spans.push_back(span);
    }
  }
  return spans;
}

/** Of samples of a tile as spans tell them; -1 if one is missing. */
float LeastBySpans(const SBuffer& buffer, int pixels, int line, int tile)
{
  float least = 2.0f;
  int count = 0;
  const auto left = static_cast<float>(tile * SBuffer::TileWidth);
  const float right = std::min(left + SBuffer::TileWidth, static_cast<float>(buffer.Columns()));
  for (const Span& span : buffer.SpansOf(line))
  {
    if (left < span.Left && span.Left < right)
    {
      least = std::min(least, span.Depth);
      ++count;
    }
  }
  return count == static_cast<int>(right - left) * pixels ? least : -1.0f;
}

void ExpectTilesToFit(const SBuffer& buffer, int pixels)
{
  for (int tile = 0; tile * SBuffer::TileWidth < buffer.Columns(); ++tile)
  {
    for (int line = 0; line < buffer.Lines(); ++line)
    {
      const float least = LeastBySpans(buffer, pixels, line, tile);
      float leasts[LaneCount];
      vitrine::StoreLanes(buffer.LeastDepths(line, tile), leasts);
      ASSERT_TRUE(least < 0.0f ? leasts[0] < 0.0f : leasts[0] == least)
        << "line " << line << ", tile " << tile << ": " << leasts[0] << " and not " << least;
    }
  }
}

}

TEST(SampleDepthsOfLines, AreCoveredAsLineByLine)
{
  for (const int pixels : { 1, 2, 4 })
  {
    for (unsigned seed = 1; seed <= 60; ++seed)
    {
      SCOPED_TRACE(testing::Message() << pixels << " pixels, seed " << seed);
      SampleRandom random(seed);
      const int columns = 1 + random.Below(50), lines = 1 + random.Below(30);
      SBuffer together = SBuffer::WithFewSamples(columns, lines, SampleGrid::AtCentres(pixels));
      SBuffer apart = SBuffer::WithFewSamples(columns, lines, SampleGrid::AtCentres(pixels));
      for (std::uint32_t face = 0; face < 25; ++face)
      {
        const int line = random.Below(lines);
        const EightRanges ranges(together, line, random);
        const float depth = random.Between(0.1f, 0.9f), slope = random.Between(-0.01f, 0.01f);
        const auto depthAt = [&](float column) { return depth + slope * column; };
        together.InsertLines(line, vitrine::LoadLanes(ranges.Lefts),
          vitrine::LoadLanes(ranges.Rights), face,
          [&](float column) { return vitrine::AllLanes(depthAt(column)); });
        for (int lane = 0; lane < LaneCount; ++lane)
        {
          const float left = ranges.Lefts[lane], right = ranges.Rights[lane];
          if (left < right)
          {
            apart.Insert(line + lane, { left, right, depthAt(left), depthAt(right), face });
          }
        }
      }
      const std::vector<Span> spans = AllSpansOf(together), others = AllSpansOf(apart);
      ASSERT_EQ(spans.size(), others.size());
      for (std::size_t i = 0; i < spans.size(); ++i)
      {
        ASSERT_EQ(spans[i].Left, others[i].Left);
        ASSERT_NEAR(spans[i].Depth, others[i].Depth, 1e-5);
      }
      ExpectTilesToFit(together, pixels);
      ExpectTilesToFit(apart, pixels);
    }
  }
}

TEST(SampleDepthsOfLines, HaveTilesThatFitWhatMeshesCover)
{
  for (const int pixels : { 1, 2, 4 })
  {
    for (unsigned seed = 1; seed <= 40; ++seed)
    {
      SCOPED_TRACE(testing::Message() << pixels << " pixels, seed " << seed);
      coverage::Random random(seed);
      coverage::FewOnScreen few(pixels);
      for (int i = 0; i < 12; ++i)
      {
        coverage::Triangles triangles = coverage::RandomFewFacets(random);
        for (glm::dvec3& point : triangles.Points)
        {
          point = glm::dvec3(20.0, 10.0, 0.5) + glm::dvec3(30.0, 18.0, 0.3) * point;
        }
        few.Insert(triangles);
      }
      ExpectTilesToFit(few.Buffer, pixels);
    }
  }
}

TEST(SampleDepthsOfLines, AreHiddenWhereEachLineIs)
{
  int hidden = 0, shown = 0;
  for (const int pixels : { 1, 2, 4 })
  {
    for (unsigned seed = 1; seed <= 300; ++seed)
    {
      SCOPED_TRACE(testing::Message() << pixels << " pixels, seed " << seed);
      SampleRandom random(seed);
      SampledLines lines(1 + random.Below(40), 1 + random.Below(20), pixels);
      const auto columns = static_cast<float>(lines.Buffer.Columns());
      for (int line = 0; line < lines.Buffer.Lines(); ++line)
      {
        lines.Insert(line, { -1.0f, columns + 1.0f, 0.3f, 0.5f, 0 });
      }
      lines.InsertRandomly(lines.Buffer.Lines(), random);
      const int line = random.Below(lines.Buffer.Lines());
      const EightRanges ranges(lines.Buffer, line, random);
      HideableSegmentLanes asked{ {}, random.Between(0.0f, columns), random.Between(-0.01f, 0.01f),
        random.OneIn(2) ? 3e38f : random.Between(0.1f, 0.8f) };
      for (float& depth : asked.Depths)
      {
        depth = random.Between(0.0f, 0.45f);
      }
      float first = 3e38f;
      unsigned open = 0;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        const HideableSegment segment{ ranges.Lefts[lane], ranges.Rights[lane], asked.Column,
          asked.Depths[lane], asked.Slope, asked.Nearest };
        const float place =
          segment.Left <= segment.Right ? lines.FirstShown(line + lane, segment) : -1.0f;
        if (place >= 0.0f && place <= first)
        {
          open = (place < first ? 0u : open) | 1u << lane;
          first = place;
        }
      }
      float place = -1.0f;
      ASSERT_EQ(
        lines.Buffer.BySample()->FindOpen(line, ranges.Lefts, ranges.Rights, asked, place), open);
      ASSERT_TRUE(open == 0 || place == first) << place << " and not " << first;
      hidden += open == 0;
      shown += open != 0;
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(shown, 100);
}
