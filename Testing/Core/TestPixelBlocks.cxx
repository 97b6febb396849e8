#include "Core/lists/PixelBlocks.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::BlockRange;
using vitrine::BlocksOf;

constexpr int Side = 4;

TEST(PixelBlocks, BlocksCoverTheirRegion)
{
  const BlockRange one = BlocksOf({ 4, 8, 4, 4 }, Side);
  EXPECT_EQ(one, (BlockRange{ { 1, 2 }, { 1, 1 } }));
  const BlockRange touched = BlocksOf({ 3, 7, 6, 2 }, Side);
  EXPECT_EQ(touched, (BlockRange{ { 0, 1 }, { 3, 2 } }));
  EXPECT_EQ(touched.Size(), 6);
  const vitrine::PixelRegion pixels = PixelsOf(touched, Side);
  EXPECT_EQ(pixels.X, 0);
  EXPECT_EQ(pixels.Y, 4);
  EXPECT_EQ(pixels.Width, 12);
  EXPECT_EQ(pixels.Height, 8);
}

}
