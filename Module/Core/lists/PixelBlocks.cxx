#include "Core/lists/PixelBlocks.h"

#include <cassert>

namespace vitrine
{

BlockRange BlocksOf(const PixelRegion& region, int side)
{
  assert(!region.IsEmpty() && side > 0);
  BlockRange blocks;
  blocks.First[0] = region.X / side;
  blocks.First[1] = region.Y / side;
  blocks.Count[0] = (region.X + region.Width - 1) / side - blocks.First[0] + 1;
  blocks.Count[1] = (region.Y + region.Height - 1) / side - blocks.First[1] + 1;
  return blocks;
}

PixelRegion PixelsOf(const BlockRange& blocks, int side)
{
  return { blocks.First[0] * side, blocks.First[1] * side, blocks.Count[0] * side,
    blocks.Count[1] * side };
}

}
