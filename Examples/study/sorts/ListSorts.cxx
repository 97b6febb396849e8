#include "study/sorts/ListSorts.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace vitrine
{
namespace
{

int NextPowerOfTwo(int n)
{
  int power = 1;
  while (power < n)
  {
    power *= 2;
  }
  return power;
}

std::int64_t ComparatorCount(const SortingNetwork& network)
{
  return static_cast<std::int64_t>(network.Comparators.size());
}

// Each element is compared with its predecessors, from the last one down to the first that is not larger.
std::int64_t CountInsertionComparisons(std::vector<std::uint32_t> keys)
{
  std::int64_t count = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    const std::uint32_t key = keys[i];
    std::size_t place = i;
    while (place > 0)
    {
      ++count;
      if (keys[place - 1] <= key)
      {
        break;
      }
      keys[place] = keys[place - 1];
      --place;
    }
    keys[place] = key;
  }
  return count;
}

}

std::string NameOf(ListSort sort)
{
  switch (sort)
  {
    case ListSort::Insertion:
      return "insertion";
    case ListSort::Shell:
      return "shell";
    case ListSort::Bitonic:
      return "bitonic";
    case ListSort::OddEvenMerge:
      return "odd-even-merge";
    case ListSort::Network:
      return "network";
  }
  return "";
}

std::optional<ListSort> FindListSort(const std::string& name)
{
  for (const ListSort sort : AllListSorts)
  {
    if (NameOf(sort) == name)
    {
      return sort;
    }
  }
  return std::nullopt;
}

std::vector<int> ShellGaps(int size)
{
  std::vector<int> gaps;
  for (int power = 1; power < size; power *= 2)
  {
    for (int gap = power; gap < size; gap *= 3)
    {
      gaps.push_back(gap);
    }
  }
  std::sort(gaps.begin(), gaps.end(), std::greater<>());
  return gaps;
}

SortingNetwork ShellNetwork(int size)
{
  SortingNetwork network{ size, {} };
  for (const int gap : ShellGaps(size))
  {
    for (int i = 0; i + gap < size; ++i)
    {
      network.Comparators.push_back({ i, i + gap });
    }
  }
  return network;
}

SortingNetwork BitonicNetwork(int size)
{
  assert(size > 0 && (size & (size - 1)) == 0);
  SortingNetwork network{ size, {} };
  for (int run = 2; run <= size; run *= 2)
  {
    for (int stride = run / 2; stride > 0; stride /= 2)
    {
      for (int i = 0; i < size; ++i)
      {
        if ((i & stride) == 0)
        {
          const bool descends = (i & run) != 0;
          network.Comparators.push_back({ descends ? i + stride : i, descends ? i : i + stride });
        }
      }
    }
  }
  return network;
}

std::int64_t CountComparisons(ListSort sort, int capacity, const std::vector<std::uint32_t>& keys)
{
  const int length = static_cast<int>(keys.size());
  assert(length <= capacity);
  switch (sort)
  {
    case ListSort::Insertion:
      return CountInsertionComparisons(keys);
    case ListSort::Shell:
      return ComparatorCount(ShellNetwork(length));
    case ListSort::Bitonic:
      return ComparatorCount(BitonicNetwork(NextPowerOfTwo(length)));
    case ListSort::OddEvenMerge:
      return ComparatorCount(OddEvenMergeNetwork(length));
    case ListSort::Network:
      return ComparatorCount(BestKnownNetwork(capacity));
  }
  return 0;
}

std::int64_t MostComparisons(ListSort sort, int capacity)
{
  std::vector<std::uint32_t> descending(capacity);
  for (int i = 0; i < capacity; ++i)
  {
    descending[i] = static_cast<std::uint32_t>(capacity - i);
  }
  return CountComparisons(sort, capacity, descending);
}

}
