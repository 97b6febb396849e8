#include "Core/reveal/FrontStacks.h"
#include "Core/reveal/MostContext.h"

#include "Core/reveal/NearStacks.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

namespace
{

using vitrine::FrontStacks;

void AddPixel(FrontStacks& stacks, const std::vector<std::uint32_t>& layers)
{
  stacks.Add(layers.data(), layers.size());
}

// Layers of each part, by numbers.
std::map<std::uint32_t, std::uint32_t> StackOf(const FrontStacks& stacks, std::size_t stack)
{
  std::map<std::uint32_t, std::uint32_t> layers;
  for (const auto* entry = stacks.Begin(stack); entry != stacks.End(stack); ++entry)
  {
    EXPECT_TRUE(layers.emplace(stacks.Parts()[entry->Column], entry->Layers).second);
  }
  return layers;
}

TEST(FrontStacks, KeepsAStackOnceInWhateverOrderItsLayersCome)
{
  FrontStacks stacks;
  AddPixel(stacks, { 7, 3, 7 });
  AddPixel(stacks, { 3, 7, 7 });
  AddPixel(stacks, { 7, 7, 3 });
  ASSERT_EQ(stacks.Count(), 1u);
  EXPECT_EQ(StackOf(stacks, 0), (std::map<std::uint32_t, std::uint32_t>{ { 3, 1 }, { 7, 2 } }));
  EXPECT_EQ(stacks.Parts(), (std::vector<std::uint32_t>{ 7, 3 }));
  EXPECT_EQ(stacks.MostLayers(), 3u);
}

TEST(FrontStacks, TellsStacksApartByPartsAndByNumbersOfLayers)
{
  FrontStacks stacks;
  AddPixel(stacks, { 1 });
  AddPixel(stacks, { 1, 1 });
  AddPixel(stacks, { 2 });
  AddPixel(stacks, { 1, 2 });
  AddPixel(stacks, { 1, 2, 2 });
  EXPECT_EQ(stacks.Count(), 5u);
  EXPECT_EQ(StackOf(stacks, 4), (std::map<std::uint32_t, std::uint32_t>{ { 1, 1 }, { 2, 2 } }));
}

TEST(FrontStacks, NothingInFrontIsNoStack)
{
  FrontStacks stacks;
  EXPECT_EQ(stacks.Add(nullptr, 0), FrontStacks::NoStack);
  AddPixel(stacks, { 5 });
  EXPECT_EQ(stacks.Count(), 1u);
}

TEST(FrontStacks, TakeAnyNumber)
{
  FrontStacks stacks;
  AddPixel(stacks, { 0xffffffffu, 0x7fffffffu, 0xffffffffu });
  ASSERT_EQ(stacks.Count(), 1u);
  EXPECT_EQ(StackOf(stacks, 0),
    (std::map<std::uint32_t, std::uint32_t>{ { 0x7fffffffu, 1 }, { 0xffffffffu, 2 } }));
}

TEST(NearStacks, AreThoseOfNeighbouringTiles)
{
  FrontStacks stacks;
  vitrine::NearStacks near(4);
  const auto add = [&](int x, int y, const std::vector<std::uint32_t>& layers)
  { near.Add(x, y, stacks.Add(layers.data(), layers.size())); };
  add(0, 0, { 1, 1 });
  add(5, 3, { 1, 2 }); // the tile on the right
  add(20, 20, { 3 });  // far away, and alone
  add(28, 20, {});     // no layer, and a tile between
  near.AddTo(stacks);
  EXPECT_TRUE(stacks.HasNear());
  ASSERT_EQ(stacks.Count(), 4u); // three of pixels, and what the first two come to
  EXPECT_FALSE(stacks.IsNear(2));
  EXPECT_TRUE(stacks.IsNear(3));
  EXPECT_EQ(StackOf(stacks, 3), (std::map<std::uint32_t, std::uint32_t>{ { 1, 2 }, { 2, 1 } }));
  // A pixel that has it makes it a stack of a pixel.
  AddPixel(stacks, { 1, 2, 1 });
  EXPECT_EQ(stacks.Count(), 4u);
  EXPECT_FALSE(stacks.HasNear());
}

TEST(FrontStacks, LeaveOutParts)
{
  vitrine::FrontStacks stacks;
  const std::uint32_t first[] = { 7, 5, 7, 9 };
  const std::uint32_t second[] = { 5 };
  stacks.Add(first, 4);
  stacks.Add(second, 1);
  stacks.AddNear({ { 0, 1 }, { 1, 1 }, { 2, 2 } }); // one layer of 7 and of 5, and two of 9
  const vitrine::FrontStacks rest = stacks.Without({ 5 });
  ASSERT_EQ(rest.Parts(), (std::vector<std::uint32_t>{ 7, 9 }));
  ASSERT_EQ(rest.Count(), 2u);
  EXPECT_EQ(rest.MostLayers(), 3u);
  EXPECT_FALSE(rest.IsNear(0));
  EXPECT_TRUE(rest.IsNear(1));
  EXPECT_EQ(vitrine::DepthOf(rest, 0, { 1.0, 10.0 }), 12.0);
  EXPECT_EQ(vitrine::DepthOf(rest, 1, { 1.0, 10.0 }), 21.0);
  EXPECT_EQ(stacks.Without({ 5, 7, 9 }).Count(), 0u);
}
}
