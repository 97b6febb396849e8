// The sorts as sequences of comparators: proved, counted, and their gaps.
#include "study/sorts/ListSorts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace
{

using vitrine::CountComparisons;
using vitrine::ListSort;
using vitrine::MostComparisons;

std::vector<std::uint32_t> Ascending(int size)
{
  std::vector<std::uint32_t> keys(size);
  std::iota(keys.begin(), keys.end(), 1u);
  return keys;
}

std::vector<std::uint32_t> Descending(int size)
{
  std::vector<std::uint32_t> keys = Ascending(size);
  std::reverse(keys.begin(), keys.end());
  return keys;
}

TEST(ListSorts, HaveTheNamesOfCommands)
{
  std::set<std::string> names;
  for (const ListSort sort : vitrine::AllListSorts)
  {
    const std::string name = vitrine::NameOf(sort);
    names.insert(name);
    EXPECT_EQ(vitrine::FindListSort(name), sort);
  }
  EXPECT_EQ(
    names, (std::set<std::string>{ "insertion", "shell", "bitonic", "odd-even-merge", "network" }));
  EXPECT_FALSE(vitrine::FindListSort("Shell").has_value());
  EXPECT_FALSE(vitrine::FindListSort("").has_value());
}

TEST(ListSorts, ShellGapsAreProductsOfTwosAndThrees)
{
  EXPECT_EQ(vitrine::ShellGaps(0), std::vector<int>());
  EXPECT_EQ(vitrine::ShellGaps(1), std::vector<int>());
  EXPECT_EQ(vitrine::ShellGaps(2), std::vector<int>{ 1 });
  EXPECT_EQ(vitrine::ShellGaps(4), (std::vector<int>{ 3, 2, 1 }));
  EXPECT_EQ(
    vitrine::ShellGaps(33), (std::vector<int>{ 32, 27, 24, 18, 16, 12, 9, 8, 6, 4, 3, 2, 1 }));
  EXPECT_EQ(vitrine::ShellGaps(64).front(), 54);
}

TEST(ListSorts, ShellAndBitonicSortEveryZeroOneInput)
{
  for (int size = 1; size <= 20; ++size)
  {
    EXPECT_TRUE(vitrine::SortsAllZeroOneInputs(vitrine::ShellNetwork(size))) << size;
  }
  for (int size = 1; size <= 64; size *= 2)
  {
    EXPECT_TRUE(vitrine::SortsAllZeroOneInputs(vitrine::BitonicNetwork(size))) << size;
  }
}

// Too large for the prover: 2^size inputs of zeros and ones would have to be held.
TEST(ListSorts, LongListsAreSortedByShell)
{
  const unsigned seed = 1971;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int size = 21; size <= 64; ++size)
  {
    const vitrine::SortingNetwork network = vitrine::ShellNetwork(size);
    for (int trial = 0; trial < 2000; ++trial)
    {
      std::vector<std::uint32_t> keys(size);
      const std::uint32_t range = trial % 2 ? 2u : 1000u;
      std::generate(keys.begin(), keys.end(), [&] { return random() % range; });
      for (const vitrine::Comparator& c : network.Comparators)
      {
        if (keys[c.High] < keys[c.Low])
        {
          std::swap(keys[c.High], keys[c.Low]);
        }
      }
      ASSERT_TRUE(std::is_sorted(keys.begin(), keys.end())) << size;
    }
  }
}

TEST(ListSorts, HaveTheKnownCounts)
{
  const int sizes[] = { 4, 8, 16, 32, 64 };
  const std::int64_t network[] = { 5, 19, 60, 185, 521 };
  const std::int64_t oddEvenMerge[] = { 5, 19, 63, 191, 543 };
  const std::int64_t bitonic[] = { 6, 24, 80, 240, 672 };
  // n less each gap, summed: (4-3) + (4-2) + (4-1) = 6 for 4.
  const std::int64_t shell[] = { 6, 24, 83, 254, 724 };
  for (int i = 0; i < 5; ++i)
  {
    const int n = sizes[i];
    SCOPED_TRACE(n);
    EXPECT_EQ(MostComparisons(ListSort::Insertion, n), n * (n - 1) / 2);
    EXPECT_EQ(MostComparisons(ListSort::Shell, n), shell[i]);
    EXPECT_EQ(MostComparisons(ListSort::Bitonic, n), bitonic[i]);
    EXPECT_EQ(MostComparisons(ListSort::OddEvenMerge, n), oddEvenMerge[i]);
    EXPECT_EQ(MostComparisons(ListSort::Network, n), network[i]);
  }
}

TEST(ListSorts, InsertionCountsWhatItCompares)
{
  for (int n = 1; n <= 64; ++n)
  {
    EXPECT_EQ(CountComparisons(ListSort::Insertion, 64, Ascending(n)), n - 1);
    EXPECT_EQ(CountComparisons(ListSort::Insertion, 64, Descending(n)), n * (n - 1) / 2);
    EXPECT_EQ(CountComparisons(ListSort::Insertion, 64, std::vector<std::uint32_t>(n, 7u)), n - 1);
  }
  EXPECT_EQ(CountComparisons(ListSort::Insertion, 4, { 2, 3, 1 }), 3);
}

TEST(ListSorts, LoopsEndWithTheListAndTheNetworkDoesNot)
{
  EXPECT_EQ(CountComparisons(ListSort::Shell, 64, Ascending(4)), 6);
  EXPECT_EQ(CountComparisons(ListSort::Bitonic, 64, Ascending(3)), 6);
  EXPECT_EQ(CountComparisons(ListSort::Bitonic, 64, Ascending(5)), 24);
  EXPECT_EQ(CountComparisons(ListSort::OddEvenMerge, 64, Ascending(3)), 3);
  EXPECT_EQ(CountComparisons(ListSort::Network, 64, Ascending(3)), 521);
  for (const ListSort sort : vitrine::AllListSorts)
  {
    const std::int64_t none = sort == ListSort::Network ? 185 : 0;
    EXPECT_EQ(CountComparisons(sort, 32, {}), none);
    EXPECT_EQ(CountComparisons(sort, 32, { 5 }), none);
  }
}

}
