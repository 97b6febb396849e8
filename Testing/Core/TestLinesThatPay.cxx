#include "Core/culling/buffer/LinesThatPay.h"

#include <gtest/gtest.h>

using vitrine::LinesThatPay;

TEST(LinesThatPay, AreMoreTheMorePartsThereAre)
{
  EXPECT_EQ(LinesThatPay(0), 270);
  EXPECT_EQ(LinesThatPay(16383), 270);
  EXPECT_EQ(LinesThatPay(16384), 540);
  EXPECT_EQ(LinesThatPay(32767), 540);
  EXPECT_EQ(LinesThatPay(32768), 1080);
  EXPECT_EQ(LinesThatPay(1u << 30), 1080);
}

TEST(LinesThatPay, AreFewerInViewsThatAreManyTimesAsWideAsHigh)
{
  EXPECT_EQ(LinesThatPay(100000, 16.0 / 9.0), 1080);
  EXPECT_EQ(LinesThatPay(100000, 0.1), 1080);
  EXPECT_EQ(LinesThatPay(100, 4.0), 270);
  EXPECT_EQ(LinesThatPay(100000, 3840.0 / 135.0), 384);
  EXPECT_EQ(LinesThatPay(100, 4096.0), 32);
}
