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

// Returns the layers of ranks, each in its order, as SortLayers() gives them.
std::vector<std::vector<LayerFragment>> SortedOnEach(
  const std::vector<std::vector<LayerFragment>>& ofRanks, std::size_t pixels, bool keepHidden)
{
  std::vector<std::vector<LayerFragment>> sorted;
  for (const std::vector<LayerFragment>& fragments : ofRanks)
  {
    sorted.emplace_back();
    for (const vitrine::PixelLayer& layer : SortLayers(fragments, pixels, 1, keepHidden).Layers)
    {
      sorted.back().push_back(fragments[layer.Fragment]);
    }
  }
  return sorted;
}

TEST(PixelLayers, OfRanksAreThoseOfOne)
{
  constexpr std::size_t Pixels = 4;
  std::mt19937 random(7);
  const auto below = [&](std::uint32_t end) { return std::uint32_t(random() % end); };
  for (const bool keepHidden : { false, true })
  {
    std::vector<LayerFragment> all;
    std::vector<std::vector<LayerFragment>> ofRanks(3);
    for (std::uint32_t i = 0; i < 200; ++i)
    {
      const bool isOpaque = below(10) == 0;
      // Translucent ones have equal depths, and some equal colours, too.
      const float depth = isOpaque ? 0.1f + 0.001f * float(i) : 0.1f * float(below(8));
      LayerFragment f = LayerOf(depth, 0.25f * float(1 + below(3)), below(5),
        isOpaque ? LayerFragment::Opaque : 0, 1, below(Pixels));
      f.Part |= below(2) * LayerFragment::BackFace;
      ofRanks[below(3)].push_back(f);
    }
    for (std::size_t rank = 0; rank < 3; ++rank)
    {
      for (LayerFragment f : ofRanks[rank])
      {
        f.Part += 100 * std::uint32_t(rank);
        all.push_back(f);
      }
    }
    const PixelLayers expected = SortLayers(all, Pixels, 1, keepHidden);
    std::vector<vitrine::RankPart> parts;
    const std::vector<LayerFragment> joined =
      vitrine::JoinLayers(SortedOnEach(ofRanks, Pixels, keepHidden), parts);
    const PixelLayers layers = SortLayers(joined, Pixels, 1, keepHidden);
    ASSERT_EQ(layers.Offsets, expected.Offsets);
    for (std::size_t i = 0; i < layers.Layers.size(); ++i)
    {
      const LayerFragment& a = joined[layers.Layers[i].Fragment];
      const LayerFragment& b = all[expected.Layers[i].Fragment];
      const vitrine::RankPart& part = parts.at(a.Part & ~LayerFragment::BackFace);
      EXPECT_EQ(layers.Layers[i].Share, expected.Layers[i].Share);
      EXPECT_EQ(a.Depth, b.Depth);
      EXPECT_EQ(a.Part & LayerFragment::BackFace, b.Part & LayerFragment::BackFace);
      EXPECT_EQ(100 * part.Rank + part.Part, b.Part & ~LayerFragment::BackFace);
    }
  }
}

// The picture of ranks has the larger colour, of those that each rank's depth test left.
TEST(PixelLayers, OfRanksThatAreOpaqueAndOfEqualDepthHaveTheLargerColorInFront)
{
  const std::uint32_t later = LayerFragment::Opaque | 1u << LayerFragment::FirstDrawBit;
  const auto of = [](float blue, std::uint32_t part, std::uint32_t kind)
  {
    LayerFragment f = LayerOf(0.5f, 1.0f, part, kind);
    f.Rgba[2] = blue;
    return f;
  };
  const std::vector<std::vector<LayerFragment>> ofRanks = { { of(0.9f, 1, LayerFragment::Opaque),
                                                              of(0.3f, 2, later) },
    { of(0.1f, 3, LayerFragment::Opaque), of(0.6f, 4, later) }, { of(0.4f, 5, later) } };
  std::vector<vitrine::RankPart> parts;
  const std::vector<LayerFragment> joined =
    vitrine::JoinLayers(SortedOnEach(ofRanks, 1, true), parts);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t part : PartsInOrder(joined, SortLayers(joined, 1, 1, true)))
  {
    order.push_back(parts.at(part).Part);
  }
  EXPECT_EQ(order, (std::vector<std::uint32_t>{ 4, 3, 5, 2, 1 }));
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
