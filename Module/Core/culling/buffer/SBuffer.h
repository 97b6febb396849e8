#ifndef VITRINE_CORE_CULLING_BUFFER_S_BUFFER_H
#define VITRINE_CORE_CULLING_BUFFER_S_BUFFER_H

#include "Core/culling/buffer/SampleDepths.h"
#include "Core/culling/buffer/TileDepths.h"
#include "Core/geometry/BeyondAll.h"
#include "Core/geometry/SampleGrid.h"
#include "Core/geometry/ScreenRectangle.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * What an occluder surely covers of a line of an s-buffer: all samples of the line from Left to Right, in columns. Depth
 * is reversed, 1 at the near plane and 0 at the far one, and linear between the ends; what is drawn is nowhere farther.
 */
struct Segment
{
  float Left;
  float Right;
  float LeftDepth;
  float RightDepth;
  std::uint32_t Face; ///< whose it is, any number of the caller's
};

/** A part of a line, and what covers it. */
struct Span
{
  float Left;
  float Right;
  float Depth; ///< reversed, at Left
  float Slope; ///< of the depth, per column
  std::uint32_t Face;
  std::uint32_t Next; ///< the next one to the right in the same tile, or NoSpan

  float DepthAt(float x) const { return this->Depth + this->Slope * (x - this->Left); }
};

/**
 * What stands somewhere on a line and may be hidden: from Left to Right, nowhere nearer than a depth that is linear in the columns, nor than
 * Nearest. All of that are real numbers, and depths are reversed.
 */
struct HideableSegment
{
  float Left;
  float Right;
  float Column; ///< where it has Depth
  float Depth;
  float Slope; ///< of the depth, per column
  float Nearest;

  float DepthAt(float x) const { return this->Depth + this->Slope * (x - this->Column); }

  float NearestAt(float x) const
  {
    const float depth = this->DepthAt(x);
    return depth < this->Nearest ? depth : this->Nearest; // as where it is no number
  }
};

/** The same on eight lines, whose depths differ. */
struct HideableSegmentLanes
{
  float Depths[LaneCount]; ///< at Column
  float Column;
  float Slope;
  float Nearest;
};

/** What is as near as a segment that is longer than nothing, and by a margin nearer. */
inline HideableSegment Hideable(const Segment& segment, float margin = 0.0f)
{
  const float slope = (segment.RightDepth - segment.LeftDepth) / (segment.Right - segment.Left);
  return { segment.Left, segment.Right, segment.Left, segment.LeftDepth + margin, slope,
    BeyondAll };
}

/** Counts since Clear(). */
struct SBufferCounts
{
  std::uint64_t Inserted = 0;    ///< segments
  std::uint64_t Comparisons = 0; ///< of two depths at one place
  std::uint64_t Changed = 0; ///< of what was inserted on eight lines at once, what had samples then
  std::uint64_t Refused = 0; ///< pieces of segments for which there was no span left
};

/**
 * An s-buffer: for each line of the screen the spans that are covered, sorted, each by the nearest face known there
 * (A. V. Boreskov, the hierarchical s-buffer). A line is thick: it
 * stands for all the pixels in it, and a span covers all of their samples. Ends of spans are real numbers, so columns set
 * nothing but the unit.
 *
 * Lines are cut into tiles with a list each, and the least depth of all that covers a tile, if it is
 * full. Most questions are answered by the latter.
 *
 * Spans come from a pool. Once it is used up, nothing is inserted any more: less is hidden, never too much. Where few samples are asked for, their depths stand in place of spans.
 */
class SBuffer
{
public:
  static constexpr std::uint32_t NoSpan = 0xffffffffu;
  static constexpr int TileWidth = TileDepths::Width;

  /** With that many columns and lines, both at least 1. */
  SBuffer(int columns, int lines, const SampleGrid& samples = {},
    std::size_t mostSpans = DefaultMostSpans);

  /** The same, with the depths of samples in place of spans if there are few. */
  static SBuffer WithFewSamples(int columns, int lines, const SampleGrid& samples);

  const SampleGrid& Samples() const { return this->Grid; }

  int Columns() const { return this->ColumnCount; }
  int Lines() const { return this->LineCount; }

  /** Nothing is covered. */
  void Clear();

  /** Keep what of `segment` is nearer than what is there. Segments without length or that are not finite are left out. */
  void Insert(int line, const Segment& segment);

  /** The same where it has spans, by what is known of their order without comparing depths (SBufferInsertion.h). */
  template <class Orders>
  void InsertBy(Orders& orders, int line, const Segment& segment);

  /** The depths of samples, if it has those in place of spans. */
  const SampleDepths* BySample() const { return this->AtSamples.get(); }

  /**
   * Where it has those, on a line and the seven above it: keep what is nearer than what is there.
   * @param left     columns of the screen that each line is covered between; of those that are not, beyond all others, and `right` before them
   * @param depthAt  the depths of all lines at a column
   */
  template <class DepthAt>
  VITRINE_INLINE void InsertLines(
    int line, Lanes left, Lanes right, std::uint32_t face, const DepthAt& depthAt)
  {
    assert(line >= 0 && line < this->LineCount);
    const int lines = CountBits(BitsOf(left <= right));
    const SampleDepths::Range range = lines > 0
      ? this->AtSamples->Between(LeastLane(left), GreatestLane(right))
      : SampleDepths::Range{ 0, -1 };
    if (range.First <= range.Last)
    {
      this->Counted.Inserted += static_cast<std::uint64_t>(lines);
      this->Counted.Comparisons +=
        static_cast<std::uint64_t>(lines * (range.Last + 1 - range.First));
      this->Counted.Changed +=
        this->AtSamples->InsertLines(this->Tiles, line, range, left, right, face, depthAt);
    }
  }

  /** Whether all samples in the rectangle are covered by what is nearer. Beyond the screen nothing shows. */
  bool Hides(const ScreenRectangle& rectangle) const
  {
    return this->AtSamples ? this->AtSamples->Hide(this->Tiles, rectangle)
                           : this->SpansHide(rectangle);
  }

  /**
   * Whether all samples of a segment are covered by what is nearer. Beyond the screen nothing shows.
   * @param shown  takes a column where that is not so
   */
  bool Hides(int line, const HideableSegment& segment, float& shown) const;

  /** Whether all samples of a tile are covered by what is at least as near as `depth`, so that nothing that is farther need be inserted. */
  bool IsCoveredBefore(int line, int tile, float depth) const
  {
    return this->Tiles[this->Tiles.At(line, tile)] >= depth;
  }

  /** Of a tile on a line and on each of the seven above it: the least depth of all that covers it, or a number below all depths if it is not covered. */
  VITRINE_INLINE Lanes LeastDepths(int line, int tile) const
  {
    return this->Tiles.OfLines(line, tile);
  }

  /**
   * A bit for each line, up to eight from `line` up to `last`, of which a tile between two columns is not known to be covered by what is at least as near as `depth`: in others
   * nothing that is farther need be inserted.
   */
  unsigned OpenLines(int line, int last, float left, float right, float depth) const;

  /** The spans of a line, from left to right; of samples in place of spans, one without length for each that is covered. */
  std::vector<Span> SpansOf(int line) const;

  /** Adds to a number for each face how many columns of lines it has, or about so many. */
  void AddColumnsOfFaces(std::vector<float>& columns) const;

  const SBufferCounts& Counts() const { return this->Counted; }

private:
  template <class Orders>
  class Insertion;

  void InsertAtSamples(int line, const Segment& segment);

  static constexpr std::size_t DefaultMostSpans = 1u << 20;

  void Clear(int tile);
  std::uint32_t Allocate();
  void Free(std::uint32_t span);
  bool SpansHide(const ScreenRectangle& rectangle) const;
  template <class Work>
  bool ForEachCovered(std::uint32_t first, float left, float right, const Work& work) const;
  template <class Work>
  void ForEachSpan(std::uint32_t first, const Work& work) const;
  bool TileHides(
    std::size_t tile, float left, float right, const HideableSegment& segment, float& shown) const;
  bool PartOfTilesHides(
    int first, int last, int tile, float left, float right, float nearest) const;
  bool TileHides(std::size_t tile, float left, float right, float nearest) const;

  int ColumnCount;
  int LineCount;
  SampleGrid Grid;
  TileDepths Tiles;
  std::unique_ptr<SampleDepths> AtSamples; ///< null where there are spans
  std::vector<std::uint32_t> Firsts;       ///< of each tile's spans
  std::size_t MostSpans;
  std::unique_ptr<Span[]> Pool; ///< not written before it is used
  std::size_t Used = 0;
  std::uint32_t FirstFree = NoSpan;
  SBufferCounts Counted;
};

}

#endif
