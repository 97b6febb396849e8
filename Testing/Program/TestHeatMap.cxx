#include "report/HeatMap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

TEST(HeatMap, GoesFromBlackToWhite)
{
  const std::vector<std::uint8_t> picture = program::HeatMap({ 0, 1, 4, 25 });
  const std::vector<std::uint8_t> expected = { 0, 0, 0, 0, 89, 255, 0, 204, 77, 255, 255, 255 };
  EXPECT_EQ(picture, expected);
}

TEST(HeatMap, OfSharesGoesByEvenSteps)
{
  const std::vector<std::uint8_t> picture = program::HeatMapOfShares({ 0.0, 0.2, 0.4, 1.0 });
  const std::vector<std::uint8_t> expected = { 0, 0, 0, 0, 89, 255, 0, 204, 77, 255, 255, 255 };
  EXPECT_EQ(picture, expected);
}

TEST(HeatMap, IsBlackWithoutLights)
{
  EXPECT_EQ(program::HeatMap({ 0, 0 }), std::vector<std::uint8_t>(6, 0));
  EXPECT_TRUE(program::HeatMap({}).empty());
}
