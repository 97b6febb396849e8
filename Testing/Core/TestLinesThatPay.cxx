#include "Core/culling/LinesThatPay.h"

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
