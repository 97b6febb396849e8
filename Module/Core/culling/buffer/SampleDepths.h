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
 * What an s-buffer keeps where lines have few places with samples: the depth of what covers each of them, and whose it is. That is all that spans tell of them; it takes a step for those of eight
 * lines, where lists of spans take one for each, and none can be foreseen.
 */
class SampleDepths
{
public:
  /** What stands where nothing covers a sample; below all depths. */
  static constexpr float NotCovered = TileDepths::NotFull;

  /** Whether samples are few enough that this takes less than spans do. */
  static bool Suit(const SampleGrid& grid)
  {
    const int perColumn = grid.BinaryPixelsPerColumn();
    return perColumn > 0 && perColumn <= MostPerColumn;
  }

  /** Of samples that it suits. */
  SampleDepths(int columns, int lines, const SampleGrid& grid);

  /** Nothing is covered of a tile of all lines. */
  void Clear(int tile);

  /** The samples of a line that lie between two columns: none where First exceeds Last. */
  struct Range
  {
    int First;
    int Last;
  };

  /** Of columns of the screen, or of lines: nothing is rounded in that. */
  Range Between(float left, float right) const
  {
    assert(left >= 0.0f && right <= std::max(this->ColumnCount, this->LineCount));
    return { static_cast<int>(std::ceil(left * this->PerColumn - 0.5f)),
      static_cast<int>(std::floor(right * this->PerColumn - 0.5f)) };
  }

  /**
   * Keeps what is nearer than what covers samples of a line.
   * @param tiles    takes what changes of the tiles
   * @param depthAt  the depth at a column
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
   * The same of a line and the seven above it, some of which may not be on the screen.
   * @param range    around all that is covered
   * @param left     columns that each line is covered between
   * @param depthAt  the depths of all lines at a column
   * @returns        whether anything was kept
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
      StoreLanes(isNearer ? depth : old, depths);
      StoreMask(isNearer ? faces : LoadMask(owners), owners);
      hasChanged |= isNearer;
    }
    const bool isKept = BitsOf(hasChanged) != 0;
    if (isKept)
    {
      this->UpdateTiles(tiles, line, range);
    }
    return isKept;
  }

  /** Whether all samples in a rectangle are covered by what is nearer. Beyond the screen nothing shows. */
  bool Hide(const TileDepths& tiles, const ScreenRectangle& rectangle) const;

  /** The same of a segment between two columns, which are places with samples. */
  bool Hide(int line, float left, float right, const HideableSegment& segment, float& shown) const;

  /**
   * The same of a segment on a line and on each of the seven above it.
   * @param left    columns, as `right`; of lines that have none, and of those that are not on the screen, left exceeds right
   * @param shown   takes a column where one is not hidden
   * @returns       a bit for each line that is not hidden there; 0 if all are
   */
  unsigned FindOpen(int line, const float* left, const float* right,
    const HideableSegmentLanes& segments, float& shown) const;

  /** The least depth of a column's samples, or NotCovered. */
  float DepthOfColumn(int line, int column) const;

  /** Adds to a number for each face how many columns it has in tiles that were touched. */
  void AddColumnsOfFaces(const TileDepths& tiles, std::vector<float>& columns) const;

  /** Does something with each sample of a line that is covered: with its column, its depth, and whose it is. */
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

  /** Of a sample of a line. */
  std::size_t At(int i, int line) const
  {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(this->Stride) +
      static_cast<std::size_t>(line);
  }

  /** Of a row of samples. */
  int LineOf(int row) const { return row >> this->BitsPerColumn; }

  /** Of a sample of a line. */
  int TileOf(int i) const { return (i >> this->BitsPerColumn) / TileDepths::Width; }

  void AddColumnsOfFaces(int sample, std::vector<float>& columns) const;

  /** The sample behind the last one of a tile. */
  int EndOf(int tile) const
  {
    return std::min((tile + 1) * this->CountPerTile, this->CountPerLine);
  }

  /** On a line. */
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

  /** On a line and the seven above it. */
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
  int BitsPerColumn; ///< 0, 1 or 2, for 1, 2 or 4
  float PerColumn;   ///< as many
  float Width;       ///< of a sample, in columns
  int CountPerTile;
  int CountPerLine;
  float ColumnCount;
  float LineCount;
  int
    Stride; ///< from a sample to the one on its right: lines, and some more that are not on the screen
  std::vector<float> Places; ///< of the samples of a line: columns
  std::vector<float>
    Depths; ///< those that stand one above the other lie side by side, so that eight lines are looked at together
  std::vector<std::uint32_t> Faces;
};

}

#endif
