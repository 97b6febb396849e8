#include "NonFinite.h"

#include "Core/culling/buffer/SBuffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using vitrine::SBuffer;
using vitrine::ScreenRectangle;
using vitrine::Segment;
using vitrine::Span;

Segment Flat(float left, float right, float depth, std::uint32_t face = 0)
{
  return { left, right, depth, depth, face };
}

/** Within line 1 alone. */
ScreenRectangle InLine1(float left, float right, float nearest)
{
  return { left, right, 1.2f, 1.8f, nearest };
}

/** Sorted, apart, each with a length and within the columns. */
void ExpectOrder(const SBuffer& buffer, int line)
{
  float end = 0.0f;
  for (const Span& span : buffer.SpansOf(line))
  {
    EXPECT_GE(span.Left, end);
    EXPECT_LT(span.Left, span.Right);
    end = span.Right;
  }
  EXPECT_LE(end, static_cast<float>(buffer.Columns()));
}

/** The depth at x, or -1 where nothing covers it. */
float DepthAt(const std::vector<Span>& spans, float x)
{
  for (const Span& span : spans)
  {
    if (span.Left <= x && x < span.Right)
    {
      return span.DepthAt(x);
    }
  }
  return -1.0f;
}

float DepthAt(const Segment& segment, float x)
{
  const float t = (x - segment.Left) / (segment.Right - segment.Left);
  return segment.LeftDepth + t * (segment.RightDepth - segment.LeftDepth);
}

/** The nearest of the segments at x, or -1. */
float NearestAt(const std::vector<Segment>& segments, float x)
{
  float nearest = -1.0f;
  for (const Segment& segment : segments)
  {
    if (segment.Left <= x && x < segment.Right)
    {
      nearest = std::max(nearest, DepthAt(segment, x));
    }
  }
  return nearest;
}

class RandomSegments
{
public:
  explicit RandomSegments(unsigned seed)
    : Generator(seed)
  {
  }

  float Between(float least, float greatest)
  {
    return std::uniform_real_distribution<float>(least, greatest)(this->Generator);
  }

  /** Some flat, some slanted, some with ends in common, some beyond the screen. */
  Segment Next(float columns)
  {
    const bool isOnGrid = this->Between(0.0f, 1.0f) < 0.4f;
    float left = this->Between(-5.0f, columns);
    float length = this->Between(0.1f, 0.4f * columns);
    if (isOnGrid)
    {
      left = std::floor(left);
      length = std::ceil(length);
    }
    const float depth = std::round(this->Between(1.0f, 9.0f)) / 10.0f;
    const bool isFlat = this->Between(0.0f, 1.0f) < 0.4f;
    return { left, left + length, depth, isFlat ? depth : this->Between(0.05f, 0.95f), 0 };
  }

private:
  std::mt19937 Generator;
};

}

TEST(SBuffer, HidesNothingWhereNothingIs)
{
  SBuffer buffer(40, 3);
  EXPECT_FALSE(buffer.Hides(InLine1(3.0f, 4.0f, 0.0f)));
  EXPECT_TRUE(buffer.SpansOf(1).empty());
}

TEST(SBuffer, HidesWhatIsFartherWithinTheEnds)
{
  SBuffer buffer(40, 3);
  buffer.Insert(1, Flat(5.25f, 30.5f, 0.5f));
  EXPECT_TRUE(buffer.Hides(InLine1(5.25f, 30.5f, 0.49f)));
  EXPECT_FALSE(buffer.Hides(InLine1(5.2f, 30.5f, 0.49f)));
  EXPECT_FALSE(buffer.Hides(InLine1(5.25f, 30.6f, 0.49f)));
  EXPECT_FALSE(buffer.Hides(InLine1(5.25f, 30.5f, 0.5f))) << "equal is visible";
  EXPECT_FALSE(buffer.Hides({ 6.0f, 7.0f, 0.9f, 1.1f, 0.1f })) << "a line more";
  EXPECT_FALSE(buffer.Hides({ 6.0f, 7.0f, 1.9f, 2.0f, 0.1f })) << "touches the next line";
}

TEST(SBuffer, NothingShowsBeyondTheScreen)
{
  SBuffer buffer(40, 3);
  EXPECT_TRUE(buffer.Hides({ -9.0f, -1.0f, 0.0f, 2.0f, 0.9f }));
  EXPECT_TRUE(buffer.Hides({ 41.0f, 50.0f, 0.0f, 2.0f, 0.9f }));
  EXPECT_TRUE(buffer.Hides({ 1.0f, 2.0f, 3.5f, 9.0f, 0.9f }));
  EXPECT_TRUE(buffer.Hides({ 1.0f, 2.0f, -9.0f, -0.5f, 0.9f }));
  buffer.Insert(1, Flat(-10.0f, 60.0f, 0.5f));
  EXPECT_TRUE(buffer.Hides(InLine1(-5.0f, 50.0f, 0.4f)));
  ExpectOrder(buffer, 1);
}

TEST(SBuffer, HasTwoEndsInCommonWithoutAGap)
{
  SBuffer buffer(40, 3);
  buffer.Insert(1, Flat(3.0f, 11.7f, 0.5f));
  buffer.Insert(1, Flat(11.7f, 20.0f, 0.6f));
  EXPECT_TRUE(buffer.Hides(InLine1(3.0f, 19.9f, 0.4f)));
}

TEST(SBuffer, KeepsTheNearer)
{
  SBuffer buffer(8, 1);
  buffer.Insert(0, Flat(1.0f, 7.0f, 0.5f, 1));
  buffer.Insert(0, Flat(2.0f, 4.0f, 0.8f, 2));
  buffer.Insert(0, Flat(0.5f, 7.5f, 0.3f, 3));
  const std::vector<Span> spans = buffer.SpansOf(0);
  const std::vector<std::uint32_t> faces = { 3, 1, 2, 1, 3 };
  const std::vector<float> ends = { 0.5f, 1.0f, 2.0f, 4.0f, 7.0f, 7.5f };
  ASSERT_EQ(spans.size(), faces.size());
  for (std::size_t i = 0; i < spans.size(); ++i)
  {
    EXPECT_EQ(spans[i].Face, faces[i]) << i;
    EXPECT_EQ(spans[i].Left, ends[i]) << i;
    EXPECT_EQ(spans[i].Right, ends[i + 1]) << i;
  }
}

TEST(SBuffer, KeepsThePiecesBeforeAndBehindACrossing)
{
  SBuffer buffer(4, 1);
  buffer.Insert(0, { 0.0f, 4.0f, 0.2f, 0.6f, 1 });
  buffer.Insert(0, { 0.0f, 4.0f, 0.6f, 0.2f, 2 });
  const std::vector<Span> spans = buffer.SpansOf(0);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].Face, 2u);
  EXPECT_EQ(spans[1].Face, 1u);
  EXPECT_NEAR(spans[0].Right, 2.0f, 1e-5f);
  EXPECT_TRUE(buffer.Hides({ 0.0f, 4.0f, 0.2f, 0.8f, 0.39f }));
  EXPECT_FALSE(buffer.Hides({ 0.0f, 4.0f, 0.2f, 0.8f, 0.41f }));
}

TEST(SBuffer, ThatIsFullOfOneFaceHasASpanATileAndIsHiddenWithoutComparisons)
{
  SBuffer buffer(64, 1);
  buffer.Insert(0, Flat(0.0f, 64.0f, 0.5f));
  EXPECT_EQ(buffer.SpansOf(0).size(), 64u / SBuffer::TileWidth);
  EXPECT_TRUE(buffer.Hides({ 1.0f, 63.0f, 0.0f, 1.0f, 0.4f })); // and knows the least depths
  buffer.Insert(0, Flat(0.0f, 64.0f, 0.3f));
  EXPECT_EQ(buffer.Counts().Comparisons, 0u);
  EXPECT_EQ(buffer.Counts().Inserted, 2u);
}

TEST(SBuffer, ManySegmentsAreTheNearestOfThemEverywhere)
{
  const float columns = 50.0f;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    RandomSegments random(seed);
    SBuffer buffer(50, 1);
    std::vector<Segment> segments;
    for (int i = 0; i < 40; ++i)
    {
      segments.push_back(random.Next(columns));
      buffer.Insert(0, segments.back());
    }
    ExpectOrder(buffer, 0);
    const std::vector<Span> spans = buffer.SpansOf(0);
    int farther = 0;
    for (float x = 0.005f; x < columns; x += 0.01f)
    {
      const float expected = NearestAt(segments, x);
      const float depth = DepthAt(spans, x);
      ASSERT_LE(depth, expected + 1e-5f) << x;
      farther += depth < expected - 1e-5f; // where a piece beside a crossing is short
    }
    EXPECT_LE(farther, 50);
  }
}

TEST(SBuffer, HidesWhatItsSpansHide)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    RandomSegments random(seed);
    SBuffer buffer(50, 1);
    for (int i = 0; i < 30; ++i)
    {
      buffer.Insert(0, random.Next(50.0f));
      const std::vector<Span> spans = buffer.SpansOf(0);
      const float left = random.Between(0.0f, 45.0f);
      const float right = left + random.Between(0.1f, 5.0f);
      const float nearest = random.Between(0.0f, 0.9f);
      bool isHidden = true;
      for (float x = left; x <= right; x += 0.001f)
      {
        isHidden = isHidden && DepthAt(spans, x) > nearest;
      }
      if (buffer.Hides({ left, right, 0.1f, 0.9f, nearest }))
      {
        EXPECT_TRUE(isHidden);
      }
      else
      {
        EXPECT_FALSE(buffer.Hides({ left, right, 0.1f, 0.9f, nearest + 1e-3f }))
          << "what is nearer";
      }
    }
  }
}

TEST(SBuffer, LeavesOutWhatIsNoSegment)
{
  SBuffer buffer(40, 1);
  for (const Segment& segment :
    { Flat(5.0f, 5.0f, 0.5f), Flat(6.0f, 5.0f, 0.5f), Flat(NotANumber, 5.0f, 0.5f),
      Flat(1.0f, NotANumber, 0.5f), Flat(1.0f, 5.0f, NotANumber), Flat(1.0f, 5.0f, Infinity),
      Segment{ 1.0f, 5.0f, -Infinity, 0.5f, 0 }, Segment{ -Infinity, Infinity, 0.5f, 0.4f, 0 },
      Flat(50.0f, 60.0f, 0.5f), Flat(-5.0f, 0.0f, 0.5f) })
  {
    buffer.Insert(0, segment);
  }
  EXPECT_TRUE(buffer.SpansOf(0).empty());
  buffer.Insert(0, Flat(0.0f, 40.0f, 0.5f));
  EXPECT_FALSE(buffer.Hides({ NotANumber, NotANumber, NotANumber, NotANumber, NotANumber }));
  EXPECT_FALSE(buffer.Hides({ 1.0f, 5.0f, 0.0f, 1.0f, NotANumber }));
}

TEST(SBuffer, ThatHasNoSpansLeftHidesLessAndSaysSo)
{
  RandomSegments random(7);
  SBuffer buffer(50, 1, {}, 20);
  std::vector<Segment> segments;
  for (int i = 0; i < 200; ++i)
  {
    segments.push_back(random.Next(50.0f));
    buffer.Insert(0, segments.back());
  }
  EXPECT_GT(buffer.Counts().Refused, 0u);
  ExpectOrder(buffer, 0);
  const std::vector<Span> spans = buffer.SpansOf(0);
  for (float x = 0.005f; x < 50.0f; x += 0.01f)
  {
    ASSERT_LE(DepthAt(spans, x), NearestAt(segments, x) + 1e-5f) << x;
  }
}

TEST(SBuffer, IsEmptyOnceCleared)
{
  SBuffer buffer(40, 2);
  buffer.Insert(1, Flat(0.0f, 40.0f, 0.5f));
  buffer.Clear();
  EXPECT_TRUE(buffer.SpansOf(1).empty());
  EXPECT_EQ(buffer.Counts().Inserted, 0u);
  EXPECT_FALSE(buffer.Hides(InLine1(1.0f, 2.0f, 0.1f)));
}
