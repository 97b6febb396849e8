/**
 * The s-buffer of occlusion culling: each line of the screen holds a sorted list of spans.
 *
 * One line in x against reversed depth (1 is near, 0 is far), and the insertion of a segment C:
 *
 *         before                               after Insert(line, C)
 *     1 |                                  1 |
 *       |    AAAAAAAA                        |    AAAAAAAA
 *       |        CCCCCCCCCCCCCCC             |            CCCCCCCCCCC
 *       |                  BBBBBBBBBBBB      |                       BBBBBBB
 *     0 +--------------------------------> x +--------------------------------> x
 *
 * C stays hidden behind A, fills the gap, and replaces the part of B that it covers. Segments that cross in depth are
 * cut at the crossing.
 */
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
 * A part of an occluder on one line of an s-buffer. It covers all samples of the line from Left to Right, in columns.
 * Depth is reversed (1 at the near plane, 0 at the far plane) and linear between the ends. The drawn surface is nowhere
 * farther than this depth.
 */
struct Segment
{
  float Left;
  float Right;
  float LeftDepth;
  float RightDepth;
  std::uint32_t Face; ///< The face that the segment belongs to. The caller chooses the numbers.
};

/** A covered interval of a line. */
struct Span
{
  float Left;
  float Right;
  float Depth; ///< Reversed depth at Left.
  float Slope; ///< Change of depth per column.
  std::uint32_t Face;
  std::uint32_t Next; ///< The next span to the right in the same tile, or NoSpan.

  float DepthAt(float x) const { return this->Depth + this->Slope * (x - this->Left); }
};

/**
 * A candidate for being hidden on one line, from Left to Right. It is nowhere nearer than DepthAt(x), which is linear
 * in the column x, and nowhere nearer than Nearest. Depths are reversed; all numbers are real.
 */
struct HideableSegment
{
  float Left;
  float Right;
  float Column; ///< The column at which the depth is Depth.
  float Depth;
  float Slope; ///< Change of depth per column.
  float Nearest;

  float DepthAt(float x) const { return this->Depth + this->Slope * (x - this->Column); }

  float NearestAt(float x) const
  {
    const float depth = this->DepthAt(x);
    return depth < this->Nearest ? depth : this->Nearest; // This also replaces NaN.
  }
};

/** Hideable segments on eight lines. All but their depths and ends are equal. */
struct HideableSegmentLanes
{
  float Depths[LaneCount]; ///< Depths at Column.
  float Column;
  float Slope;
  float Nearest;
};

/** Returns a segment as a candidate for being hidden, nearer by `margin`. The segment's length must not be 0. */
inline HideableSegment Hideable(const Segment& segment, float margin = 0.0f)
{
  const float slope = (segment.RightDepth - segment.LeftDepth) / (segment.Right - segment.Left);
  return { segment.Left, segment.Right, segment.Left, segment.LeftDepth + margin, slope,
    BeyondAll };
}

/** Counters since Clear(). */
struct SBufferCounts
{
  std::uint64_t Inserted = 0;    ///< Inserted segments.
  std::uint64_t Comparisons = 0; ///< Comparisons of two depths at one place.
  std::uint64_t Changed = 0;     ///< Calls of InsertLines() that changed a sample.
  std::uint64_t Refused = 0;     ///< Pieces of segments that found the span pool exhausted.
};

/**
 * An s-buffer. Each line of the screen is a sorted list of covered spans, and each span keeps the nearest known face
 * (A. V. Boreskov, the hierarchical s-buffer). A line stands for all pixels in it, and a span covers all their samples.
 * Ends of spans are real numbers, so the number of columns only sets the unit.
 *
 * Lines are cut into tiles. Each tile has its own list, and the least depth of its cover if it is full. The least depth
 * answers most queries.
 *
 * Spans come from a pool. Once the pool is exhausted, insertions are dropped. So the buffer hides less, never too much.
 * If there are few samples per line, their depths replace the spans (SampleDepths).
 */
class SBuffer
{
public:
  static constexpr std::uint32_t NoSpan = 0xffffffffu;
  static constexpr int TileWidth = TileDepths::Width;

  /** Creates an empty buffer. Both `columns` and `lines` must be at least 1. */
  SBuffer(int columns, int lines, const SampleGrid& samples = {},
    std::size_t mostSpans = DefaultMostSpans);

  /** Creates an empty buffer that keeps sample depths if SampleDepths::Suit(samples), else spans. */
  static SBuffer WithFewSamples(int columns, int lines, const SampleGrid& samples);

  const SampleGrid& Samples() const { return this->Grid; }

  int Columns() const { return this->ColumnCount; }
  int Lines() const { return this->LineCount; }

  /** Uncovers everything and resets the counters. */
  void Clear();

  /**
   * Inserts a segment and keeps the parts that are nearer than the stored spans. Segments that have no length or are
   * not finite are ignored.
   */
  void Insert(int line, const Segment& segment);

  /**
   * Inserts like Insert(), but uses known depth orders to avoid comparisons (SBufferInsertion.h). The buffer must hold
   * spans.
   */
  template <class Orders>
  void InsertBy(Orders& orders, int line, const Segment& segment);

  /** Returns the sample depths, or null if the buffer holds spans. */
  const SampleDepths* BySample() const { return this->AtSamples.get(); }

  /**
   * Inserts a surface on `line` and the seven lines above it. The buffer must hold sample depths.
   * @param left     first covered column of each line, on the screen; BeyondAll on lines that are not covered
   * @param right    last covered column of each line; below all columns on lines that are not covered
   * @param depthAt  returns the depths of all eight lines at a column
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

  /** Returns true if nearer surfaces cover all samples in the rectangle. Parts beyond the screen count as hidden. */
  bool Hides(const ScreenRectangle& rectangle) const
  {
    return this->AtSamples ? this->AtSamples->Hide(this->Tiles, rectangle)
                           : this->SpansHide(rectangle);
  }

  /**
   * Returns true if nearer surfaces cover all samples of a segment. Parts beyond the screen count as hidden.
   * @param shown  receives a column where the segment is visible, if the result is false
   */
  bool Hides(int line, const HideableSegment& segment, float& shown) const;

  /**
   * Returns true if surfaces at `depth` or nearer cover all samples of a tile. Farther surfaces need no insertion
   * there.
   */
  bool IsCoveredBefore(int line, int tile, float depth) const
  {
    return this->Tiles[this->Tiles.At(line, tile)] >= depth;
  }

  /**
   * Returns the least depth of a tile's cover for `line` and the seven lines above it. It is below all depths if the
   * tile is not full.
   */
  VITRINE_INLINE Lanes LeastDepths(int line, int tile) const
  {
    return this->Tiles.OfLines(line, tile);
  }

  /**
   * Returns a bit for each line from `line` to `last`, at most eight. The bit is 0 if all tiles between the columns
   * `left` and `right` are known to be covered at `depth` or nearer. Farther surfaces need no insertion on such a line.
   */
  unsigned OpenLines(int line, int last, float left, float right, float depth) const;

  /** Returns the spans of a line from left to right. Sample depths are returned as spans of length 0. */
  std::vector<Span> SpansOf(int line) const;

  /**
   * Adds to columns[face] the number of columns that the face covers, summed over all lines. With sample depths the
   * number is approximate.
   */
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
  std::unique_ptr<SampleDepths> AtSamples; ///< Null if the buffer holds spans.
  std::vector<std::uint32_t> Firsts;       ///< The first span of each tile.
  std::size_t MostSpans;
  std::unique_ptr<Span[]> Pool; ///< Left uninitialised until a span is allocated.
  std::size_t Used = 0;
  std::uint32_t FirstFree = NoSpan;
  SBufferCounts Counted;
};

}

#endif
