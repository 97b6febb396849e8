#include "Core/PackedOrder.h"

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

std::vector<std::uint32_t> PackedListLengths(
  const std::vector<std::uint32_t>& heads, int width, const BlockRange& blocks, int side)
{
  std::vector<std::uint32_t> lengths(heads.size() / 2);
  std::uint32_t start = 0;
  for (int block = 0; block < blocks.Size(); ++block)
  {
    const int x = (blocks.First[0] + block % blocks.Count[0]) * side;
    const int y = (blocks.First[1] + block / blocks.Count[0]) * side;
    for (int i = 0; i < side * side; ++i)
    {
      const auto pixel = static_cast<std::size_t>(y + i / side) * width + x + i % side;
      lengths[pixel] = heads[2 * pixel + 1] - start;
      start = heads[2 * pixel];
    }
  }
  return lengths;
}

}
