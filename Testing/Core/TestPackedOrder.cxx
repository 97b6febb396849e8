#include "Core/PackedOrder.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::BlockRange;
using vitrine::BlocksOf;
using vitrine::PackedListLengths;

constexpr int Side = 4;

TEST(PackedOrder, BlocksCoverTheirRegion)
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

// Lists of 0, 1, 2, ... fragments in the order of the buffer, each with a place to spare.
TEST(PackedOrder, LengthsAreThoseOfTheirPixels)
{
  const BlockRange blocks = BlocksOf({ 4, 4, 8, 8 }, Side);
  constexpr int width = 16;
  constexpr int height = 12;
  std::vector<std::uint32_t> heads(2 * width * height, 77u); // what lies outside must not matter
  std::vector<std::uint32_t> expected(width * height, 0u);
  std::uint32_t end = 0;
  for (int i = 0; i < 4 * Side * Side; ++i)
  {
    const int x = 4 + i / 16 % 2 * Side + i % Side;
    const int y = 4 + i / 32 * Side + i % 16 / Side;
    const auto length = static_cast<std::uint32_t>(i);
    heads[2 * (y * width + x) + 1] = end + length;
    end += length + 1;
    heads[2 * (y * width + x)] = end;
    expected[y * width + x] = length;
  }
  EXPECT_EQ(PackedListLengths(heads, width, blocks, Side), expected);
}

TEST(PackedOrder, CountsWithoutRoomAreLengths)
{
  const std::vector<std::uint32_t> heads = { 0, 5, 0, 0, 0, 9, 0, 1 };
  const std::vector<std::uint32_t> lengths = PackedListLengths(heads, 2, { { 0, 0 }, { 2, 2 } }, 1);
  EXPECT_EQ(lengths, (std::vector<std::uint32_t>{ 5, 0, 9, 1 }));
}

}
