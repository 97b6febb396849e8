#ifndef VITRINE_CORE_CULLING_BUFFER_SAMPLE_DEPTHS_H
#define VITRINE_CORE_CULLING_BUFFER_SAMPLE_DEPTHS_H

#include "Core/culling/buffer/TileDepths.h"
#include "Core/geometry/BeyondAll.h"
#include "Core/geometry/Lanes.h"
#include "Core/geometry/SampleGrid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

struct HideableSegment;
struct HideableSegmentLanes;
struct ScreenRectangle;

/**
 * The content of an s-buffer whose lines have few samples: the depth and the face that cover each sample. Spans would
 * tell no more. Eight lines are processed in one step, without the unpredictable branches of span lists.
 */
class SampleDepths
{
public:
  /** The depth of an uncovered sample. It is below all depths. */
  static constexpr float NotCovered = TileDepths::NotFull;

  /** Returns true if samples are few enough for sample depths to be faster than spans. */
  static bool Suit(const SampleGrid& grid)
  {
    const int perColumn = grid.BinaryPixelsPerColumn();
    return perColumn > 0 && perColumn <= MostPerColumn;
  }

  /** Creates uncovered samples. Suit(grid) must be true. */
  SampleDepths(int columns, int lines, const SampleGrid& grid);

  /** Uncovers a tile of all lines. */
  void Clear(int tile);

  /** Samples of a line, both ends included. The range is empty if First exceeds Last. */
  struct Range
  {
    int First;
    int Last;
  };

  /**
   * Returns the samples between two columns of the screen, or the sample rows between two lines. The computation is
   * exact.
   */
  Range Between(float left, float right) const
  {
    assert(left >= 0.0f && right <= std::max(this->ColumnCount, this->LineCount));
    return { static_cast<int>(std::ceil(left * this->PerColumn - 0.5f)),
      static_cast<int>(std::floor(right * this->PerColumn - 0.5f)) };
  }

  /**
   * Keeps the nearer depth at each sample of a range on one line.
   * @param tiles    receives the new least depths
   * @param depthAt  returns the depth at a column
   */
  template <class DepthAt>
  void Insert(
    TileDepths& tiles, int line, const Range& range, std::uint32_t face, const DepthAt& depthAt)
  {
    bool hasChanged = false;
    for (int i = range.First; i <= range.Last; ++i)
    {
      const std::size_t at = this->At(i, line);
      const float depth = depthAt(this->Places[static_cast<std::size_t>(i)]);
      if (depth > this->Depths[at])
      {
        this->Depths[at] = depth;
        this->Faces[at] = face;
        hasChanged = true;
      }
    }
    if (hasChanged)
    {
      this->UpdateTilesOf(tiles, line, range);
    }
  }

  /**
   * Keeps the nearer depth on `line` and the seven lines above it. Lines above the screen are ignored.
   * @param range    contains the covered samples of all lines
   * @param left     first covered column of each line
   * @param right    last covered column of each line
   * @param depthAt  returns the depths of all eight lines at a column
   * @returns        true if a sample changed
   */
  template <class DepthAt>
  VITRINE_INLINE bool InsertLines(TileDepths& tiles, int line, const Range& range, Lanes left,
    Lanes right, std::uint32_t face, const DepthAt& depthAt)
  {
    const LaneMask faces = LaneMask{} + static_cast<std::int32_t>(face);
    LaneMask hasChanged{};
    for (int i = range.First; i <= range.Last; ++i)
    {
      const float place = this->Places[static_cast<std::size_t>(i)];
      float* const depths = &this->Depths[this->At(i, line)];
      std::uint32_t* const owners = &this->Faces[this->At(i, line)];
      const Lanes old = LoadLanes(depths), depth = depthAt(place);
      const LaneMask isNearer = (left <= place) & (right >= place) & (depth > old);
      StoreLanes(Chosen(isNearer, depth, old), depths);
      StoreMask(Chosen(isNearer, faces, LoadMask(owners)), owners);
      hasChanged |= isNearer;
    }
    const bool isKept = BitsOf(hasChanged) != 0;
    if (isKept)
    {
      this->UpdateTiles(tiles, line, range);
    }
    return isKept;
  }

  /** Returns true if nearer surfaces cover all samples in a rectangle. Parts beyond the screen count as hidden. */
  bool Hide(const TileDepths& tiles, const ScreenRectangle& rectangle) const;

  /**
   * Returns true if nearer surfaces cover all samples of a segment between two columns. Both columns are places of
   * samples.
   * @param shown  receives a column where the segment is visible, if the result is false
   */
  bool Hide(int line, float left, float right, const HideableSegment& segment, float& shown) const;

  /**
   * Looks for a visible sample of segments on `line` and the seven lines above it.
   * @param left   first column of each line; it exceeds `right` on lines without a segment or above the screen
   * @param right  last column of each line
   * @param shown  receives a column where a segment is visible, if there is one
   * @returns      a bit for each line that is visible at that column; 0 if all segments are hidden
   */
  unsigned FindOpen(int line, const float* left, const float* right,
    const HideableSegmentLanes& segments, float& shown) const;

  /** Returns the least depth of a column's samples, or NotCovered. */
  float DepthOfColumn(int line, int column) const;

  /** Adds to columns[face] the number of columns that the face covers in touched tiles, summed over all lines. */
  void AddColumnsOfFaces(const TileDepths& tiles, std::vector<float>& columns) const;

  /** Calls work(column, depth, face) for each covered sample of a line. */
  template <class Work>
  void ForEachOn(int line, const Work& work) const
  {
    for (int i = 0; i < this->CountPerLine; ++i)
    {
      const std::size_t at = this->At(i, line);
      if (this->Depths[at] != NotCovered)
      {
        work(this->Places[static_cast<std::size_t>(i)], this->Depths[at], this->Faces[at]);
      }
    }
  }

private:
  static constexpr int MostPerColumn = 4;

  /** Returns the index of sample `i` of a line. */
  std::size_t At(int i, int line) const
  {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(this->Stride) +
      static_cast<std::size_t>(line);
  }

  /** Returns the line that a row of samples lies in. */
  int LineOf(int row) const { return row >> this->BitsPerColumn; }

  /** Returns the tile that sample `i` of a line lies in. */
  int TileOf(int i) const { return (i >> this->BitsPerColumn) / TileDepths::Width; }

  void AddColumnsOfFaces(int sample, std::vector<float>& columns) const;

  /** Returns the first sample behind a tile. */
  int EndOf(int tile) const
  {
    return std::min((tile + 1) * this->CountPerTile, this->CountPerLine);
  }

  /** Updates the least depths of the tiles of one line. */
  void UpdateTilesOf(TileDepths& tiles, int line, const Range& range) const
  {
    for (int tile = this->TileOf(range.First); tile <= this->TileOf(range.Last); ++tile)
    {
      float least = BeyondAll;
      for (int i = tile * this->CountPerTile; i < (tile + 1) * this->CountPerTile; ++i)
      {
        least = std::min(least, this->Depths[this->At(i, line)]);
      }
      tiles[tiles.At(line, tile)] = least;
      tiles.Touch(tile);
    }
  }

  /** Updates the least depths of the tiles of `line` and the seven lines above it. */
  VITRINE_INLINE void UpdateTiles(TileDepths& tiles, int line, const Range& range) const
  {
    const int last = this->TileOf(range.Last);
    for (int tile = this->TileOf(range.First); tile <= last; ++tile)
    {
      const float* depths = &this->Depths[this->At(tile * this->CountPerTile, line)];
      Lanes least = LoadLanes(depths);
      for (int i = 1; i < this->CountPerTile; ++i)
      {
        depths += this->Stride;
        least = LeastOf(least, LoadLanes(depths));
      }
      StoreLanes(least, &tiles[tiles.At(line, tile)]);
      tiles.Touch(tile);
    }
  }

  bool ColumnsHide(const Range& lines, int first, int end, float nearest) const;

  int CountPerColumn;
  int BitsPerColumn; ///< The base-2 logarithm of CountPerColumn.
  float PerColumn;   ///< CountPerColumn as a float.
  float Width;       ///< Width of a sample in columns.
  int CountPerTile;
  int CountPerLine;
  float ColumnCount;
  float LineCount;
  /** Distance in memory between horizontal neighbours: the number of lines and LaneCount of padding. */
  int Stride;
  std::vector<float> Places; ///< Columns of the samples of a line.
  /** Depths, column-major: vertical neighbours are adjacent, so that eight lines load at once. */
  std::vector<float> Depths;
  std::vector<std::uint32_t> Faces;
};

}

#endif
