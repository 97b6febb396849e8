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
 * One level of a hierarchical z-buffer (N. Greene, M. Kass, G. Miller: Hierarchical z-buffer visibility, SIGGRAPH 1993), over spans and samples.
 *
 * An s-buffer's lines cut into tiles of Width columns: of each the least depth of all that covers it, if it is full. Most questions are answered by that.
 * Tiles that stand one above the other lie side by side, so that those of eight lines are looked at together.
 */
class TileDepths
{
public:
  static constexpr int Width = 4;

  /** What stands in place of the least depth of a tile that is not full; below all depths. */
  static constexpr float NotFull = -BeyondAll;

  TileDepths(int columns, int lines)
    : TilesPerLine((columns + Width - 1) / Width)
    , Stride(static_cast<std::size_t>(lines) + LaneCount)
    , Leasts(this->Stride * static_cast<std::size_t>(this->TilesPerLine), NotFull)
    , AreTouched(static_cast<std::size_t>(this->TilesPerLine), 0)
  {
  }

  /** Something is kept in a tile of some line: so that what nothing was kept in need not be cleared. */
  void Touch(int tile) { this->AreTouched[static_cast<std::size_t>(tile)] = 1; }

  /** Whether something was, since that tile was cleared. */
  bool IsTouched(int tile) const { return this->AreTouched[static_cast<std::size_t>(tile)] != 0; }

  /** A tile of all lines. */
  void Clear(int tile)
  {
    const auto first = this->Leasts.begin() + static_cast<std::ptrdiff_t>(this->At(0, tile));
    std::fill(first, first + static_cast<std::ptrdiff_t>(this->Stride), NotFull);
    this->AreTouched[static_cast<std::size_t>(tile)] = 0;
  }

  /** Of all lines, and some more behind the last one, of which it says anything. */
  std::size_t Count() const { return this->Leasts.size(); }

  int CountPerLine() const { return this->TilesPerLine; }

  std::size_t At(int line, int tile) const
  {
    return static_cast<std::size_t>(tile) * this->Stride + static_cast<std::size_t>(line);
  }

  /** The tile that a column lies in, from 0 on. */
  int TileOf(float column) const
  {
    return std::min(static_cast<int>(column) / Width, this->TilesPerLine - 1);
  }

  float& operator[](std::size_t tile) { return this->Leasts[tile]; }
  float operator[](std::size_t tile) const { return this->Leasts[tile]; }

  /** Of the same tile of eight lines. */
  VITRINE_INLINE Lanes OfLines(int line, int tile) const
  {
    return LoadLanes(&this->Leasts[this->At(line, tile)]);
  }

  /** A bit for each line, up to eight from `line` up to `last`, of which a tile is not known to be covered by what is nearer. */
  VITRINE_INLINE unsigned Open(int line, int last, int tile, float nearest) const
  {
    return ~BitsOf(this->OfLines(line, tile) > AllLanes(nearest)) & LowBits(last + 1 - line);
  }

  /** As many bits as lines, up to all lanes. */
  static unsigned LowBits(int lines) { return (1u << std::min(lines, LaneCount)) - 1u; }

private:
  int TilesPerLine;
  std::size_t Stride;
  std::vector<float> Leasts;
  std::vector<std::uint8_t> AreTouched; ///< each tile of a line
};

}

#endif
