#include "chart/GrowthFit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using program::FitGrowth;
using program::GrowthFit;
using program::GrowthPoint;

std::vector<GrowthPoint> PowerLaw(double factor, double exponent, const std::vector<double>& xs)
{
  std::vector<GrowthPoint> points;
  for (const double x : xs)
  {
    points.push_back({ x, factor * std::pow(x, exponent) });
  }
  return points;
}
}

TEST(GrowthFit, FindsAPowerLaw)
{
  for (const double exponent : { -1.0, 0.0, 0.5, 1.0, 2.0 })
  {
    const auto fit = FitGrowth(PowerLaw(3.0, exponent, { 1, 2, 4, 8, 16, 32, 64 }));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->Exponent, exponent, 1e-12);
    EXPECT_NEAR(fit->Factor, 3.0, 1e-11);
    EXPECT_NEAR(fit->OffBy, 1.0, 1e-11);
  }
}

TEST(GrowthFit, FitsTheUpperHalf)
{
  std::vector<GrowthPoint> points = PowerLaw(1.0, 2.0, { 16, 64, 256 });
  points.insert(
    points.begin(), { { 1, 200 }, { 4, 210 } }); // what does not grow hides the law there
  const auto fit = FitGrowth(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->Exponent, 2.0, 1e-12);
  EXPECT_EQ(fit->From, 16.0);
  EXPECT_EQ(fit->To, 256.0);
  EXPECT_EQ(fit->Points, 3);
}

TEST(GrowthFit, FitsAllWhereTheUpperHalfHasTooFew)
{
  const auto fit = FitGrowth(PowerLaw(1.0, 1.0, { 1, 2, 1000 }));
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->From, 1.0);
  EXPECT_EQ(fit->Points, 3);
}

TEST(GrowthFit, TellsHowFarThePointsAreOff)
{
  // logarithms to base 2: (0, 0), (1, 2), (2, 1); the line is 0.5 + 0.5 x, off by 0.5, 1, 0.5
  const auto fit = FitGrowth({ { 1, 1 }, { 2, 4 }, { 4, 2 } });
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->Exponent, 0.5, 1e-12);
  EXPECT_NEAR(fit->OffBy, 2.0, 1e-12);
}

TEST(GrowthFit, LeavesOutWhatHasNoLogarithm)
{
  std::vector<GrowthPoint> points = PowerLaw(1.0, 1.0, { 10, 20, 40 });
  points.insert(points.end(), { { 0, 5 }, { 5, 0 }, { -1, 1 }, { 80, std::nan("") } });
  const auto fit = FitGrowth(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->Exponent, 1.0, 1e-12);
  EXPECT_EQ(fit->Points, 3);
}

TEST(GrowthFit, IsNothingWithTooLittle)
{
  EXPECT_FALSE(FitGrowth({}));
  EXPECT_FALSE(FitGrowth({ { 1, 1 }, { 2, 2 } }));
  EXPECT_FALSE(FitGrowth({ { 2, 1 }, { 2, 2 }, { 2, 3 } }));
}
