#include "Core/lists/SortingNetwork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

using vitrine::BestKnownNetwork;
using vitrine::Comparator;
using vitrine::EmitGlsl;
using vitrine::OddEvenMergeNetwork;
using vitrine::SortingNetwork;
using vitrine::SortsAllZeroOneInputs;

template <typename T, typename Less>
void Apply(const SortingNetwork& network, std::vector<T>& values, Less less)
{
  for (const Comparator& comparator : network.Comparators)
  {
    if (less(values[comparator.High], values[comparator.Low]))
    {
      std::swap(values[comparator.Low], values[comparator.High]);
    }
  }
}

// Theorem Z taken at its word: every input of zeros and ones, 64 of them in the bits of a word.
bool SortsEachZeroOneInput(const SortingNetwork& network)
{
  const std::uint64_t count = std::uint64_t{ 1 } << network.Size;
  std::vector<std::uint64_t> wires(network.Size);
  for (std::uint64_t first = 0; first < count; first += 64)
  {
    const int inputs = static_cast<int>(std::min<std::uint64_t>(64, count - first));
    for (int wire = 0; wire < network.Size; ++wire)
    {
      wires[wire] = 0;
      for (int i = 0; i < inputs; ++i)
      {
        wires[wire] |= ((first + i) >> wire & 1) << i;
      }
    }
    for (const Comparator& comparator : network.Comparators)
    {
      const std::uint64_t low = wires[comparator.Low];
      const std::uint64_t high = wires[comparator.High];
      wires[comparator.Low] = low & high;
      wires[comparator.High] = low | high;
    }
    for (int wire = 1; wire < network.Size; ++wire)
    {
      if (wires[wire - 1] & ~wires[wire])
      {
        return false;
      }
    }
  }
  return true;
}

SortingNetwork Without(SortingNetwork network, std::size_t index)
{
  network.Comparators.erase(network.Comparators.begin() + index);
  return network;
}

std::size_t LayerCount(const SortingNetwork& network)
{
  std::vector<std::size_t> depths(network.Size);
  for (const Comparator& c : network.Comparators)
  {
    depths[c.Low] = depths[c.High] = std::max(depths[c.Low], depths[c.High]) + 1;
  }
  return depths.empty() ? 0 : *std::max_element(depths.begin(), depths.end());
}

TEST(SortingNetwork, ProverAgreesWithEveryInputTriedOneByOne)
{
  for (int size = 0; size <= 14; ++size)
  {
    SCOPED_TRACE(size);
    for (const SortingNetwork& network : { OddEvenMergeNetwork(size), BestKnownNetwork(size) })
    {
      EXPECT_TRUE(SortsEachZeroOneInput(network));
      EXPECT_TRUE(SortsAllZeroOneInputs(network));
      for (std::size_t i = 0; size <= 10 && i < network.Comparators.size(); ++i)
      {
        const SortingNetwork broken = Without(network, i);
        EXPECT_EQ(SortsAllZeroOneInputs(broken), SortsEachZeroOneInput(broken)) << i;
      }
    }
  }
}

TEST(SortingNetwork, ProverAgreesOnRandomNetworks)
{
  const unsigned seed = 20250301;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int sorting = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    SortingNetwork network{ static_cast<int>(2 + random() % 5), {} };
    const std::size_t length = random() % 40;
    while (network.Comparators.size() < length)
    {
      int low = random() % network.Size;
      int high = random() % network.Size;
      // Now and then one upside down: such networks may sort or not, and the two must agree.
      if (low > high && random() % 8)
      {
        std::swap(low, high);
      }
      if (low != high)
      {
        network.Comparators.push_back({ low, high });
      }
    }
    const bool sorts = SortsEachZeroOneInput(network);
    sorting += sorts;
    EXPECT_EQ(SortsAllZeroOneInputs(network), sorts) << trial;
  }
  EXPECT_GT(sorting, 300);
  EXPECT_LT(sorting, 2700);
}

TEST(SortingNetwork, BatcherSortsAnyNumberOfInputs)
{
  for (int size = 0; size <= vitrine::LargestProvableNetwork; ++size)
  {
    EXPECT_TRUE(SortsAllZeroOneInputs(OddEvenMergeNetwork(size))) << size;
  }
}

TEST(SortingNetwork, BestKnownSortsAnyNumberOfInputs)
{
  for (int size = 0; size <= vitrine::LargestProvableNetwork; ++size)
  {
    const SortingNetwork network = BestKnownNetwork(size);
    EXPECT_EQ(network.Size, size);
    EXPECT_TRUE(SortsAllZeroOneInputs(network)) << size;
  }
}

TEST(SortingNetwork, EachComparatorOfTheSmallestNetworksCounts)
{
  for (int size : { 4, 8, 12, 16, 24, 64 })
  {
    const SortingNetwork network = BestKnownNetwork(size);
    const std::size_t step = size <= 16 ? 1 : network.Comparators.size() / 3;
    for (std::size_t i = 0; i < network.Comparators.size(); i += step)
    {
      EXPECT_FALSE(SortsAllZeroOneInputs(Without(network, i))) << size << " without " << i;
    }
  }
}

TEST(SortingNetwork, BatcherHasTheKnownSizes)
{
  const std::pair<int, std::size_t> known[] = { { 0, 0 }, { 1, 0 }, { 2, 1 }, { 4, 5 }, { 8, 19 },
    { 16, 63 }, { 32, 191 }, { 64, 543 } };
  for (const auto& [size, comparators] : known)
  {
    EXPECT_EQ(OddEvenMergeNetwork(size).Comparators.size(), comparators) << size;
  }
}

TEST(SortingNetwork, BestKnownHasTheOptimalSizesAndIsNeverLarger)
{
  const std::size_t known[] = { 0, 0, 1, 3, 5, 9, 12, 16, 19, 25, 29, 35, 39, 45, 51, 56, 60 };
  for (int size = 0; size <= 16; ++size)
  {
    EXPECT_EQ(BestKnownNetwork(size).Comparators.size(), known[size]) << size;
  }
  const std::pair<int, std::size_t> larger[] = { { 24, 120 }, { 32, 185 }, { 48, 346 },
    { 64, 521 } };
  for (const auto& [size, comparators] : larger)
  {
    EXPECT_EQ(BestKnownNetwork(size).Comparators.size(), comparators) << size;
  }
  for (int size = 0; size <= 64; ++size)
  {
    EXPECT_LE(
      BestKnownNetwork(size).Comparators.size(), OddEvenMergeNetwork(size).Comparators.size())
      << size;
  }
  EXPECT_EQ(BestKnownNetwork(65).Comparators.size(), OddEvenMergeNetwork(65).Comparators.size());
}

TEST(SortingNetwork, BestKnownIsListedLayerByLayer)
{
  for (int size = 2; size <= 64; ++size)
  {
    SCOPED_TRACE(size);
    const SortingNetwork network = BestKnownNetwork(size);
    std::size_t breaks = 0;
    std::vector<bool> isTaken(size);
    for (const Comparator& c : network.Comparators)
    {
      EXPECT_LT(c.Low, c.High);
      if (isTaken[c.Low] || isTaken[c.High])
      {
        isTaken.assign(size, false);
        ++breaks;
      }
      isTaken[c.Low] = isTaken[c.High] = true;
    }
    EXPECT_EQ(breaks + 1, LayerCount(network));
  }
}

TEST(SortingNetwork, SortsRandomInputAndCarriesThePayload)
{
  const unsigned seed = 411;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  using Item = std::pair<int, int>; // key, payload
  for (int size : { 1, 2, 7, 16, 33, 64, 65, 100, 200, 257 })
  {
    SCOPED_TRACE(size);
    const SortingNetwork network = BestKnownNetwork(size);
    for (int trial = 0; trial < 100; ++trial)
    {
      std::vector<Item> items(size);
      for (int i = 0; i < size; ++i)
      {
        items[i] = { static_cast<int>(random() % (1 + trial)), i };
      }
      std::vector<Item> sorted = items;
      Apply(network, sorted, [](const Item& a, const Item& b) { return a.first < b.first; });
      EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end(),
        [](const Item& a, const Item& b) { return a.first < b.first; }));
      std::sort(sorted.begin(), sorted.end());
      std::sort(items.begin(), items.end());
      EXPECT_EQ(sorted, items);
    }
  }
}

TEST(SortingNetwork, ProverRejectsWhatIsNoNetwork)
{
  EXPECT_FALSE(SortsAllZeroOneInputs({ 2, {} }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 64, {} }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 2, { { 1, 0 } } }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 2, { { 0, 1 }, { 1, 1 } } }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 2, { { 0, 1 }, { 0, 2 } } }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 2, { { -1, 1 }, { 0, 1 } } }));
  EXPECT_FALSE(SortsAllZeroOneInputs({ 4, { { 0, 1 }, { 2, 3 } } }));
  EXPECT_TRUE(SortsAllZeroOneInputs({ 0, {} }));
  EXPECT_TRUE(SortsAllZeroOneInputs({ 1, {} }));
}

TEST(SortingNetwork, ProverSaysWhenItCannotDecide)
{
  // Six groups of ten wires, each with more than 2^9 vectors, joined one after the other.
  SortingNetwork network{ 60, {} };
  for (int wire = 0; wire < 60; ++wire)
  {
    if (wire % 10 > 0)
    {
      network.Comparators.push_back({ wire / 10 * 10, wire });
    }
  }
  for (int group = 10; group < 60; group += 10)
  {
    network.Comparators.push_back({ 0, group });
  }
  EXPECT_THROW(SortsAllZeroOneInputs(network), std::length_error);
}

std::vector<std::pair<int, int>> ParseCalls(const std::string& glsl, const std::string& call)
{
  std::vector<std::pair<int, int>> calls;
  const std::regex pattern(call);
  for (std::sregex_iterator i(glsl.begin(), glsl.end(), pattern), end; i != end; ++i)
  {
    calls.emplace_back(std::stoi((*i)[1]), std::stoi((*i)[2]));
  }
  return calls;
}

TEST(SortingNetwork, EmittedGlslIsTheNetwork)
{
  for (int size : { 0, 1, 2, 3, 9, 16, 64 })
  {
    SCOPED_TRACE(size);
    const SortingNetwork network = BestKnownNetwork(size);
    std::vector<std::pair<int, int>> comparators;
    for (const Comparator& c : network.Comparators)
    {
      comparators.emplace_back(c.Low, c.High);
    }
    const std::string plain = EmitGlsl(network, "SORT");
    EXPECT_EQ(ParseCalls(plain, R"(SORT\((\d+), (\d+)\);)"), comparators);
    const std::string named = EmitGlsl(network, "ORDER", "f");
    EXPECT_EQ(ParseCalls(named, R"(ORDER\(f(\d+), f(\d+)\);)"), comparators);
    // Nothing but the calls.
    EXPECT_TRUE(std::regex_match(named, std::regex(R"((ORDER\(f\d+, f\d+\);[ \n])*)")));
  }
}

TEST(SortingNetwork, EmittedGlslBreaksLines)
{
  EXPECT_EQ(EmitGlsl({ 2, {} }, "S"), "");
  EXPECT_EQ(EmitGlsl({ 3, { { 0, 2 }, { 0, 1 } } }, "S"), "S(0, 2); S(0, 1);\n");
  const std::string text = EmitGlsl(BestKnownNetwork(5), "S");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

}
