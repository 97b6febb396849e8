// The sums that shaders keep in two words, added up as they do.
#include "Shaders/SharedLayout.h"

#include <gtest/gtest.h>

namespace
{

// What TileClassify.glsl's addPages() makes of `tiles` addends of `n`.
std::int64_t SumOver(std::uint32_t tiles, std::uint32_t n)
{
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  for (std::uint32_t tile = 0; tile < tiles; ++tile)
  {
    low += n & ((1u << VITRINE_SPLIT_BITS) - 1u);
    high += n >> VITRINE_SPLIT_BITS;
  }
  return vitrine::JoinSplitSum(low, high);
}

TEST(SplitSum, HoldsTheLargestImages)
{
  constexpr std::uint32_t pixelsOfATile = VITRINE_TILE_SIZE * VITRINE_TILE_SIZE;
  struct Image
  {
    std::uint32_t Side;
    std::uint32_t Layers; // in every pixel
  };
  for (const Image& image :
    { Image{ 4096, 1 }, Image{ 8192, 255 }, Image{ 16384, 16383 }, Image{ 32768, 4095 } })
  {
    const std::uint32_t tiles = (image.Side / VITRINE_TILE_SIZE) * (image.Side / VITRINE_TILE_SIZE);
    // Some pixels less in each tile, so that all of its low bits are set.
    for (const std::uint32_t missing : { 0u, 1u })
    {
      const std::uint32_t addend = pixelsOfATile * image.Layers - missing;
      EXPECT_EQ(SumOver(tiles, addend), std::int64_t(tiles) * addend)
        << image.Side << " pixels a side, " << addend << " fragments a tile";
    }
  }
}

}
