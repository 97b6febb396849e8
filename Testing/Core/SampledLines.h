/**
 * An s-buffer of samples, and by brute force what it has to hold.
 */
#ifndef VITRINE_TESTING_SAMPLED_LINES_H
#define VITRINE_TESTING_SAMPLED_LINES_H

#include "NonFinite.h"

#include "Core/culling/buffer/SBuffer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace sampled_lines
{

using vitrine::HideableSegment;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::ScreenRectangle;
using vitrine::Segment;

class SampleRandom
{
public:
  explicit SampleRandom(unsigned seed)
    : Generator(seed)
  {
  }

  float Between(float least, float greatest)
  {
    return least + (greatest - least) * static_cast<float>(this->Generator() / 4294967296.0);
  }
  int Below(int count) { return static_cast<int>(this->Generator() % unsigned(count)); }
  bool OneIn(int count) { return this->Below(count) == 0; }

  std::mt19937 Generator;
};

/** Slanted or not, in the screen, across it, or beyond; some in which all samples are, some in which there are none. */
inline Segment RandomSegment(int columns, std::uint32_t face, SampleRandom& random)
{
  const float width = static_cast<float>(columns);
  const float left = random.Between(-0.3f * width - 2.0f, 1.2f * width);
  const float length = random.OneIn(4) ? random.Between(0.0f, 0.6f)
    : random.OneIn(4)                  ? random.Between(0.0f, 3.0f * width)
                                       : random.Between(0.0f, 0.6f * width);
  const float start = random.Between(0.05f, 0.95f);
  return { left, left + length, start, random.OneIn(3) ? start : random.Between(0.05f, 0.95f),
    face };
}

/** Without length, or not finite. */
inline Segment BadSegment(int columns, std::uint32_t face, SampleRandom& random)
{
  Segment segment = RandomSegment(columns, face, random);
  const float bads[] = { NotANumber, Infinity, -Infinity };
  const float bad = bads[random.Below(3)];
  switch (random.Below(6))
  {
    case 0:
      segment.Right = segment.Left;
      break;
    case 1:
      segment.Right = segment.Left - random.Between(0.0f, 9.0f);
      break;
    case 2:
      segment.LeftDepth = bad;
      break;
    case 3:
      segment.RightDepth = bad;
      break;
    case 4:
      segment.Left = segment.Right = bad;
      break;
    default:
      segment.Left = NotANumber;
      break;
  }
  return segment;
}

/** What covers a sample. */
struct Sample
{
  float Depth = -1.0f;  ///< the greatest, or -1 where nothing does
  float Second = -1.0f; ///< of all others
  std::uint32_t Face = 0;
};

class SampledLines
{
public:
  SampledLines(int columns, int lines, int pixels)
    : Buffer(SBuffer::WithFewSamples(columns, lines, SampleGrid::AtCentres(pixels)))
    , Pixels(pixels)
    , PerLine(columns * pixels)
    , Samples(static_cast<std::size_t>(this->PerLine * lines))
  {
  }

  /** Of a number on a line. */
  float PlaceOf(int i) const
  {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(this->Pixels);
  }

  const Sample& At(int line, int i) const
  {
    return this->Samples[static_cast<std::size_t>(line * this->PerLine + i)];
  }

  /** Of a segment that is finite and longer than nothing. */
  void Insert(int line, const Segment& segment)
  {
    this->Buffer.Insert(line, segment);
    const float slope = (segment.RightDepth - segment.LeftDepth) / (segment.Right - segment.Left);
    for (int i = 0; i < this->PerLine; ++i)
    {
      const float x = this->PlaceOf(i);
      if (segment.Left <= x && x <= segment.Right)
      {
        this->Add(line, i, segment.LeftDepth + slope * (x - segment.Left), segment.Face);
      }
    }
  }

  void InsertRandomly(int count, SampleRandom& random)
  {
    for (int i = 0; i < count; ++i)
    {
      const int line = random.Below(this->Buffer.Lines());
      const auto face = static_cast<std::uint32_t>(i);
      if (random.OneIn(6))
      {
        this->Buffer.Insert(line, BadSegment(this->Buffer.Columns(), face, random));
      }
      this->Insert(line, RandomSegment(this->Buffer.Columns(), face, random));
    }
  }

  bool AreHidden(const ScreenRectangle& rectangle) const
  {
    for (int row = 0; row < this->Buffer.Lines() * this->Pixels; ++row)
    {
      const float y = this->PlaceOf(row);
      for (int i = 0; i < this->PerLine; ++i)
      {
        const float x = this->PlaceOf(i);
        if (rectangle.Left <= x && x <= rectangle.Right && rectangle.Bottom <= y &&
          y <= rectangle.Top && !(this->At(row / this->Pixels, i).Depth > rectangle.Nearest))
        {
          return false;
        }
      }
    }
    return true;
  }

  /** Whether a sample is one of a segment, and shows it. */
  bool ShowsAt(int line, const HideableSegment& segment, int i) const
  {
    const float x = this->PlaceOf(i), depth = this->At(line, i).Depth;
    return segment.Left <= x && x <= segment.Right && !(depth > segment.DepthAt(x)) &&
      !(depth > segment.Nearest);
  }

  /** The place of the first one, or -1. */
  float FirstShown(int line, const HideableSegment& segment) const
  {
    for (int i = 0; i < this->PerLine; ++i)
    {
      if (this->ShowsAt(line, segment, i))
      {
        return this->PlaceOf(i);
      }
    }
    return -1.0f;
  }

  /** Of the samples of a tile; -1 if one of them is not covered. */
  float LeastOfTile(int line, int tile) const
  {
    float least = 1.0f;
    const int width = SBuffer::TileWidth * this->Pixels;
    for (int i = tile * width; i < std::min((tile + 1) * width, this->PerLine); ++i)
    {
      least = std::min(least, this->At(line, i).Depth);
    }
    return least;
  }

  SBuffer Buffer;
  int Pixels;
  int PerLine; ///< samples

private:
  void Add(int line, int i, float depth, std::uint32_t face)
  {
    Sample& sample = this->Samples[static_cast<std::size_t>(line * this->PerLine + i)];
    sample.Second = std::max(sample.Second, std::min(depth, sample.Depth));
    if (depth > sample.Depth)
    {
      sample.Depth = depth;
      sample.Face = face;
    }
  }

  std::vector<Sample> Samples;
};

}

#endif
