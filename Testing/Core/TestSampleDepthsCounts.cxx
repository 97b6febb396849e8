// What is told of an s-buffer of samples as a whole: counts, columns of faces, a picture.

#include "SampledLines.h"

#include "Core/culling/buffer/SBufferImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{

using sampled_lines::SampledLines;
using vitrine::SampleGrid;
using vitrine::SBuffer;

const int CountedFaces = 5;

/** Columns of each face, sample by sample. */
std::vector<float> ColumnsByFace(const SampledLines& lines)
{
  std::vector<float> columns(CountedFaces, 0.0f);
  for (int line = 0; line < lines.Buffer.Lines(); ++line)
  {
    for (const vitrine::Span& span : lines.Buffer.SpansOf(line))
    {
      columns[span.Face] += 1.0f / static_cast<float>(lines.Pixels);
    }
  }
  return columns;
}

}

TEST(SampleDepths, CountSegmentsAndTheSamplesThatWereCompared)
{
  for (const int pixels : { 1, 2, 4 })
  {
    SCOPED_TRACE(pixels);
    const auto perColumn = static_cast<std::uint64_t>(pixels);
    SBuffer buffer = SBuffer::WithFewSamples(21, 2, SampleGrid::AtCentres(pixels));
    buffer.Insert(0, { -3.0f, 30.0f, 0.5f, 0.5f, 0 });
    EXPECT_EQ(buffer.Counts().Inserted, 1u);
    EXPECT_EQ(buffer.Counts().Comparisons, 21u * perColumn);
    buffer.Insert(1, { 2.0f, 5.0f, 0.1f, 0.2f, 0 });
    EXPECT_EQ(buffer.Counts().Inserted, 2u);
    EXPECT_EQ(buffer.Counts().Comparisons, 24u * perColumn);
    buffer.Insert(0, { 2.0f, 2.0f + 0.4f / float(pixels), 0.9f, 0.9f, 0 }); // between samples
    buffer.Insert(0, { 25.0f, 28.0f, 0.9f, 0.9f, 0 });
    buffer.Insert(0, { 2.0f, 2.0f, 0.9f, 0.9f, 0 });
    buffer.Insert(0, { 2.0f, 5.0f, 0.9f, NotANumber, 0 });
    EXPECT_EQ(buffer.Counts().Inserted, 2u);
    EXPECT_EQ(buffer.Counts().Comparisons, 24u * perColumn);
    EXPECT_EQ(buffer.Counts().Refused, 0u);
  }
}

TEST(SampleDepths, SumUpTheColumnsOfOneFaceThatIsEverywhere)
{
  for (const int pixels : { 1, 2, 4 })
  {
    SBuffer buffer = SBuffer::WithFewSamples(21, 3, SampleGrid::AtCentres(pixels));
    for (int line = 0; line < 3; ++line)
    {
      buffer.Insert(line, { -3.0f, 30.0f, 0.5f, 0.5f, 2 });
    }
    std::vector<float> columns{ 0.0f, 1.0f, 7.0f };
    buffer.AddColumnsOfFaces(columns);
    EXPECT_EQ(columns, (std::vector<float>{ 0.0f, 1.0f, 7.0f + 3.0f * 21.0f })) << pixels;
  }
}

TEST(SampleDepths, SumUpTheColumnsOfEachOfManyFaces)
{
  for (const int columns : { 1, 5, 8, 19, 40 })
  {
    for (const int pixels : { 1, 2, 4 })
    {
      for (unsigned seed = 1; seed <= 20; ++seed)
      {
        SCOPED_TRACE(testing::Message() << columns << " columns, " << pixels << ", seed " << seed);
        sampled_lines::SampleRandom random(seed);
        SampledLines lines(columns, 4, pixels);
        const int count = random.Below(30);
        for (int i = 0; i < count; ++i)
        {
          lines.Insert(random.Below(4),
            RandomSegment(columns, static_cast<std::uint32_t>(random.Below(CountedFaces)), random));
        }
        std::vector<float> sums(CountedFaces, 0.0f);
        lines.Buffer.AddColumnsOfFaces(sums);
        ASSERT_EQ(sums, ColumnsByFace(lines));
      }
    }
  }
}

TEST(SampleDepths, ArePicturedByTheLeastOfEachColumn)
{
  int missing = 0, there = 0;
  for (const int pixels : { 1, 2, 4 })
  {
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
      SCOPED_TRACE(testing::Message() << pixels << " pixels, seed " << seed);
      sampled_lines::SampleRandom random(seed);
      SampledLines lines(13, 5, pixels);
      lines.InsertRandomly(20, random);
      const std::vector<float> picture = vitrine::DepthImage(lines.Buffer);
      ASSERT_EQ(picture.size(), 13u * 5u);
      for (int i = 0; i < 13 * 5; ++i)
      {
        float least = 1.0f;
        for (int k = 0; k < pixels; ++k)
        {
          least = std::min(least, lines.At(i / 13, i % 13 * pixels + k).Depth);
        }
        ASSERT_NEAR(picture[static_cast<std::size_t>(i)], std::max(least, 0.0f), 1e-6);
        missing += least < 0.0f;
        there += least > 0.0f;
      }
    }
  }
  EXPECT_GT(missing, 500);
  EXPECT_GT(there, 500);
}
