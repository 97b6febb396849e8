#include "study/image/PictureDifference.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::PictureView;
using Bytes = std::vector<std::uint8_t>;

/** 3 x 2 pixels of RGBA, all of them grey. */
Bytes GreyPixels()
{
  return Bytes(4 * 3 * 2, 100);
}

PictureView ViewOf(const Bytes& bytes)
{
  return { 3, 2, 4, bytes.data() };
}

TEST(PictureDifference, OfEqualPicturesIsNone)
{
  const Bytes grey = GreyPixels();
  const vitrine::PictureDifference difference =
    vitrine::FindDifference(ViewOf(grey), ViewOf(grey), 0);
  EXPECT_EQ(difference.Largest, 0);
  EXPECT_EQ(difference.DifferentPixels, 0u);
  EXPECT_TRUE(difference.First.empty());
}

TEST(PictureDifference, CountsPixelsByTheirLargestChannelAboveTheTolerance)
{
  const Bytes grey = GreyPixels();
  Bytes other = grey;
  other[4 * 1 + 3] = 97;  // the alpha of the second pixel of the bottom row
  other[4 * 3 + 0] = 101; // the first pixel of the top row
  other[4 * 3 + 1] = 90;
  const auto find = [&](int tolerance)
  { return vitrine::FindDifference(ViewOf(other), ViewOf(grey), tolerance); };
  for (const int tolerance : { 0, 3, 10 })
  {
    EXPECT_EQ(find(tolerance).Largest, 10);
  }
  EXPECT_EQ(find(0).DifferentPixels, 2u);
  EXPECT_EQ(find(2).DifferentPixels, 2u);
  EXPECT_EQ(find(3).DifferentPixels, 1u);
  EXPECT_EQ(find(9).DifferentPixels, 1u);
  EXPECT_EQ(find(10).DifferentPixels, 0u);
}

TEST(PictureDifference, NamesTheFirstPixelsFromTheTopLeft)
{
  const Bytes grey = GreyPixels();
  Bytes other = grey;
  other[4 * 1 + 3] = 97;
  other[4 * 3 + 1] = 90;
  const vitrine::PictureDifference difference =
    vitrine::FindDifference(ViewOf(other), ViewOf(grey), 0);
  ASSERT_EQ(difference.First.size(), 2u);
  EXPECT_EQ(vitrine::DescribeDifference(difference, "got", "expected"),
    "2 of 6 pixels differ, and the largest difference is 10/255\n"
    "  pixel 0, 0 from the top left: got 100 90 100 100, expected 100 100 100 100\n"
    "  pixel 1, 1 from the top left: got 100 100 100 97, expected 100 100 100 100");
  EXPECT_EQ(vitrine::DescribeDifference(
              vitrine::FindDifference(ViewOf(other), ViewOf(grey), 9), "got", "expected"),
    "1 of 6 pixels differ by more than 9/255, and the largest difference is 10/255\n"
    "  pixel 0, 0 from the top left: got 100 90 100 100, expected 100 100 100 100");
}

TEST(PictureDifference, NamesFiveAtMost)
{
  const Bytes grey = GreyPixels(), black(grey.size(), 0);
  const vitrine::PictureDifference difference =
    vitrine::FindDifference(ViewOf(black), ViewOf(grey), 0);
  EXPECT_EQ(difference.DifferentPixels, 6u);
  EXPECT_EQ(difference.First.size(), 5u);
}

TEST(PictureDifference, CountsPixelsOfAShare)
{
  vitrine::PictureDifference difference;
  difference.Pixels = 100;
  EXPECT_EQ(difference.PixelsOfShare(0.0), 0u);
  EXPECT_EQ(difference.PixelsOfShare(0.009), 0u);
  EXPECT_EQ(difference.PixelsOfShare(0.29), 29u); // 28.999... as doubles have it
  EXPECT_EQ(difference.PixelsOfShare(1.0), 100u);
}

TEST(PictureDifference, IsDrawnSoThatOneStepIsSeen)
{
  const Bytes grey = GreyPixels();
  Bytes other = grey;
  other[0] = 101;
  other[4] = 102;
  other[8] = 255;
  const Bytes drawn = vitrine::DrawDifference(ViewOf(other), ViewOf(grey), 1);
  const Bytes expected = { 0, 64, 192, 255, 2, 0, 255, 155, 0, 25, 25, 25, 25, 25, 25, 25, 25, 25 };
  EXPECT_EQ(drawn, expected);
}

}
