#include "Core/ranks/TileOwners.h"

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

TileOwners::TileOwners(const PixelRegion& region, int width, int ranks)
  : Region(region)
  , Width(width)
  , Ranks(ranks)
  , Step(StepOf(ranks))
  , Pixels(ranks)
{
  assert(ranks > 0 && region.X >= 0 && region.Y >= 0 && region.X + region.Width <= width);
  for (int row = region.Y / TileSize; row * TileSize < region.Y + region.Height; ++row)
  {
    for (int column = region.X / TileSize; column * TileSize < region.X + region.Width; ++column)
    {
      this->AddTile(column, row);
    }
  }
}

void TileOwners::AddTile(int column, int row)
{
  const PixelRegion& r = this->Region;
  const int firstX = std::max(r.X, column * TileSize);
  const int endX = std::min(r.X + r.Width, (column + 1) * TileSize);
  const int endY = std::min(r.Y + r.Height, (row + 1) * TileSize);
  OwnedPixels& pixels = this->Pixels[this->OwnerOf(column, row)];
  for (int y = std::max(r.Y, row * TileSize); y < endY; ++y)
  {
    for (int x = firstX; x < endX; ++x)
    {
      pixels.push_back(static_cast<std::uint32_t>(y) * this->Width + x);
    }
  }
}

}
