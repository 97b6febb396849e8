#ifndef VITRINE_CORE_CULLING_BUFFER_TILE_DEPTHS_H
#define VITRINE_CORE_CULLING_BUFFER_TILE_DEPTHS_H

#include "Core/geometry/BeyondAll.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * One level of a hierarchical z-buffer over spans or samples (N. Greene, M. Kass, G. Miller: Hierarchical z-buffer
 * visibility, SIGGRAPH 1993).
 *
 * The lines of an s-buffer are cut into tiles of Width columns. Each full tile has the least depth of its cover, which
 * answers most queries. Vertical neighbours are adjacent in memory, so that eight lines are processed at once.
 */
class TileDepths
{
public:
  static constexpr int Width = 4;

  /** The least depth of a tile that is not full. It is below all depths. */
  static constexpr float NotFull = -BeyondAll;

  TileDepths(int columns, int lines)
    : TilesPerLine((columns + Width - 1) / Width)
    , Stride(static_cast<std::size_t>(lines) + LaneCount)
    , Leasts(this->Stride * static_cast<std::size_t>(this->TilesPerLine), NotFull)
    , AreTouched(static_cast<std::size_t>(this->TilesPerLine), 0)
  {
  }

  /** Marks a tile of all lines as written, so that clearing can skip the others. */
  void Touch(int tile) { this->AreTouched[static_cast<std::size_t>(tile)] = 1; }

  /** Returns true if the tile was touched since it was last cleared. */
  bool IsTouched(int tile) const { return this->AreTouched[static_cast<std::size_t>(tile)] != 0; }

  /** Marks a tile of all lines as not full and untouched. */
  void Clear(int tile)
  {
    const auto first = this->Leasts.begin() + static_cast<std::ptrdiff_t>(this->At(0, tile));
    std::fill(first, first + static_cast<std::ptrdiff_t>(this->Stride), NotFull);
    this->AreTouched[static_cast<std::size_t>(tile)] = 0;
  }

  /** Returns the number of stored tiles. It includes LaneCount padding lines, whose values have no meaning. */
  std::size_t Count() const { return this->Leasts.size(); }

  int CountPerLine() const { return this->TilesPerLine; }

  std::size_t At(int line, int tile) const
  {
    return static_cast<std::size_t>(tile) * this->Stride + static_cast<std::size_t>(line);
  }

  /** Returns the tile that contains a column. The column must not be negative. */
  int TileOf(float column) const
  {
    return std::min(static_cast<int>(column) / Width, this->TilesPerLine - 1);
  }

  float& operator[](std::size_t tile) { return this->Leasts[tile]; }
  float operator[](std::size_t tile) const { return this->Leasts[tile]; }

  /** Returns the least depths of the same tile of eight lines. */
  VITRINE_INLINE Lanes OfLines(int line, int tile) const
  {
    return LoadLanes(&this->Leasts[this->At(line, tile)]);
  }

  /**
   * Returns a bit for each line from `line` to `last`, at most eight. The bit is 1 unless the tile is known to be
   * covered by surfaces nearer than `nearest`.
   */
  VITRINE_INLINE unsigned Open(int line, int last, int tile, float nearest) const
  {
    return ~BitsOf(this->OfLines(line, tile) > AllLanes(nearest)) & LowBits(last + 1 - line);
  }

  /** Returns a mask of the lowest min(lines, LaneCount) bits. */
  static unsigned LowBits(int lines) { return (1u << std::min(lines, LaneCount)) - 1u; }

private:
  int TilesPerLine;
  std::size_t Stride;
  std::vector<float> Leasts;
  std::vector<std::uint8_t> AreTouched; ///< One flag per tile of a line, for all lines.
};

}

#endif
