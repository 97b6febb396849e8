#include "Core/ranks/TileOwners.h"

#include "Core/geometry/Rounding.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace vitrine
{
namespace
{

// Returns by how many ranks the owners of a row of tiles are moved against those of the row below. It is near the
// golden section of `ranks` and shares no divisor with it, so that each column has all ranks, far from each other.
int StepOf(int ranks)
{
  int step = std::max(1, int(0.618 * ranks + 0.5));
  while (std::gcd(step, ranks) != 1)
  {
    ++step;
  }
  return step;
}

}

TileOwners::TileOwners(const PixelRegion& region, int ranks)
  : Ranks(ranks)
  , Step(StepOf(ranks))
  , Tiles(ranks)
  , Pixels(ranks)
{
  assert(ranks > 0 && region.X >= 0 && region.Y >= 0);
  const int columns = DividedUp(region.X + region.Width, TileSize);
  const int rows = DividedUp(region.Y + region.Height, TileSize);
  for (int row = region.Y / TileSize; row < rows; ++row)
  {
    for (int column = region.X / TileSize; column < columns; ++column)
    {
      const int x = std::max(region.X, column * TileSize);
      const int y = std::max(region.Y, row * TileSize);
      const int endX = std::min(region.X + region.Width, (column + 1) * TileSize);
      const int endY = std::min(region.Y + region.Height, (row + 1) * TileSize);
      const int owner = this->OwnerOf(column, row);
      this->Tiles[owner].push_back({ x, y, endX - x, endY - y });
      this->Pixels[owner] += (endX - x) * (endY - y);
    }
  }
}

}
