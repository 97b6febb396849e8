/** How lists are sorted, by their length: in registers, as far as a device has them, or in runs. */
#ifndef VITRINE_CORE_LISTS_SORT_PLAN_H
#define VITRINE_CORE_LISTS_SORT_PLAN_H

#include <vector>

namespace vitrine
{

/** The programs that sort a list. */
enum class ListSort
{
  Network,     ///< One network over whole fragments in registers (ListResolve.glsl).
  SlotNetwork, ///< One network over depths with the fragments' slots (ListResolveSlots.glsl).
  Runs,    ///< Runs are sorted by networks, then merged (ListSortRuns.glsl, ListMergeRuns.glsl).
  LongRuns ///< The same with runs of several networks' blocks (ListSortLongRuns.glsl).
};

/** Lists up to a length that have the same program. */
struct SortBin
{
  int Limit; ///< Length of the longest list. The last bin of a plan has no limit.
  ListSort Sort;
  int Size;    ///< Fragments that one network sorts, or number of runs that are merged.
  int RunSize; ///< Fragments of a run, or of a block of a longer run. 0 for networks.
};

struct SortPlan
{
  std::vector<SortBin> Bins; ///< By ascending limits.
  int MaximumRuns;           ///< Longer lists have longer runs.
  int RunGroup;              ///< Runs of a merge are in groups of this size.
  /**
   * Programs of networks composite one register after the other in a loop. So the code for coincident fragments is in
   * the program once, and no array is needed for it.
   */
  bool BlendsInTurn;
};

/** The facts about a method and a device that decide a plan. */
struct SortTraits
{
  int FragmentWords = 3; ///< Words of a fragment in the registers of a network.
  int RunWords = 3;      ///< Words of a fragment in the registers of programs for runs.
  bool HasSlots =
    false; ///< The fragments of a list are successive nodes, so that a slot names one.
  /**
   * The device spills registers beyond 128 an invocation, and then takes minutes to compile. Software rasterisers have
   * no such bound: they keep registers in memory that is cached.
   */
  bool HasFewRegisters = false;
  bool HasTolerance =
    false; ///< Fragments that coincide are composited as a group, which takes registers.
};

/** A slot takes the low bits of a word, and the depth the others. */
inline constexpr int SlotBits = 6;

SortPlan PlanSort(const SortTraits& traits);

}
#endif
