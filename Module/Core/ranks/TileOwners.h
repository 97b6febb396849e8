/** Which rank of several owns which pixels of a picture. */
#ifndef VITRINE_CORE_RANKS_TILE_OWNERS_H
#define VITRINE_CORE_RANKS_TILE_OWNERS_H

#include "Core/geometry/PixelRegion.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Numbers of pixels in the order of messages. */
using OwnedPixels = std::vector<std::uint32_t>;

/**
 * Gives each tile of a picture to a rank. Neighbours in a row, and with more than one rank in a column too, have
 * different owners, so that a small deep part of a picture is shared by many.
 */
class TileOwners
{
public:
  static constexpr int TileSize = 32; ///< pixels a side

  TileOwners() = default;

  /** Divide the pixels of `region` of a picture of `width` pixels a row among `ranks` ranks, of which there is one. */
  TileOwners(const PixelRegion& region, int width, int ranks);

  /** Returns the rank that owns a tile, which is counted from that of pixel 0, 0. */
  int OwnerOf(int column, int row) const { return (column + row * this->Step) % this->Ranks; }

  /**
   * Returns the pixels that a rank owns in the region: tile by tile, and in each by rows from the bottom. Messages list
   * pixels in this order. Pixels of the picture are counted by rows from the bottom.
   */
  const OwnedPixels& PixelsOf(int rank) const { return this->Pixels[rank]; }

  /** Returns true if these are the owners of such a picture. */
  bool Divide(const PixelRegion& region, int width, int ranks) const
  {
    return this->Region == region && this->Width == width && this->Ranks == ranks;
  }

private:
  void AddTile(int column, int row);

  PixelRegion Region;
  int Width = 0;
  int Ranks = 0;
  int Step = 0;
  std::vector<OwnedPixels> Pixels;
};

}

#endif
