// The order and the shares of pixels' layers (lists/PixelLayers).

#include "Core/lists/PixelLayers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace
{

using vitrine::LayerFragment;
using vitrine::PixelLayers;
using vitrine::SortLayers;

LayerFragment LayerOf(float depth, float alpha, std::uint32_t part, std::uint32_t kind = 0,
  std::uint32_t coverage = 1, std::uint32_t pixel = 0)
{
  return { pixel, depth, { 0.5f, 0.5f, 0.5f, alpha }, coverage, part, kind, 0 };
}

std::vector<std::uint32_t> PartsInOrder(
  const std::vector<LayerFragment>& fragments, const PixelLayers& layers)
{
  std::vector<std::uint32_t> parts;
  for (const vitrine::PixelLayer& layer : layers.Layers)
  {
    parts.push_back(fragments[layer.Fragment].Part);
  }
  return parts;
}

TEST(PixelLayers, AreSortedWithTheirSharesDownToTheOpaqueOne)
{
  const std::vector<LayerFragment> fragments = { LayerOf(0.9f, 0.5f, 4), LayerOf(0.5f, 0.25f, 2),
    LayerOf(0.7f, 0.1f, 3, LayerFragment::Opaque), LayerOf(0.1f, 0.5f, 1) };
  const PixelLayers seen = SortLayers(fragments, 1, 1, false);
  EXPECT_EQ(PartsInOrder(fragments, seen), (std::vector<std::uint32_t>{ 1, 2, 3 }));
  ASSERT_EQ(seen.Layers.size(), 3u);
  EXPECT_EQ(seen.Layers[0].Share, 0.5);
  EXPECT_EQ(seen.Layers[1].Share, 0.125);
  EXPECT_EQ(seen.Layers[2].Share, 0.375); // the alpha of an opaque one counts as 1
  const PixelLayers all = SortLayers(fragments, 1, 1, true);
  EXPECT_EQ(PartsInOrder(fragments, all), (std::vector<std::uint32_t>{ 1, 2, 3, 4 }));
  EXPECT_EQ(all.Layers[3].Share, 0.0);
}

TEST(PixelLayers, OfEqualDepthHaveOneOrder)
{
  std::vector<LayerFragment> fragments = { LayerOf(0.5f, 0.5f, 9), LayerOf(0.5f, 0.25f, 5),
    LayerOf(0.5f, 0.25f, 3), LayerOf(0.5f, 0.5f, 1),
    LayerOf(0.5f, 1.0f, 7, LayerFragment::Opaque) };
  fragments[0].Rgba[2] = 0.25f; // less blue
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i)
  {
    std::shuffle(fragments.begin(), fragments.end(), random);
    EXPECT_EQ(PartsInOrder(fragments, SortLayers(fragments, 1, 1, true)),
      (std::vector<std::uint32_t>{ 3, 5, 9, 1, 7 }));
  }
  // Colours that are stored as the same 16-bit float are equal.
  std::vector<LayerFragment> close = { LayerOf(0.5f, 0.5f, 2), LayerOf(0.5f, 0.5f, 1) };
  close[1].Rgba[3] = 0.50001f;
  EXPECT_EQ(
    PartsInOrder(close, SortLayers(close, 1, 1, true)), (std::vector<std::uint32_t>{ 1, 2 }));
}

// The depth test lets the later of opaque fragments win.
TEST(PixelLayers, ThatAreOpaqueAndOfEqualDepthAreInTheOrderOfDrawing)
{
  const std::uint32_t later = LayerFragment::Opaque | 1u << LayerFragment::FirstDrawBit;
  std::vector<LayerFragment> fragments = { LayerOf(0.5f, 1.0f, 8, LayerFragment::Opaque),
    LayerOf(0.5f, 1.0f, 9 | LayerFragment::BackFace, LayerFragment::Opaque),
    LayerOf(0.5f, 1.0f, 3, later), LayerOf(0.5f, 1.0f, 3 | LayerFragment::BackFace, later) };
  fragments[2].Primitive = 1;
  fragments[2].Rgba[0] = 1.0f; // colours do not count
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i)
  {
    std::shuffle(fragments.begin(), fragments.end(), random);
    EXPECT_EQ(PartsInOrder(fragments, SortLayers(fragments, 1, 1, true)),
      (std::vector<std::uint32_t>{
        3, 3 | LayerFragment::BackFace, 9 | LayerFragment::BackFace, 8 }));
  }
}

TEST(PixelLayers, ThatWereTestedAreInFrontOfOpaqueOnes)
{
  const std::vector<LayerFragment> fragments = { LayerOf(0.5f, 1.0f, 1, LayerFragment::Opaque),
    LayerOf(0.6f, 0.5f, 2, LayerFragment::Tested) };
  EXPECT_EQ(PartsInOrder(fragments, SortLayers(fragments, 1, 1, false)),
    (std::vector<std::uint32_t>{ 2, 1 }));
}

TEST(PixelLayers, HaveMeanSharesOfSamples)
{
  const std::vector<LayerFragment> fragments = { LayerOf(0.1f, 0.5f, 1, 0, 0b0011),
    LayerOf(0.2f, 1.0f, 2, LayerFragment::Opaque, 0b0110),
    LayerOf(0.3f, 0.5f, 3, 0, 0b0010), // hidden in its only sample
    LayerOf(0.4f, 0.5f, 4, 0, 0b1111), LayerOf(0.5f, 0.5f, 5, LayerFragment::Added, 0b1111) };
  const PixelLayers layers = SortLayers(fragments, 1, 4, false);
  EXPECT_EQ(PartsInOrder(fragments, layers), (std::vector<std::uint32_t>{ 1, 2, 4, 5 }));
  EXPECT_EQ(layers.Layers[0].Share, 0.25);
  EXPECT_EQ(layers.Layers[1].Share, (0.5 + 1.0) / 4.0);
  EXPECT_EQ(layers.Layers[2].Share, (0.25 + 0.5) / 4.0);
  EXPECT_EQ(layers.Layers[3].Share, 0.0);
}

TEST(PixelLayers, StayInTheirPixels)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<LayerFragment> fragments = { LayerOf(0.9f, 0.5f, 1, 0, 1, 2),
    LayerOf(0.1f, 0.5f, 2, 0, 1, 0), LayerOf(nan, nan, 3, 0, 1, 2), LayerOf(0.1f, 0.5f, 4, 0, 1, 3),
    LayerOf(0.1f, 0.5f, 5, 0, 1, 0xffffffffu) };
  const PixelLayers layers = SortLayers(fragments, 3, 1, false);
  EXPECT_EQ(layers.Offsets, (std::vector<std::size_t>{ 0, 1, 1, 3 }));
  EXPECT_EQ(PartsInOrder(fragments, layers), (std::vector<std::uint32_t>{ 2, 3, 1 }));
  EXPECT_EQ(layers.Layers[1].Share, 0.0);
  EXPECT_EQ(SortLayers({}, 0, 1, true).Offsets, (std::vector<std::size_t>{ 0 }));
}

TEST(PixelLayers, GiveTheFirstPartWithAShare)
{
  const std::uint32_t back = LayerFragment::BackFace;
  const std::vector<LayerFragment> fragments = { LayerOf(0.1f, 0.3f, 1), LayerOf(0.2f, 0.2f, 2),
    LayerOf(0.3f, 0.3f, 1 | back), LayerOf(0.4f, 1.0f, 3, LayerFragment::Opaque) };
  const PixelLayers layers = SortLayers(fragments, 1, 1, false);
  const auto pick = [&](double share)
  { return vitrine::FirstPartWithShare(fragments, layers, 0, layers.Layers.size(), share); };
  EXPECT_EQ(pick(0.1), 0u);
  EXPECT_EQ(pick(0.46), 0u); // 0.3 in front, 0.3 * 0.7 * 0.8 behind
  EXPECT_EQ(pick(0.47), 4u); // nobody
  const std::vector<LayerFragment> glass = { LayerOf(0.1f, 0.1f, 1),
    LayerOf(0.4f, 1.0f, 3, LayerFragment::Opaque) };
  const PixelLayers behind = SortLayers(glass, 1, 1, false);
  EXPECT_EQ(vitrine::FirstPartWithShare(glass, behind, 0, 2, 0.5), 1u);
}

}
