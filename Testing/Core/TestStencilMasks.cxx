// Groups, the values that their stencil begins with, and what is counted by what is left.
#include "Core/lists/StencilCounts.h"
#include "Core/lists/StencilMasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{

// The stencil of one place as OpenGL runs it: EQUAL to the passing value; DECR, which ends at 0. Returns which of the
// fragments passed.
std::vector<int> Pass(const vitrine::MaskGroup& group, std::uint8_t& value, int fragments)
{
  std::vector<int> passed;
  for (int i = 0; i < fragments; ++i)
  {
    if (value == group.PassingValue())
    {
      passed.push_back(i);
    }
    value = static_cast<std::uint8_t>(std::max(value - 1, 0));
  }
  return passed;
}

class Masks : public testing::TestWithParam<int>
{
protected:
  vitrine::MaskGroup Group = *vitrine::FindMaskGroup(GetParam());
};

TEST_P(Masks, HaveAPlaceForEachLayer)
{
  EXPECT_EQ(this->Group.Layers(), GetParam());
  EXPECT_EQ(vitrine::MaskStartValues(this->Group).size(), std::size_t(GetParam()));
}

TEST_P(Masks, LetEachOfTheFirstFragmentsThroughOnceAndNoOther)
{
  for (const int fragments : { 0, 1, 3, 4, 8, 9, 15, 16, 17, 200, 254, 255, 256, 257, 512, 2000 })
  {
    SCOPED_TRACE(fragments);
    std::multiset<int> all;
    for (std::uint8_t value : vitrine::MaskStartValues(this->Group))
    {
      const std::vector<int> passed = Pass(this->Group, value, fragments);
      all.insert(passed.begin(), passed.end());
    }
    std::multiset<int> expected;
    for (int i = 0; i < std::min(fragments, GetParam()); ++i)
    {
      expected.insert(i);
    }
    EXPECT_EQ(all, expected);
  }
}

// Whichever of the places next to the middle a copy takes, it can count beyond what the group keeps.
TEST_P(Masks, BeginHighestInTheMiddle)
{
  const std::vector<std::uint8_t> start = vitrine::MaskStartValues(this->Group);
  const int w = this->Group.Width;
  const int h = this->Group.Height;
  for (const int x : { (w - 1) / 2, w / 2 })
  {
    for (const int y : { (h - 1) / 2, h / 2 })
    {
      EXPECT_GE(start[static_cast<std::size_t>(y * w + x)], 252);
    }
  }
}

TEST_P(Masks, CountFragmentsUntilTheStencilIsZero)
{
  const std::uint8_t start = 254;
  for (const int fragments : { 0, 1, GetParam(), GetParam() + 1, 100, 253 })
  {
    std::uint8_t value = start;
    Pass(this->Group, value, fragments);
    std::vector<std::uint8_t> values = { value };
    const vitrine::StencilCounts counts = vitrine::CountFragments(GetParam(), { start }, values);
    EXPECT_EQ(counts.Fragments, fragments);
    EXPECT_EQ(counts.LayersMax, fragments);
    EXPECT_EQ(counts.Lost, std::max(fragments - GetParam(), 0));
    EXPECT_EQ(counts.Covered, fragments > 0);
    EXPECT_EQ(counts.Saturated, 0);
    EXPECT_EQ(values[0], fragments);
  }
}

TEST_P(Masks, SayWhereThereMayBeMoreThanCounted)
{
  for (const int fragments : { 254, 255, 256, 1000 })
  {
    std::uint8_t value = 254;
    Pass(this->Group, value, fragments);
    std::vector<std::uint8_t> values = { value, 250 };
    const vitrine::StencilCounts counts = vitrine::CountFragments(GetParam(), { 254, 254 }, values);
    EXPECT_EQ(counts.Saturated, 1);
    EXPECT_EQ(counts.Fragments, 254 + 4);
    EXPECT_EQ(counts.LayersMax, 254);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Layers, Masks, testing::Values(4, 8, 9, 16), testing::PrintToStringParamName());

TEST(MaskGroups, AreOfFourSizes)
{
  for (const int layers : { -4, 0, 1, 2, 3, 5, 7, 10, 12, 15, 17, 64 })
  {
    EXPECT_FALSE(vitrine::FindMaskGroup(layers)) << layers;
  }
}

}
