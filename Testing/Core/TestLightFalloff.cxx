// Ranges in closed form, and lights that VTK's shaders make nothing of.

#include "Core/lighting/LightFalloff.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::UniformIn;
using vitrine::LightFalloff;

const double EndlessRange = std::numeric_limits<double>::infinity();

double RangeOf(const glm::dvec3& attenuation, double threshold, double intensity = 1.0)
{
  return LightFalloff({ 0.25, 1.0, 0.5 }, intensity, attenuation).RangeAt(threshold);
}

bool IsDegenerate(const glm::dvec3& colour, double intensity, const glm::dvec3& attenuation)
{
  return LightFalloff(colour, intensity, attenuation).IsDegenerate();
}
}

TEST(LightFalloff, HasRangesInClosedForm)
{
  EXPECT_DOUBLE_EQ(RangeOf({ 0, 0, 1 }, 0.01), 10.0);
  EXPECT_DOUBLE_EQ(RangeOf({ 0, 0, 4 }, 0.01, 16), 20.0);
  EXPECT_DOUBLE_EQ(RangeOf({ 0, 2, 0 }, 0.01), 50.0);
  EXPECT_DOUBLE_EQ(RangeOf({ 1, 0, 1 }, 0.01), std::sqrt(99.0));
  EXPECT_DOUBLE_EQ(RangeOf({ 4, 4, 1 }, 0.01), 8.0); // (2 + d)^2
  EXPECT_EQ(RangeOf({ 200, 0, 1 }, 0.01), 0.0);      // never above
  EXPECT_EQ(RangeOf({ 100, 0, 1 }, 0.01), 0.0);
}

TEST(LightFalloff, OfVTKsOwnAttenuationHasNoEndUnlessItIsTooWeakEverywhere)
{
  EXPECT_EQ(RangeOf({ 1, 0, 0 }, 0.5), EndlessRange);
  EXPECT_EQ(RangeOf({ 1, 0, 0 }, 1.0), 0.0);
  EXPECT_EQ(RangeOf({ 4, 0, 0 }, 0.3), 0.0);
}

TEST(LightFalloff, IsNotCutAtAThresholdOfZero)
{
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, 0.0), EndlessRange);
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, -1.0), EndlessRange);
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, NotANumber), EndlessRange);
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, 0.0, 0.0), 0.0); // which gives nothing anywhere
}

TEST(LightFalloff, TakesNegativeIntensityByItsAmount)
{
  EXPECT_DOUBLE_EQ(RangeOf({ 0, 0, 1 }, 0.01, -4.0), 20.0);
  EXPECT_EQ(LightFalloff({ 0.5, -3, 1 }, -2, { 0, 0, 1 }).Strength(), 6.0);
}

TEST(LightFalloff, OfNegativeOrNonFiniteAttenuationIsNeverCut)
{
  for (const glm::dvec3& attenuation : { glm::dvec3(-1, 0, 1), glm::dvec3(1, -0.5, 1),
         glm::dvec3(1, 0, -1e-9), glm::dvec3(1, NotANumber, 0), glm::dvec3(1, 0, Infinity) })
  {
    EXPECT_EQ(RangeOf(attenuation, 0.1), EndlessRange);
    EXPECT_EQ(LightFalloff({ 1, 1, 1 }, 1, attenuation).MostFrom(5), EndlessRange);
    EXPECT_FALSE(LightFalloff({ 1, 1, 1 }, 1, attenuation).CanBeCut());
  }
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, 0.1, NotANumber), EndlessRange);
  EXPECT_EQ(RangeOf({ 0, 0, 1 }, 0.1, Infinity), EndlessRange);
  EXPECT_TRUE(std::isnan(LightFalloff({ NotANumber, 1, 1 }, 1, { 0, 0, 1 }).Strength()));
  EXPECT_TRUE(std::isnan(LightFalloff({ 1, 1, NotANumber }, 1, { 0, 0, 1 }).Strength()));
}

TEST(LightFalloff, RangesAreTheLeastOnes)
{
  std::mt19937 random(1);
  const auto magnitude = [&]
  { return random() % 4 == 0 ? 0.0 : std::pow(10.0, UniformIn(random, -12, 12)); };
  for (int i = 0; i < 5000; ++i)
  {
    const double a0 = magnitude(), a1 = magnitude(), a2 = magnitude();
    const double intensity = magnitude(), threshold = std::pow(10.0, UniformIn(random, -9, 1));
    const LightFalloff falloff({ 1, 1, 1 }, intensity, { a0, a1, a2 });
    const double range = falloff.RangeAt(threshold);
    if (range < EndlessRange && intensity > 0)
    {
      ASSERT_LE(falloff.At(range), threshold) << i;
      ASSERT_LE(falloff.At(range * 1.5), threshold) << i;
      ASSERT_LE(falloff.MostFrom(range), threshold) << i;
      if (range > 0 && falloff.At(0) > 1.01 * threshold)
      {
        ASSERT_GT(falloff.At(range * (1 - 1e-9)), threshold) << i;
      }
    }
    else if (intensity > 0)
    {
      ASSERT_TRUE((a1 == 0 && a2 == 0) || falloff.At(1e200) > threshold) << i;
    }
  }
}

TEST(LightFalloff, OfExtremesIsNoNaN)
{
  for (const double a : { 5e-324, 1e-300, 1e300 })
  {
    for (const double threshold : { 5e-324, 1e-300, 1e300 })
    {
      for (const double intensity : { 5e-324, 1.0, 1e300 })
      {
        EXPECT_GE(RangeOf({ 0, a, 0 }, threshold, intensity), 0.0);
        EXPECT_GE(RangeOf({ 0, 0, a }, threshold, intensity), 0.0);
        EXPECT_GE(RangeOf({ a, a, a }, threshold, intensity), 0.0);
      }
    }
  }
}

TEST(LightFalloff, KnowsWhatTurnsPicturesBlack)
{
  EXPECT_FALSE(IsDegenerate({ 1, 1, 1 }, 1, { 1, 0, 0 }));
  EXPECT_FALSE(IsDegenerate({ 1, 1, 1 }, -1, { 0, 0, 1e-9 }));
  EXPECT_FALSE(IsDegenerate({ 0, 0, 0 }, 0, { 0, 1, 0 }));
  EXPECT_FALSE(IsDegenerate({ 1, 1, 1 }, 1, { -1, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1, { 0, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 0, 0, 0 }, 0, { 0, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1, { 1e-60, 0, 0 })); // a float of which is 0
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1e39, { 1, 0, 0 }));  // is infinite in floats
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, NotANumber, { 1, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, Infinity, 1 }, 1, { 1, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, NotANumber }, 1, { 1, 0, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1, { 1, NotANumber, 0 }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1, { 1, 0, Infinity }));
  EXPECT_TRUE(IsDegenerate({ 1, 1, 1 }, 1, { 1, 0, 1e39 }));
}
