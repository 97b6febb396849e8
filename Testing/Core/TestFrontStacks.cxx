#include "Core/reveal/FrontStacks.h"

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

TEST(FrontStacks, CountsPixelsWithNothingInFront)
{
  FrontStacks stacks;
  AddPixel(stacks, {});
  AddPixel(stacks, { 5 });
  AddPixel(stacks, {});
  EXPECT_EQ(stacks.Pixels(), 3u);
  EXPECT_EQ(stacks.CoveredPixels(), 1u);
  EXPECT_EQ(stacks.Count(), 1u);
}

}
