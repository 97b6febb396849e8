/** Which rank of several owns which pixels of a picture. */
#ifndef VITRINE_CORE_RANKS_TILE_OWNERS_H
#define VITRINE_CORE_RANKS_TILE_OWNERS_H

#include "Core/geometry/PixelRegion.h"

#include <vector>

namespace vitrine
{

/**
 * Gives each tile of a picture to a rank. Neighbours in a row, and with more than one rank in a column too, have
 * different owners, so that a small deep part of a picture is shared by many.
 */
class TileOwners
{
public:
  static constexpr int TileSize = 32; ///< pixels a side

  /** Divide the pixels of `region` among `ranks` ranks, of which there is at least one. */
  TileOwners(const PixelRegion& region, int ranks);

  /** Returns the rank that owns a tile, which is counted from that of pixel 0, 0. */
  int OwnerOf(int column, int row) const { return (column + row * this->Step) % this->Ranks; }

  /**
   * Returns the parts of a rank's tiles that lie in the region, by rows from the bottom. Messages list pixels in this
   * order, and in each part by rows from the bottom.
   */
  const std::vector<PixelRegion>& TilesOf(int rank) const { return this->Tiles[rank]; }

  /** Returns the number of pixels that a rank owns. */
  int PixelsOf(int rank) const { return this->Pixels[rank]; }

  int Count() const { return this->Ranks; }

private:
  int Ranks;
  int Step;
  std::vector<std::vector<PixelRegion>> Tiles;
  std::vector<int> Pixels;
};

/** Calls `visit(x, y)` for the pixels of `tiles` in the order of messages. */
template <class Visit>
void ForEachPixel(const std::vector<PixelRegion>& tiles, const Visit& visit)
{
  for (const PixelRegion& tile : tiles)
  {
    for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
    {
      for (int x = tile.X; x < tile.X + tile.Width; ++x)
      {
        visit(x, y);
      }
    }
  }
}

}

#endif
