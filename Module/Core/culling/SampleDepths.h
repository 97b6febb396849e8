#ifndef VITRINE_CORE_CULLING_SAMPLE_DEPTHS_H
#define VITRINE_CORE_CULLING_SAMPLE_DEPTHS_H

#include "Core/culling/Lanes.h"
#include "Core/culling/SampleGrid.h"
#include "Core/culling/TileDepths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

struct HideableSegment;
struct ScreenRectangle;

/**
 * What an s-buffer keeps where lines have few places with samples: the depth of what covers each of them, and whose it is. That is all that spans tell of them; it takes a step for eight
 * of them, where a list of spans takes one for each, and none can be foreseen.
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

  /** Nothing is covered. */
  void Clear();

  /** The samples of a line that lie between two columns: none where First exceeds Last. */
  struct Range
  {
    int First;
    int Last;
  };

  /** Of columns of the screen, or of lines: nothing is rounded in that. */
  Range Between(float left, float right) const
  {
    return { static_cast<int>(std::ceil(left * this->PerColumn - 0.5f)),
      static_cast<int>(std::floor(right * this->PerColumn - 0.5f)) };
  }

  /**
   * Keeps what is nearer than what covers samples.
   * @param tiles    takes what changes of the tiles
   * @param depthAt  depths at eight columns
   * @returns        how many depths were compared
   */
  template <class DepthAt>
  VITRINE_INLINE int Insert(
    TileDepths& tiles, int line, const Range& range, std::uint32_t face, const DepthAt& depthAt)
  {
    float* const depths = &this->Depths[this->At(line)];
    std::uint32_t* const faces = &this->Faces[this->At(line)];
    unsigned changed = 0;
    for (int i = range.First; i <= range.Last; i += LaneCount)
    {
      const Lanes old = LoadLanes(depths + i);
      const Lanes depth = depthAt(LoadLanes(&this->Places[static_cast<std::size_t>(i)]));
      const LaneMask isNearer = AreFirst(range.Last + 1 - i) & (depth > old);
      StoreLanes(isNearer ? depth : old, depths + i);
      StoreMask(
        isNearer ? LaneMask{} + static_cast<std::int32_t>(face) : LoadMask(faces + i), faces + i);
      changed |= BitsOf(isNearer);
    }
    if (changed != 0)
    {
      this->UpdateTiles(tiles, line, range);
    }
    return range.Last + 1 - range.First;
  }

  /** Whether all samples in a rectangle are covered by what is nearer. Beyond the screen nothing shows. */
  bool Hide(const TileDepths& tiles, const ScreenRectangle& rectangle) const;

  /** The same of a segment between two columns, which are places with samples. */
  bool Hide(int line, float left, float right, const HideableSegment& segment, float& shown) const;

  /** The least depth of a column's samples, or NotCovered. */
  float DepthOfColumn(int line, int column) const;

  /** Adds to a number for each face how many columns it has. */
  void AddColumnsOfFaces(std::vector<float>& columns) const;

  /** Does something with each sample of a line that is covered: with its column, its depth, and whose it is. */
  template <class Work>
  void ForEachOn(int line, const Work& work) const
  {
    for (int i = 0; i < this->CountPerLine; ++i)
    {
      const std::size_t at = this->At(line) + static_cast<std::size_t>(i);
      if (this->Depths[at] != NotCovered)
      {
        work(this->Places[static_cast<std::size_t>(i)], this->Depths[at], this->Faces[at]);
      }
    }
  }

private:
  static constexpr int MostPerColumn = 4;
  static constexpr float BehindColumns = 3e38f; // nothing shows there

  static VITRINE_INLINE LaneMask AreFirst(int count)
  {
    return LaneMask{ 0, 1, 2, 3, 4, 5, 6, 7 } < LaneMask{} + count;
  }

  std::size_t At(int line) const
  {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(this->Stride);
  }

  /** Of a sample. */
  int TileOf(int i) const
  {
    return static_cast<int>(this->Places[static_cast<std::size_t>(i)]) / TileDepths::Width;
  }

  VITRINE_INLINE void UpdateTiles(TileDepths& tiles, int line, const Range& range) const
  {
    const int last = this->TileOf(range.Last);
    for (int tile = this->TileOf(range.First); tile <= last; ++tile)
    {
      const float* const depths = &this->Depths[this->At(line)] + tile * this->CountPerTile;
      float least = BehindColumns;
      for (int i = 0; i < this->CountPerTile; i += TileDepths::Width)
      {
        least = std::min(least,
          std::min(std::min(depths[i], depths[i + 1]), std::min(depths[i + 2], depths[i + 3])));
      }
      tiles[tiles.At(line, tile)] = least;
    }
  }

  /** Of a row of samples. */
  int LineOf(int row) const
  {
    return static_cast<int>((static_cast<float>(row) + 0.5f) * this->Width);
  }

  bool RowsHide(const Range& lines, const Range& range, float nearest) const;
  bool TilesHide(
    const TileDepths& tiles, const Range& lines, const Range& range, float nearest) const;

  int CountPerColumn;
  float PerColumn; ///< the same
  float Width;     ///< of a sample, in columns
  int CountPerTile;
  int CountPerLine;
  float ColumnCount;
  float LineCount;
  int Stride; ///< from line to line: its samples, and some more behind the last column
  std::vector<float> Places; ///< of the samples of a line: columns
  std::vector<float> Depths; ///< line after line
  std::vector<std::uint32_t> Faces;
};

}

#endif
