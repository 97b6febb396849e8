/**
 * The measured sorts of short lists, as sequences of comparisons. The shaders Sort*.glsl execute them on the device.
 * Here they are counted and proved.
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

/** Returns the name of a sort in commands and reports: insertion, shell, bitonic, odd-even-merge or network. */
std::string NameOf(ListSort sort);

/** Returns the sort with a name, or nothing. */
std::optional<ListSort> FindListSort(const std::string& name);

/**
 * Returns the gaps of Shell's sort for lists of up to `size` elements: all 2^p 3^q below `size`, descending.
 *
 * With these gaps an element moves at most one step per pass, so a pass takes one comparison per element. (V. R. Pratt,
 * Shellsort and Sorting Networks, Stanford 1972; also Knuth, TAOCP 3, 5.2.1)
 */
std::vector<int> ShellGaps(int size);

/** Returns Shell's sort with ShellGaps() for lists of `size` elements. */
SortingNetwork ShellNetwork(int size);

/**
 * Returns Batcher's bitonic sort for lists of `size` elements, a power of two. Comparators of descending runs have the
 * higher wire as their Low. (K. E. Batcher: Sorting networks and their applications. AFIPS 1968)
 */
SortingNetwork BitonicNetwork(int size);

/**
 * Returns the number of comparisons by which `sort` orders the keys, in storage for `capacity` keys, a power of two.
 * Each comparison exchanges keys that are out of order. Only insertion's number depends on the keys. The loops of
 * Shell's sort and odd-even merge end with the list, those of bitonic sort with the next power of two. The network
 * always sorts the whole storage.
 */
std::int64_t CountComparisons(ListSort sort, int capacity, const std::vector<std::uint32_t>& keys);

/** Returns the largest number of comparisons for any list in storage for `capacity` elements. */
std::int64_t MostComparisons(ListSort sort, int capacity);

}

#endif
