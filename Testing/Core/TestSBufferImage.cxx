// An s-buffer as a picture.

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/buffer/SBufferImage.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using vitrine::DepthImage;
using vitrine::SBuffer;

using Picture = std::vector<float>;

}

TEST(SBufferImage, OfNothingIsZero)
{
  EXPECT_EQ(DepthImage(SBuffer(3, 2)), Picture(6, 0.0f));
}

TEST(SBufferImage, HasTheDepthOfTheMiddleOfEachColumnLineByLineFromTheBottom)
{
  SBuffer buffer(4, 3);
  buffer.Insert(0, { 0.0f, 4.0f, 0.0f, 1.0f, 1 });
  buffer.Insert(2, { 1.0f, 3.0f, 0.25f, 0.25f, 2 });
  EXPECT_EQ(DepthImage(buffer),
    (Picture{ 0.125f, 0.375f, 0.625f, 0.875f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.25f, 0.25f, 0.0f }));
}

TEST(SBufferImage, HasWhatCoversTheMiddleAndTheNearerWhereTwoSpansMeetThere)
{
  SBuffer buffer(4, 1);
  buffer.Insert(0, { 0.75f, 1.5f, 0.5f, 0.5f, 1 });   // ends in the middle of column 1
  buffer.Insert(0, { 1.5f, 2.25f, 0.25f, 0.25f, 2 }); // and ends before that of column 2
  buffer.Insert(0, { 3.5f, 4.0f, 0.75f, 0.75f, 3 });
  EXPECT_EQ(DepthImage(buffer), (Picture{ 0.0f, 0.5f, 0.0f, 0.75f }));
}

TEST(SBufferImage, EndsWithTheLastColumn)
{
  SBuffer buffer(11, 2); // a tile and a part of one
  for (const int line : { 0, 1 })
  {
    buffer.Insert(line, { -5.0f, 20.0f, 0.5f, 0.5f, 1 });
  }
  EXPECT_EQ(DepthImage(buffer), Picture(22, 0.5f));
}
