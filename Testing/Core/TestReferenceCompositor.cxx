#include "Core/lists/ReferenceCompositor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

using vitrine::CapturedFragment;
using vitrine::ReferenceCompositor;
using vitrine::TargetRange;
using Rgba = std::array<double, 4>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

CapturedFragment Fragment(float depth, float r, float g, float b, float a, std::uint32_t pixel = 0,
  std::uint32_t coverage = 1)
{
  return { pixel, depth, { r, g, b, a }, coverage };
}

std::vector<double> Backdrop(std::size_t samples, const Rgba& color)
{
  std::vector<double> backdrop;
  for (std::size_t i = 0; i < samples; ++i)
  {
    backdrop.insert(backdrop.end(), color.begin(), color.end());
  }
  return backdrop;
}

Rgba CompositePixel(const std::vector<CapturedFragment>& fragments, const Rgba& backdrop,
  TargetRange range = TargetRange::Unit)
{
  ReferenceCompositor compositor(1, 1, 1, range, Backdrop(1, backdrop));
  compositor.AddBatch(fragments.data(), fragments.size());
  const std::vector<double>& out = compositor.Samples();
  return { out[0], out[1], out[2], out[3] };
}

void ExpectNear(const Rgba& actual, const Rgba& expected, double tolerance)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(actual[channel], expected[channel], tolerance) << "channel " << channel;
  }
}

TEST(ReferenceCompositor, EqualPlatesSumToAGeometricSeries)
{
  const Rgba backdrop{ 0.1, 0.6, 0.3, 1.0 };
  for (int layers : { 0, 1, 2, 8, 64, 200, 1000, 4000 })
  {
    for (float alpha : { 0.0f, 0.004f, 1 / 255.0f, 0.2f, 0.5f, 0.99f, 1.0f })
    {
      SCOPED_TRACE(testing::Message() << layers << " layers of alpha " << alpha);
      std::vector<CapturedFragment> fragments;
      for (int i = 0; i < layers; ++i)
      {
        fragments.push_back(Fragment((i * 7 % layers) / 5000.0f, 0.5f, 0.25f, 1.0f, alpha));
      }
      const double t = std::pow(1.0 - alpha, layers);
      const Rgba expected{ 0.5 * (1 - t) + t * 0.1, 0.25 * (1 - t) + t * 0.6, 1 - t + t * 0.3,
        1.0 };
      ExpectNear(CompositePixel(fragments, backdrop), expected, 1e-12);
    }
  }
}

TEST(ReferenceCompositor, NearestIsInFrontWhateverTheOrderOfArrival)
{
  // Red before green before blue, over white: worked by hand.
  std::vector<CapturedFragment> fragments{ Fragment(0.25f, 1, 0, 0, 0.5f),
    Fragment(0.5f, 0, 1, 0, 0.25f), Fragment(0.75f, 0, 0, 1, 0.75f) };
  const Rgba expected{ 0.5 + 0.09375, 0.125 + 0.09375, 0.28125 + 0.09375, 1.0 };
  std::sort(fragments.begin(), fragments.end(),
    [](const auto& a, const auto& b) { return a.Depth > b.Depth; });
  for (int order = 0; order < 3; ++order)
  {
    ExpectNear(CompositePixel(fragments, { 1, 1, 1, 1 }), expected, 1e-15);
    std::rotate(fragments.begin(), fragments.begin() + 1, fragments.end());
  }
}

TEST(ReferenceCompositor, TransparentBackdropGivesPremultipliedColorAndAlpha)
{
  const Rgba half = CompositePixel({ Fragment(0.5f, 1, 0.5f, 0, 0.5f) }, { 0, 0, 0, 0 });
  ExpectNear(half, { 0.5, 0.25, 0, 0.5 }, 0);
  const Rgba over = CompositePixel({ Fragment(0.5f, 1, 0.5f, 0, 0.5f) }, { 0.1, 0.2, 0.3, 0.4 });
  ExpectNear(over, { 0.55, 0.35, 0.15, 0.7 }, 1e-15);
}

TEST(ReferenceCompositor, OpaqueFragmentHidesAllBehindIt)
{
  const Rgba color =
    CompositePixel({ Fragment(0.5f, 1, 1, 1, 0.3f), Fragment(0.2f, 0.25f, 0.5f, 0.75f, 1.0f) },
      { nan, inf, 1, 0.5 });
  ExpectNear({ color[0], color[1], color[2], 1 }, { 0.25, 0.5, 0.75, 1 }, 0);
}

TEST(ReferenceCompositor, EqualDepthsAreOrderedByAlphaBlueGreenRed)
{
  const Rgba black{ 0, 0, 0, 1 };
  // Each pair differs in one channel last of those compared so far; the first is in front.
  const std::pair<CapturedFragment, CapturedFragment> pairs[] = {
    { Fragment(0.5f, 1, 1, 1, 0.25f), Fragment(0.5f, 0, 0, 0, 0.5f) },
    { Fragment(0.5f, 1, 1, 0, 0.5f), Fragment(0.5f, 0, 0, 1, 0.5f) },
    { Fragment(0.5f, 1, 0, 1, 0.5f), Fragment(0.5f, 0, 1, 1, 0.5f) },
    { Fragment(0.5f, 0, 1, 1, 0.5f), Fragment(0.5f, 1, 1, 1, 0.5f) },
  };
  for (const auto& [front, back] : pairs)
  {
    const double near = front.Rgba[3];
    const double far = (1 - near) * back.Rgba[3];
    const Rgba expected{ near * front.Rgba[0] + far * back.Rgba[0],
      near * front.Rgba[1] + far * back.Rgba[1], near * front.Rgba[2] + far * back.Rgba[2], 1.0 };
    ExpectNear(CompositePixel({ front, back }, black), expected, 0);
    ExpectNear(CompositePixel({ back, front }, black), expected, 0);
  }
}

TEST(ReferenceCompositor, NoiseInTheLastBitsDoesNotOrderEqualDepths)
{
  // Two coincident faces of a part whose alpha was interpolated: what tells them apart is their blue.
  const float alpha = 0.3f;
  const float alphaAbove = std::nextafter(alpha, 1.0f);
  const Rgba backdrop{ 0.0, 0.0, 0.0, 1.0 };
  const Rgba expected = CompositePixel(
    { Fragment(0.5f, 0, 0, 0.2f, alpha), Fragment(0.5f, 0, 0, 0.8f, alpha) }, backdrop);
  const Rgba noisy = CompositePixel(
    { Fragment(0.5f, 0, 0, 0.2f, alphaAbove), Fragment(0.5f, 0, 0, 0.8f, alpha) }, backdrop);
  EXPECT_NEAR(expected[2], 0.3 * 0.2 + 0.7 * 0.3 * 0.8, 1e-6);
  ExpectNear(noisy, expected, 1e-6);
}

TEST(ReferenceCompositor, MinusZeroEqualsZero)
{
  // Equal depths and alphas, so blue decides, for -0 as for 0.
  for (float zero : { 0.0f, -0.0f })
  {
    const Rgba color = CompositePixel(
      { Fragment(zero, 0, 1, 1, 0.5f), Fragment(0.0f, 1, 0, zero, 0.5f) }, { 0, 0, 0, 1 });
    ExpectNear(color, { 0.5, 0.25, 0.25, 1 }, 0);
  }
}

TEST(ReferenceCompositor, ShuffledFragmentsGiveTheSamePictureToTheBit)
{
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto unit = [&random] { return (random() % 4) / 3.0f; }; // many ties
  const int width = 13;
  const int height = 9;
  const int samples = 4;
  std::vector<CapturedFragment> fragments;
  for (int i = 0; i < 20000; ++i)
  {
    const std::uint32_t pixel = random() % (width * height);
    const std::uint32_t coverage = 1 + random() % 15;
    fragments.push_back(Fragment(unit(), unit(), unit(), unit(), unit() / 2, pixel, coverage));
  }
  const auto composite = [&]
  {
    ReferenceCompositor compositor(width, height, samples, TargetRange::Unit,
      Backdrop(width * height * samples, { 0.3, 0.2, 0.1, 1 }));
    compositor.AddBatch(fragments.data(), fragments.size());
    return compositor.Samples();
  };
  const std::vector<double> first = composite();
  for (int shuffle = 0; shuffle < 10; ++shuffle)
  {
    std::shuffle(fragments.begin(), fragments.end(), random);
    EXPECT_EQ(composite(), first) << shuffle;
  }
}

TEST(ReferenceCompositor, AgreesWithCompositingBackToFront)
{
  const unsigned seed = 21;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto unit = [&random] { return random() / 4294967296.0f; };
  std::vector<CapturedFragment> fragments;
  for (int i = 0; i < 300; ++i)
  {
    fragments.push_back(Fragment(unit(), unit(), unit(), unit(), unit() * 0.05f));
  }
  const Rgba color = CompositePixel(fragments, { 0.5, 0.5, 0.5, 0.25 });

  std::sort(fragments.begin(), fragments.end(),
    [](const auto& a, const auto& b) { return a.Depth > b.Depth; });
  Rgba expected{ 0.5, 0.5, 0.5, 0.25 };
  for (const CapturedFragment& f : fragments)
  {
    const double alpha = f.Rgba[3];
    for (int channel = 0; channel < 3; ++channel)
    {
      expected[channel] = alpha * f.Rgba[channel] + (1 - alpha) * expected[channel];
    }
    expected[3] = alpha + (1 - alpha) * expected[3];
  }
  ExpectNear(color, expected, 1e-14);
}

CapturedFragment Added(CapturedFragment fragment)
{
  fragment.Pixel |= CapturedFragment::Added;
  return fragment;
}

TEST(ReferenceCompositor, WhatIsAddedIsSeenThroughWhatIsInFrontAndHidesNothing)
{
  const Rgba backdrop{ 0.25, 0.5, 0.75, 0.5 };
  const CapturedFragment plate = Fragment(0.5f, 1, 0, 0, 0.75f);
  const CapturedFragment light = Fragment(0.25f, 0.5f, 0.25f, 0, 0.5f);
  ExpectNear(CompositePixel({ Added(light) }, backdrop), { 0.5, 0.625, 0.75, 0.5 }, 0);
  const Rgba inFront{ 0.25 + 0.75 + 0.25 * 0.25, 0.125 + 0.25 * 0.5, 0.25 * 0.75, 0.875 };
  ExpectNear(CompositePixel({ plate, Added(light) }, backdrop), inFront, 0);
  CapturedFragment behind = Added(light);
  behind.Depth = 0.75f;
  const Rgba through{ 0.75 + 0.25 * 0.5, 0.25 * 0.625, 0.25 * 0.75, 0.875 };
  ExpectNear(CompositePixel({ behind, plate }, backdrop), through, 0);
}

// As one without alpha: in front of those of its depth. And many in one pixel, in any order.
TEST(ReferenceCompositor, WhatIsAddedIsInFrontOfWhatHasItsDepth)
{
  const Rgba black{ 0, 0, 0, 1 };
  const CapturedFragment plate = Fragment(0.5f, 0, 1, 0, 0.5f);
  const CapturedFragment light = Added(Fragment(0.5f, 1, 0, 0, 0.5f));
  const Rgba expected{ 1.0, 0.5, 0, 1 };
  ExpectNear(CompositePixel({ plate, light, light }, black), expected, 0);
  ExpectNear(CompositePixel({ light, plate, light }, black), expected, 0);
}

TEST(ReferenceCompositor, WhatIsAddedWithoutAlphaAddsNothing)
{
  const Rgba black{ 0, 0, 0, 1 };
  for (const float alpha : { 0.0f, nan, -1.0f })
  {
    const CapturedFragment light = Added(Fragment(0.5f, inf, 1, nan, alpha));
    ExpectNear(CompositePixel({ light }, black, TargetRange::NonNegative), black, 0);
  }
}

TEST(ReferenceCompositor, NumbersWithoutMeaningCountAsZeroOrAreClamped)
{
  const Rgba black{ 0, 0, 0, 1 };
  // A depth that is not a number is in front.
  ExpectNear(
    CompositePixel({ Fragment(0.25f, 0, 1, 0, 0.25f), Fragment(nan, 1, 0, 0, 0.5f) }, black),
    { 0.5, 0.125, 0, 1 }, 0);
  ExpectNear(CompositePixel({ Fragment(0.25f, 1, 1, 1, nan) }, black), black, 0);
  ExpectNear(CompositePixel({ Fragment(0.25f, nan, -inf, -2, 0.5f) }, black), black, 0);
  ExpectNear(CompositePixel({ Fragment(0.25f, 2, inf, 0.5f, 7) }, black), { 1, 1, 0.5, 1 }, 0);
  ExpectNear(CompositePixel({ Fragment(0.25f, 1, 1, 1, -1) }, black), black, 0);
  ExpectNear(CompositePixel({ Fragment(-inf, 1, 0, 0, inf), Fragment(inf, 0, 1, 0, 1) }, black),
    { 1, 0, 0, 1 }, 0);
}

TEST(ReferenceCompositor, FloatingPointTargetKeepsColorsAboveOne)
{
  const Rgba black{ 0, 0, 0, 1 };
  const std::vector<CapturedFragment> bright{ Fragment(0.5f, 4, -3, nan, 0.5f) };
  ExpectNear(CompositePixel(bright, black, TargetRange::NonNegative), { 2, 0, 0, 1 }, 0);
  ExpectNear(CompositePixel(bright, black, TargetRange::Unit), { 0.5, 0, 0, 1 }, 0);
  // An infinite colour that is not seen does no harm.
  const std::vector<CapturedFragment> hidden{ Fragment(0.1f, 0.5f, 0, 0, 1),
    Fragment(0.5f, inf, inf, inf, 0.5f), Fragment(0.0f, inf, inf, inf, 0) };
  ExpectNear(CompositePixel(hidden, black, TargetRange::NonNegative), { 0.5, 0, 0, 1 }, 0);
}

TEST(ReferenceCompositor, CoverageDecidesSampleBySample)
{
  std::vector<double> backdrop = Backdrop(4, { 0, 0, 0, 1 });
  ReferenceCompositor compositor(1, 1, 4, TargetRange::Unit, backdrop);
  const CapturedFragment fragments[] = { Fragment(0.5f, 1, 0, 0, 0.5f, 0, 0b0011),
    Fragment(0.75f, 0, 1, 0, 1.0f, 0, 0b0110), Fragment(0.9f, 0, 0, 1, 1.0f, 0, 0b110000) };
  compositor.AddBatch(fragments, 3);
  const std::vector<double> expected{ 0.5, 0, 0, 1, 0.5, 0.5, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1 };
  EXPECT_EQ(compositor.Samples(), expected);
  EXPECT_EQ(compositor.Resolve(), (std::vector<double>{ 0.25, 0.375, 0, 1 }));
}

TEST(ReferenceCompositor, ThirtyTwoSamplesAreTheMost)
{
  ReferenceCompositor compositor(1, 1, 32, TargetRange::Unit, Backdrop(32, { 0, 0, 0, 0 }));
  const CapturedFragment fragment = Fragment(0.5f, 1, 1, 1, 1, 0, 0x80000000u);
  compositor.AddBatch(&fragment, 1);
  EXPECT_EQ(compositor.Samples()[31 * 4], 1.0);
  EXPECT_EQ(compositor.Samples()[30 * 4], 0.0);
  EXPECT_EQ(compositor.Resolve()[3], 1.0 / 32);
}

TEST(ReferenceCompositor, PixelsWithoutFragmentsShowTheBackdrop)
{
  const Rgba color{ 0.1, 0.2, 0.3, 0.4 };
  ReferenceCompositor compositor(3, 2, 1, TargetRange::Unit, Backdrop(6, color));
  compositor.AddBatch(nullptr, 0);
  EXPECT_EQ(compositor.Samples(), Backdrop(6, color));
  EXPECT_EQ(compositor.FragmentCount(), 0u);
  EXPECT_EQ(compositor.LayersMax(), 0u);
  EXPECT_EQ(compositor.LayersMean(), 0.0);
}

TEST(ReferenceCompositor, PictureOfNoPixelsIsEmpty)
{
  ReferenceCompositor compositor(0, 5, 1, TargetRange::Unit, {});
  compositor.AddBatch(nullptr, 0);
  EXPECT_TRUE(compositor.Samples().empty());
  EXPECT_TRUE(compositor.Resolve().empty());
  const CapturedFragment fragment = Fragment(0.5f, 1, 1, 1, 1);
  EXPECT_THROW(compositor.AddBatch(&fragment, 1), std::invalid_argument);
}

TEST(ReferenceCompositor, CountsFragmentsAndLayersOverBatches)
{
  ReferenceCompositor compositor(4, 1, 1, TargetRange::Unit, Backdrop(4, { 0, 0, 0, 1 }));
  const std::vector<CapturedFragment> first(5, Fragment(0.5f, 1, 1, 1, 0.1f, 2));
  const std::vector<CapturedFragment> second(2, Fragment(0.5f, 1, 1, 1, 0.1f, 0));
  compositor.AddBatch(first.data(), first.size());
  compositor.AddBatch(second.data(), second.size());
  EXPECT_EQ(compositor.FragmentCount(), 7u);
  EXPECT_EQ(compositor.LayersMax(), 5u);
  EXPECT_EQ(compositor.LayersMean(), 3.5);
  EXPECT_NEAR(compositor.Samples()[2 * 4], 1 - std::pow(1.0 - 0.1f, 5), 1e-15);
  EXPECT_NEAR(compositor.Samples()[0], 1 - std::pow(1.0 - 0.1f, 2), 1e-15);
  EXPECT_EQ(compositor.Samples()[1 * 4], 0.0);
}

TEST(ReferenceCompositor, BatchesInBandsGiveThePictureOfOneBatch)
{
  const unsigned seed = 55;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto unit = [&random] { return random() / 4294967296.0f; };
  std::vector<CapturedFragment> fragments;
  for (int i = 0; i < 5000; ++i)
  {
    fragments.push_back(Fragment(unit(), unit(), unit(), unit(), unit(), random() % 64));
  }
  ReferenceCompositor whole(8, 8, 1, TargetRange::Unit, Backdrop(64, { 0, 0, 0, 1 }));
  whole.AddBatch(fragments.data(), fragments.size());
  ReferenceCompositor banded(8, 8, 1, TargetRange::Unit, Backdrop(64, { 0, 0, 0, 1 }));
  std::sort(fragments.begin(), fragments.end(),
    [](const auto& a, const auto& b) { return a.Pixel < b.Pixel; });
  const auto middle =
    std::find_if(fragments.begin(), fragments.end(), [](const auto& f) { return f.Pixel >= 24; });
  banded.AddBatch(&*middle, fragments.end() - middle);
  banded.AddBatch(fragments.data(), middle - fragments.begin());
  EXPECT_EQ(banded.Samples(), whole.Samples());
}

TEST(ReferenceCompositor, PixelInTwoBatchesOrOutsideIsAnErrorThatChangesNothing)
{
  ReferenceCompositor compositor(2, 2, 1, TargetRange::Unit, Backdrop(4, { 0, 0, 0, 1 }));
  const CapturedFragment good = Fragment(0.5f, 1, 1, 1, 0.5f, 1);
  compositor.AddBatch(&good, 1);
  const std::vector<double> before = compositor.Samples();
  const CapturedFragment again[] = { Fragment(0.5f, 1, 1, 1, 0.5f, 2), good };
  EXPECT_THROW(compositor.AddBatch(again, 2), std::invalid_argument);
  const CapturedFragment outside[] = { Fragment(0.5f, 1, 1, 1, 0.5f, 3),
    Fragment(0.5f, 1, 1, 1, 0.5f, 4) };
  EXPECT_THROW(compositor.AddBatch(outside, 2), std::invalid_argument);
  EXPECT_EQ(compositor.Samples(), before);
  EXPECT_EQ(compositor.FragmentCount(), 1u);
}

TEST(ReferenceCompositor, BackdropMustMatchThePicture)
{
  EXPECT_THROW(
    ReferenceCompositor(2, 2, 1, TargetRange::Unit, Backdrop(3, {})), std::invalid_argument);
  EXPECT_THROW(
    ReferenceCompositor(2, 2, 4, TargetRange::Unit, Backdrop(4, {})), std::invalid_argument);
  EXPECT_THROW(ReferenceCompositor(-1, -1, 1, TargetRange::Unit, {}), std::invalid_argument);
  EXPECT_THROW(ReferenceCompositor(1, 1, 0, TargetRange::Unit, {}), std::invalid_argument);
  EXPECT_THROW(
    ReferenceCompositor(1, 1, 33, TargetRange::Unit, Backdrop(33, {})), std::invalid_argument);
}

TEST(ReferenceCompositor, UnevenDepthIsDividedAmongThreadsWithoutLoss)
{
  // One pixel holds nearly everything; the first and the last hold one layer.
  const int width = 100;
  ReferenceCompositor compositor(width, 1, 1, TargetRange::Unit, Backdrop(width, { 0, 0, 0, 1 }));
  std::vector<CapturedFragment> fragments(100000, Fragment(0.5f, 1, 1, 1, 1 / 65536.0f, 40));
  fragments.push_back(Fragment(0.5f, 1, 1, 1, 0.5f, 0));
  fragments.push_back(Fragment(0.5f, 1, 1, 1, 0.5f, width - 1));
  compositor.AddBatch(fragments.data(), fragments.size());
  EXPECT_NEAR(compositor.Samples()[40 * 4], 1 - std::pow(1 - 1 / 65536.0, 100000), 1e-11);
  EXPECT_EQ(compositor.Samples()[0], 0.5);
  EXPECT_EQ(compositor.Samples()[(width - 1) * 4], 0.5);
  EXPECT_EQ(compositor.LayersMax(), 100000u);
}

}
