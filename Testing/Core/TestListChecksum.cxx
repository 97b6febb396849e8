// The checksum tells lists apart, but not the order among equal keys.
#include "study/sorts/ListChecksum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace
{

using vitrine::ListChecksum;
using vitrine::SortList;
using Checksum = std::array<std::uint32_t, 2>;

TEST(ListChecksum, IsThePolynomialAndTheSum)
{
  const std::uint32_t factor = 0x9e3779b1u;
  const std::uint32_t unused = 0xffffffffu;
  const Checksum expected = { (5u * factor + 7u) * factor + unused,
    (5u + 0x85ebca6bu) * (1u + 0xc2b2ae35u) + (7u + 0x85ebca6bu) * (2u + 0xc2b2ae35u) +
      (unused + 0x85ebca6bu) * 0xc2b2ae35u };
  EXPECT_EQ(ListChecksum({ { 5, 1 }, { 7, 2 } }, 3), expected);
  EXPECT_EQ(ListChecksum({}, 0), (Checksum{ 0, 0 }));
}

TEST(ListChecksum, LetsEqualKeysStandInAnyOrder)
{
  EXPECT_EQ(ListChecksum({ { 5, 1 }, { 5, 2 }, { 6, 3 } }, 4),
    ListChecksum({ { 5, 2 }, { 5, 1 }, { 6, 3 } }, 4));
}

TEST(ListChecksum, SeesEveryMistakeOfASort)
{
  const unsigned seed = 99;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 20000; ++trial)
  {
    SortList list(2 + random() % 15);
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      list[i] = { static_cast<std::uint32_t>(i * (1 + trial % 3)),
        static_cast<std::uint32_t>(random()) };
    }
    const Checksum right = ListChecksum(list, 16);
    const std::size_t a = random() % list.size();
    const std::size_t b = (a + 1 + random() % (list.size() - 1)) % list.size();
    SortList disordered = list;
    std::swap(disordered[a], disordered[b]);
    EXPECT_NE(ListChecksum(disordered, 16), right) << "an exchange that is missing";
    SortList mixedUp = list;
    std::swap(mixedUp[a].Payload, mixedUp[b].Payload);
    EXPECT_NE(ListChecksum(mixedUp, 16), right) << "a payload that went with another key";
    SortList lost = list;
    lost[a] = lost[b];
    EXPECT_NE(ListChecksum(lost, 16), right) << "an element that is there twice";
    SortList shorter = list;
    shorter.pop_back();
    EXPECT_NE(ListChecksum(shorter, 16), right) << "an element that is gone";
  }
}

}
