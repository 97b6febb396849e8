#include "NonFinite.h"

#include "Core/geometry/Lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace
{

using vitrine::DoubleLanes;
using vitrine::HalfLanes;
using vitrine::LaneCount;
using vitrine::LaneMask;
using vitrine::Lanes;

std::array<float, LaneCount> LanesOf(const Lanes& lanes)
{
  std::array<float, LaneCount> values;
  vitrine::StoreLanes(lanes, values.data());
  return values;
}

std::array<std::int32_t, LaneCount> LanesOf(const LaneMask& lanes)
{
  std::array<std::int32_t, LaneCount> values;
  vitrine::StoreMask(lanes, values.data());
  return values;
}

using EightFloats = std::array<float, LaneCount>;
using EightIntegers = std::array<std::int32_t, LaneCount>;

}

TEST(Lanes, AreComputedOneByOne)
{
  const Lanes a{ 1, 2, 3, 4, 5, 6, 7, 8 }, b{ 8, 4, 2, 1, -1, -2, -4, -8 };
  EXPECT_EQ(LanesOf(a + b), (EightFloats{ 9, 6, 5, 5, 4, 4, 3, 0 }));
  EXPECT_EQ(LanesOf(a - b), (EightFloats{ -7, -2, 1, 3, 6, 8, 11, 16 }));
  EXPECT_EQ(LanesOf(a * b), (EightFloats{ 8, 8, 6, 4, -5, -12, -28, -64 }));
  EXPECT_EQ(LanesOf(a / b), (EightFloats{ 0.125f, 0.5f, 1.5f, 4, -5, -3, -1.75f, -1 }));
  EXPECT_EQ(LanesOf(1.0f - 2.0f * a), (EightFloats{ -1, -3, -5, -7, -9, -11, -13, -15 }));
  EXPECT_EQ(LanesOf(-b), (EightFloats{ -8, -4, -2, -1, 1, 2, 4, 8 }));
  EXPECT_EQ(LanesOf(Lanes{}), EightFloats{});
  EXPECT_EQ(
    LanesOf(vitrine::LanesFrom(2.5f)), (EightFloats{ 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5 }));
}

TEST(Lanes, AreComparedToMasksOfAllBits)
{
  const Lanes a{ 1, 2, 3, NotANumber, Infinity, -0.0f, -1, 8 }, b = vitrine::AllLanes(2.0f);
  EXPECT_EQ(LanesOf(a < b), (EightIntegers{ -1, 0, 0, 0, 0, -1, -1, 0 }));
  EXPECT_EQ(LanesOf(a <= b), (EightIntegers{ -1, -1, 0, 0, 0, -1, -1, 0 }));
  EXPECT_EQ(LanesOf(a > b), (EightIntegers{ 0, 0, -1, 0, -1, 0, 0, -1 }));
  EXPECT_EQ(LanesOf(a >= b), (EightIntegers{ 0, -1, -1, 0, -1, 0, 0, -1 }));
  EXPECT_EQ(LanesOf(a == b), (EightIntegers{ 0, -1, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(LanesOf(a != b), (EightIntegers{ -1, 0, -1, -1, -1, -1, -1, -1 }));
  EXPECT_EQ(LanesOf(~(a < b) & (a != 8.0f)), (EightIntegers{ 0, -1, -1, -1, -1, 0, 0, 0 }));
  EXPECT_EQ(LanesOf((a < b) | (a == 8.0f)), (EightIntegers{ -1, 0, 0, 0, 0, -1, -1, -1 }));
  EXPECT_EQ(LanesOf((a < b) ^ (a < 0.0f)), (EightIntegers{ -1, 0, 0, 0, 0, -1, 0, 0 }));
  EXPECT_EQ(vitrine::BitsOf(a < b), 0b01100001u);
  EXPECT_EQ(vitrine::BitsOf(HalfLanes{ 1, 2, 3, 4 } > HalfLanes{ 2, 1, 3, 0 }), 0b1010u);
  for (const unsigned bits : { 0u, 1u, 0x80u, 0xa5u, 0xffu })
  {
    EXPECT_EQ(vitrine::BitsOf(vitrine::LaneBits(bits)), bits);
  }
  for (int count = 0; count <= LaneCount; ++count)
  {
    EXPECT_EQ(vitrine::BitsOf(vitrine::FirstLanes(count)), (1u << count) - 1u);
  }
}

TEST(Lanes, AreChosenByAMask)
{
  const Lanes a{ 1, 2, 3, 4, 5, 6, 7, 8 };
  EXPECT_EQ(LanesOf(vitrine::Chosen(a > 4.0f, a, -a)), (EightFloats{ -1, -2, -3, -4, 5, 6, 7, 8 }));
  EXPECT_EQ(LanesOf(vitrine::Chosen(true, a, -a)), LanesOf(a));
  EXPECT_EQ(vitrine::Chosen(false, 1.0f, 2.0f), 2.0f);
}

TEST(Lanes, TakeTheSecondOfTwoWhereEitherIsNoNumber)
{
  const Lanes a{ 1, NotANumber, 3, -Infinity, 5, 6, 7, 8 }, b{ 2, 2, NotANumber, 2, 2, 2, 2, 2 };
  const auto least = LanesOf(vitrine::LeastOf(a, b));
  const auto greatest = LanesOf(vitrine::GreatestOf(a, b));
  EXPECT_EQ(least[0], 1.0f);
  EXPECT_EQ(least[1], 2.0f);
  EXPECT_TRUE(std::isnan(least[2]));
  EXPECT_EQ(least[3], -Infinity);
  EXPECT_EQ(greatest[0], 2.0f);
  EXPECT_EQ(greatest[1], 2.0f);
  EXPECT_TRUE(std::isnan(greatest[2]));
  EXPECT_EQ(greatest[3], 2.0f);
}

TEST(Lanes, GiveOneNumber)
{
  const Lanes a{ 3, -7, 11, 2, 19, 5, -1, 4 };
  EXPECT_EQ(vitrine::LeastLane(a), -7.0f);
  EXPECT_EQ(vitrine::GreatestLane(a), 19.0f);
  EXPECT_EQ(vitrine::SumOfLanes(a), 36.0f);
  // Halves are added first, so that both large numbers go before the small ones are lost in them.
  EXPECT_EQ(vitrine::SumOfLanes(Lanes{ 1e8f, 1, 1, 1, -1e8f, 1, 1, 1 }), 6.0f);
}

TEST(Lanes, ArePickedAndStoredInAnyOrder)
{
  const Lanes a{ 10, 11, 12, 13, 14, 15, 16, 17 };
  EXPECT_EQ(LanesOf(vitrine::Picked(a, LaneMask{ 7, 0, 0, 3, 2, 1, 6, 7 })),
    (EightFloats{ 17, 10, 10, 13, 12, 11, 16, 17 }));
  EXPECT_EQ(
    LanesOf(vitrine::SizeOf(a - 13.5f)), (EightFloats{ 3.5, 2.5, 1.5, 0.5, 0.5, 1.5, 2.5, 3.5 }));
  const LaneMask numbers{ 0, 1, 2, 3, 4, 5, 6, 7 };
  std::int32_t stored[4 * LaneCount];
  vitrine::StoreInterleaved(numbers, numbers + 10, numbers + 20, numbers + 30, stored);
  for (int i = 0; i < 4 * LaneCount; ++i)
  {
    EXPECT_EQ(stored[i], i / 4 + 10 * (i % 4));
  }
  EXPECT_EQ(LanesOf(vitrine::Converted<LaneMask>(Lanes{ 0.9f, 1, 1.5f, -0.5f, -1.9f, 1e6f, 7, 0 })),
    (EightIntegers{ 0, 1, 1, 0, -1, 1000000, 7, 0 }));
}

TEST(Lanes, OfDoublesAreRoundedToFloats)
{
  const double values[] = { 1.0 + 0x1p-30, -0x1p-3, 3.0, -1e300 };
  const DoubleLanes lanes = vitrine::LoadDoubles(values);
  double sizes[4];
  vitrine::StoreDoubles(vitrine::SizeOf(lanes), sizes);
  EXPECT_EQ(sizes[1], 0x1p-3);
  EXPECT_EQ(sizes[3], 1e300);
  float floats[4];
  vitrine::StoreAsFloats(lanes, floats);
  EXPECT_EQ(floats[0], 1.0f);
  EXPECT_EQ(floats[1], -0x1p-3f);
  EXPECT_EQ(floats[3], -Infinity);
}

TEST(Bits, AreFoundAndCounted)
{
  for (int place = 0; place < 64; ++place)
  {
    const std::uint64_t bit = std::uint64_t{ 1 } << place, above = ~(bit - 1);
    EXPECT_EQ(vitrine::LowestBit(bit), place);
    EXPECT_EQ(vitrine::LowestBit(above), place);
    EXPECT_EQ(vitrine::CountBits(above), 64 - place);
    EXPECT_EQ(vitrine::CountBits(~bit), 63);
    if (place < 32)
    {
      EXPECT_EQ(vitrine::LowestBit(static_cast<std::uint32_t>(above)), place);
      EXPECT_EQ(vitrine::CountBits(static_cast<std::uint32_t>(above)), 32 - place);
    }
  }
  EXPECT_EQ(vitrine::CountBits(std::uint64_t{ 0 }), 0);
}
