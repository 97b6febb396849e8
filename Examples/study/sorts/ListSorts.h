/**
 * The sorts of short lists that are measured against each other, as sequences of comparisons.
 *
 * The shaders Sort*.glsl carry these out on the device. Here they are counted and proved.
 */
#ifndef VITRINE_STUDY_SORTS_LIST_SORTS_H
#define VITRINE_STUDY_SORTS_LIST_SORTS_H

#include "Core/lists/SortingNetwork.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

enum class ListSort
{
  Insertion,
  Shell,
  Bitonic,
  OddEvenMerge,
  Network
};

inline constexpr std::array<ListSort, 5> AllListSorts = { ListSort::Insertion, ListSort::Shell,
  ListSort::Bitonic, ListSort::OddEvenMerge, ListSort::Network };

/** Its name in commands and reports: insertion, shell, bitonic, odd-even-merge, network. */
std::string NameOf(ListSort sort);

/** The sort of that name, if there is one. */
std::optional<ListSort> FindListSort(const std::string& name);

/**
 * The gaps of Shell's sort for lists of up to `size` elements: all 2^p 3^q below `size`, descending.
 *
 * With these gaps an element moves one step at most in each pass, so that a pass is one comparison an element:
 * V. R. Pratt, Shellsort and Sorting Networks, Stanford 1972 (also Knuth, TAOCP 3, 5.2.1).
 */
std::vector<int> ShellGaps(int size);

/** Shell's sort with ShellGaps() for lists of `size` elements. */
SortingNetwork ShellNetwork(int size);

/**
 * Batcher's bitonic sort for lists of `size` elements, a power of two. Comparators of descending runs have the
 * higher wire as their Low.
 *
 * K. E. Batcher: Sorting networks and their applications. AFIPS 1968.
 */
SortingNetwork BitonicNetwork(int size);

/**
 * The comparisons, each with an exchange where it is out of order, by which `sort` orders keys that stand in storage for
 * `capacity` of them, a power of two. Insertion's depend on the keys. The loops of Shell's sort and odd-even merge end
 * with the list, bitonic's with the next power of two; the network always sorts the whole storage.
 */
std::int64_t CountComparisons(ListSort sort, int capacity, const std::vector<std::uint32_t>& keys);

/** The most comparisons that any list in storage for `capacity` elements takes. */
std::int64_t MostComparisons(ListSort sort, int capacity);

}

#endif
