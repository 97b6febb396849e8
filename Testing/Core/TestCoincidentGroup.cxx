// Fragments without an order: the mean over all their orders, and which fragments of a sample are such.
#include "Core/lists/CoincidentGroup.h"
#include "Core/lists/ReferenceCompositor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using vitrine::CapturedFragment;
using vitrine::CoincidentGroup;
using Rgb = std::array<double, 3>;

struct Layer
{
  Rgb Color;
  double Alpha;
};

constexpr Rgb Black = { 0.0, 0.0, 0.0 };
constexpr Rgb White = { 1.0, 1.0, 1.0 };

CoincidentGroup MakeGroup(const std::vector<Layer>& layers)
{
  CoincidentGroup group;
  for (const Layer& layer : layers)
  {
    group.Add(layer.Alpha, layer.Color.data());
  }
  return group;
}

Rgb ColorOf(const CoincidentGroup& group)
{
  Rgb color = Black;
  group.AddColor(1.0, color.data());
  return color;
}

Rgb InOrder(const std::vector<Layer>& layers, const std::vector<int>& order)
{
  Rgb color = Black;
  double transmittance = 1.0;
  for (const int i : order)
  {
    for (int c = 0; c < 3; ++c)
    {
      color[c] += transmittance * layers[i].Alpha * layers[i].Color[c];
    }
    transmittance *= 1.0 - layers[i].Alpha;
  }
  return color;
}

// The mean over all orders, one by one, and the range that they span.
struct AllOrders
{
  Rgb Mean = Black;
  Rgb Least = White;
  Rgb Most = Black;

  explicit AllOrders(const std::vector<Layer>& layers)
  {
    std::vector<int> order(layers.size());
    std::iota(order.begin(), order.end(), 0);
    int orders = 0;
    do
    {
      const Rgb color = InOrder(layers, order);
      for (int c = 0; c < 3; ++c)
      {
        this->Mean[c] += color[c];
        this->Least[c] = std::min(this->Least[c], color[c]);
        this->Most[c] = std::max(this->Most[c], color[c]);
      }
      ++orders;
    } while (std::next_permutation(order.begin(), order.end()));
    for (double& c : this->Mean)
    {
      c /= orders;
    }
  }
};

TEST(CoincidentGroup, PairsAreWorkedByHand)
{
  // 0.5 red and 0.25 green: red first gives 0.5, 0.125; green first 0.375, 0.25.
  const CoincidentGroup group = MakeGroup({ { { 1, 0, 0 }, 0.5 }, { { 0, 1, 0 }, 0.25 } });
  EXPECT_DOUBLE_EQ(ColorOf(group)[0], 0.4375);
  EXPECT_DOUBLE_EQ(ColorOf(group)[1], 0.1875);
  EXPECT_DOUBLE_EQ(group.Transmittance(), 0.375);
}

TEST(CoincidentGroup, IsTheMeanOverAllOrders)
{
  const std::uint32_t seed = 51;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double alphas[] = { 0.0, 1.0 / 255, 0.01, 0.5, 0.99, 1.0 };
  for (int count = 1; count <= 6; ++count)
  {
    for (int trial = 0; trial < 40; ++trial)
    {
      std::vector<Layer> layers;
      double transmittance = 1.0;
      for (int i = 0; i < count; ++i)
      {
        const double alpha = trial % 2 == 0 ? unit(random) : alphas[random() % 6];
        layers.push_back({ { unit(random), unit(random), unit(random) }, alpha });
        transmittance *= 1.0 - alpha;
      }
      const CoincidentGroup group = MakeGroup(layers);
      const AllOrders orders(layers);
      EXPECT_NEAR(group.Transmittance(), transmittance, 1e-15);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(ColorOf(group)[c], orders.Mean[c], 1e-14) << count << " fragments";
        EXPECT_GE(ColorOf(group)[c], orders.Least[c] - 1e-14);
        EXPECT_LE(ColorOf(group)[c], orders.Most[c] + 1e-14);
      }
    }
  }
}

// By symmetry all weights are equal, and their sum is what does not pass.
TEST(CoincidentGroup, EqualAlphasShareWhatDoesNotPass)
{
  for (const int count : { 2, 9, 300, 3000 })
  {
    for (const double alpha : { 0.0, 1e-6, 1.0 / 255, 0.5, 1.0 })
    {
      std::vector<Layer> layers(count, { Black, alpha });
      layers[count / 3].Color = White;
      const double share = -std::expm1(count * std::log1p(-alpha)) / count;
      EXPECT_NEAR(
        ColorOf(MakeGroup(layers))[0] / (alpha > 0 ? share : 1.0), alpha > 0 ? 1 : 0, 1e-9)
        << count << " of alpha " << alpha;
    }
  }
}

// So many that what is seen behind half of them is nothing in double precision.
TEST(CoincidentGroup, OfManyOpaqueOnesIsTheirMean)
{
  std::vector<Layer> layers(6000, { White, 1.0 });
  layers.resize(8000, { Black, 1.0 });
  const CoincidentGroup group = MakeGroup(layers);
  EXPECT_NEAR(ColorOf(group)[0], 0.75, 1e-12);
  EXPECT_EQ(group.Transmittance(), 0.0);
}

// One opaque fragment among `count` - 1 of alpha a: its weight is the integral of (1 - t a)^(count - 1).
TEST(CoincidentGroup, OneOpaqueAmongManyIsTheClosedForm)
{
  for (const int count : { 2, 8, 100, 2000 })
  {
    for (const double a : { 0.01, 0.5, 0.99 })
    {
      std::vector<Layer> layers(count, { Black, a });
      layers[0] = { White, 1.0 };
      const double expected = (1.0 - std::pow(1.0 - a, count)) / (count * a);
      EXPECT_NEAR(ColorOf(MakeGroup(layers))[0], expected, 1e-11);
    }
  }
}

// The same for light: it is seen as that is, and hides nothing.
TEST(CoincidentGroup, LightAmongManyIsTheClosedForm)
{
  for (const int others : { 0, 1, 7, 500 })
  {
    const double a = 0.3;
    CoincidentGroup group = MakeGroup(std::vector<Layer>(others, { Black, a }));
    group.AddLight(White.data());
    const double expected = (1.0 - std::pow(1.0 - a, others + 1)) / ((others + 1) * a);
    EXPECT_NEAR(ColorOf(group)[0], expected, 1e-11) << others;
    EXPECT_NEAR(group.Transmittance(), std::pow(1.0 - a, others), 1e-13) << others;
  }
}

TEST(CoincidentGroup, WhatHasNoWeightAddsNothing)
{
  const double inf = std::numeric_limits<double>::infinity();
  const CoincidentGroup group =
    MakeGroup({ { { inf, inf, inf }, 0.0 }, { White, 1.0 }, { { inf, inf, inf }, 0.0 } });
  EXPECT_EQ(ColorOf(group), White);
  EXPECT_EQ(group.Transmittance(), 0.0);
}

// What follows: which fragments of a sample are a group.
constexpr float Alpha = 0.5f;

CapturedFragment Interval(float nearEnd, float extent, float gray, std::uint32_t coverage = 1)
{
  return { 0, nearEnd, { gray, gray, gray, Alpha }, coverage, extent };
}

double Gray(std::vector<CapturedFragment> fragments, int sample = 0)
{
  const int samples = 2;
  vitrine::ReferenceCompositor compositor(
    1, 1, samples, vitrine::TargetRange::Unit, std::vector<double>(4 * samples, 0.0));
  compositor.AddBatch(fragments.data(), fragments.size());
  return compositor.Samples()[4 * sample];
}

// Of white before black, black before white, and their mean.
constexpr double WhiteFirst = 0.5;
constexpr double BlackFirst = 0.25;
constexpr double Neither = 0.375;

TEST(Coincidence, IsThatIntervalsMeet)
{
  EXPECT_EQ(Gray({ Interval(0.5f, 0.125f, 1), Interval(0.625f, 0.125f, 0) }), Neither);
  EXPECT_EQ(Gray({ Interval(0.5f, 0.125f, 0), Interval(0.625f, 0.125f, 1) }), Neither);
  const float beyond = std::nextafter(0.625f, 1.0f);
  EXPECT_EQ(Gray({ Interval(0.5f, 0.125f, 1), Interval(beyond, 0.125f, 0) }), WhiteFirst);
  EXPECT_EQ(Gray({ Interval(0.5f, 0.125f, 0), Interval(beyond, 0.125f, 1) }), BlackFirst);
}

TEST(Coincidence, WithoutExtentsIsNone)
{
  EXPECT_EQ(Gray({ Interval(0.5f, 0.0f, 1), Interval(0.5f, 0.0f, 0) }), BlackFirst);
}

TEST(Coincidence, OfEqualDepthsNeedsTheLeastExtent)
{
  const float least = std::numeric_limits<float>::min();
  EXPECT_EQ(Gray({ Interval(0.5f, least, 1), Interval(0.5f, least, 0) }), Neither);
}

// The first interval reaches over the second, to the third.
TEST(Coincidence, IsPassedOnByOthers)
{
  const std::vector<CapturedFragment> fragments = { Interval(0.25f, 0.5f, 1),
    Interval(0.375f, 0.125f, 0), Interval(0.625f, 0.125f, 0) };
  EXPECT_NEAR(Gray(fragments), 0.875 / 3.0, 1e-15);
}

// A fragment that does not cover the sample joins no others in it.
TEST(Coincidence, IsOfTheSample)
{
  const std::vector<CapturedFragment> fragments = { Interval(0.25f, 0.125f, 0, 3),
    Interval(0.375f, 0.125f, 0, 1), Interval(0.5f, 0.125f, 1, 3) };
  EXPECT_NEAR(Gray(fragments, 0), 0.875 / 3.0, 1e-15);
  EXPECT_EQ(Gray(fragments, 1), BlackFirst);
}

// Neither arrival nor depths below the extent change a bit.
TEST(Coincidence, DependsOnNeitherOrderNorNoise)
{
  const std::uint32_t seed = 52;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<CapturedFragment> fragments;
  for (int i = 0; i < 60; ++i)
  {
    const float depth = 0.25f * static_cast<float>(i / 5);
    fragments.push_back(
      { 0, depth, { unit(random), unit(random), unit(random), unit(random) }, 1, 0.01f });
  }
  const double expected = Gray(fragments);
  for (int trial = 0; trial < 50; ++trial)
  {
    std::vector<CapturedFragment> noisy = fragments;
    for (CapturedFragment& f : noisy)
    {
      f.Depth += 0.009f * unit(random);
    }
    std::shuffle(noisy.begin(), noisy.end(), random);
    ASSERT_EQ(Gray(noisy), expected) << "trial " << trial;
  }
}

}
