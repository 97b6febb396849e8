// Proves sorting networks by the 0-1 principle over sets of reachable vectors (D. E. Knuth, The Art of Computer
// Programming 3, 5.3.4, Theorem Z). The sets of outputs are those of M. Codish, L. Cruz-Filipe, M. Frank and P.
// Schneider-Kamp: Twenty-five comparators is optimal when sorting nine inputs, 2014.

#include "Core/lists/SortingNetwork.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace vitrine
{

namespace
{

// One bit for each wire, at the wire's number.
using ZeroOneVector = std::uint64_t;
using VectorSet = std::vector<ZeroOneVector>; // sorted, without duplicates

constexpr std::size_t largestSet = std::size_t{ 1 } << 22;

ZeroOneVector WireBit(int wire)
{
  return ZeroOneVector{ 1 } << wire;
}

// The wires, grouped by the comparators applied so far, and the vectors that can occur on each group.
class ReachableVectors
{
public:
  explicit ReachableVectors(int size)
    : Group(size)
    , Sets(size)
  {
    std::iota(this->Group.begin(), this->Group.end(), 0);
    for (int wire = 0; wire < size; ++wire)
    {
      this->Sets[wire] = { 0, WireBit(wire) };
    }
  }

  // Returns the number of vectors that joining the comparator's two groups would produce, or 0 if they are one group.
  std::size_t Cost(Comparator comparator) const
  {
    const int low = this->Group[comparator.Low];
    const int high = this->Group[comparator.High];
    return low == high ? 0 : this->Sets[low].size() * this->Sets[high].size();
  }

  void Apply(Comparator comparator)
  {
    this->Join(this->Group[comparator.Low], this->Group[comparator.High]);
    this->Exchange(this->Sets[this->Group[comparator.Low]], comparator);
  }

  // If some wires are not in the first group, its vectors are not sorted: these wires are zero where the group is all
  // ones.
  bool AreAllSorted() const
  {
    return this->Group.empty() || this->IsSorted(this->Sets[this->Group.front()]);
  }

private:
  void Join(int kept, int dissolved)
  {
    if (kept == dissolved)
    {
      return;
    }
    VectorSet product;
    product.reserve(this->Sets[kept].size() * this->Sets[dissolved].size());
    for (ZeroOneVector a : this->Sets[kept])
    {
      for (ZeroOneVector b : this->Sets[dissolved])
      {
        product.push_back(a | b);
      }
    }
    std::sort(product.begin(), product.end());
    this->Sets[kept] = std::move(product);
    this->Sets[dissolved].clear();
    std::replace(this->Group.begin(), this->Group.end(), dissolved, kept);
  }

  static void Exchange(VectorSet& set, Comparator comparator)
  {
    const ZeroOneVector low = WireBit(comparator.Low);
    const ZeroOneVector high = WireBit(comparator.High);
    // An exchange adds the same number to each vector that it changes, so both parts stay sorted.
    const auto exchanged = std::stable_partition(
      set.begin(), set.end(), [=](ZeroOneVector v) { return !(v & low) || (v & high); });
    std::for_each(exchanged, set.end(), [=](ZeroOneVector& v) { v ^= low | high; });
    VectorSet merged;
    merged.reserve(set.size());
    std::set_union(set.begin(), exchanged, exchanged, set.end(), std::back_inserter(merged));
    set = std::move(merged);
  }

  bool IsSorted(const VectorSet& set) const
  {
    const std::size_t size = this->Group.size();
    return std::all_of(set.begin(), set.end(),
      [size](ZeroOneVector v)
      {
        // In a sorted vector the ones are above the zeros. Filling the zeros below the lowest one then fills every
        // wire.
        const ZeroOneVector all = ~ZeroOneVector{ 0 } >> (64 - size);
        return v == 0 || (v | (v - 1)) == all;
      });
  }

  std::vector<int> Group;      // by wire: the number of its group
  std::vector<VectorSet> Sets; // by number of group
};

// Returns the comparator to apply next: the cheapest of those whose wires have no earlier comparator left.
std::size_t CheapestReady(const SortingNetwork& network, const std::vector<bool>& isApplied,
  const ReachableVectors& vectors)
{
  ZeroOneVector blocked = 0;
  std::size_t best = network.Comparators.size();
  std::size_t bestCost = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < network.Comparators.size() && bestCost > 0; ++i)
  {
    if (isApplied[i])
    {
      continue;
    }
    const Comparator comparator = network.Comparators[i];
    const ZeroOneVector wires = WireBit(comparator.Low) | WireBit(comparator.High);
    const std::size_t cost = vectors.Cost(comparator);
    if ((blocked & wires) == 0 && cost < bestCost)
    {
      best = i;
      bestCost = cost;
    }
    blocked |= wires;
  }
  if (bestCost > largestSet)
  {
    throw std::length_error("the network's 0-1 vectors are too many to hold");
  }
  return best;
}

bool IsValid(const SortingNetwork& network)
{
  return std::all_of(network.Comparators.begin(), network.Comparators.end(),
    [&network](Comparator c)
    {
      return c.Low >= 0 && c.High >= 0 && c.Low < network.Size && c.High < network.Size &&
        c.Low != c.High;
    });
}

}

bool SortsAllZeroOneInputs(const SortingNetwork& network)
{
  assert(network.Size >= 0 && network.Size <= LargestProvableNetwork);
  if (!IsValid(network))
  {
    return false;
  }
  ReachableVectors vectors(network.Size);
  std::vector<bool> isApplied(network.Comparators.size());
  for (std::size_t count = 0; count < network.Comparators.size(); ++count)
  {
    const std::size_t next = CheapestReady(network, isApplied, vectors);
    vectors.Apply(network.Comparators[next]);
    isApplied[next] = true;
  }
  return vectors.AreAllSorted();
}

}
