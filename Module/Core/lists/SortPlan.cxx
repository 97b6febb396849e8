#include "Core/lists/SortPlan.h"

#include <limits>

namespace vitrine
{
namespace
{

// The largest network, which is also the largest of which a proof is known (SortingNetworkTables).
constexpr int LargestNetwork = 64;
static_assert(LargestNetwork <= 1 << SlotBits, "slots name all fragments of a network");

// Registers of a device that a program may fill with fragments. Intel's have 128 a thread, of which addresses, colours
// and exchanges take the rest. A group of coincident fragments takes 56 for its sums.
struct RegisterBudget
{
  int NetworkWords;
  int SlotWords;
  int MergeWords;
};

RegisterBudget BudgetOf(bool hasTolerance)
{
  return hasTolerance ? RegisterBudget{ 32, 32, 36 } : RegisterBudget{ 64, 64, 84 };
}

// Words that a merge keeps of a run besides its nearest fragment: a page, and a place in it.
constexpr int PlaceWords = 2;

// A merge keeps the nearest fragment of each run, and copies of the nearest of each group and of all.
int MergedRuns(int group, int words, int budget)
{
  int runs = 4 * group;
  while (runs > group && (runs + runs / group + 1) * (words + PlaceWords) > budget)
  {
    runs -= group;
  }
  return runs;
}

struct RunPlan
{
  int RunSize;
  int BlockOfLongRuns; // Two blocks are in registers at once.
  int MaximumRuns;
  int RunGroup;
};

constexpr RunPlan RunsOfSoftware{ 32, 32, 32, 8 };

RunPlan RunsOfDevice(const SortTraits& traits, const RegisterBudget& budget)
{
  constexpr int group = 4;
  return { 16, 8, MergedRuns(group, traits.RunWords, budget.MergeWords), group };
}

void AddNetworks(SortPlan& plan, const SortTraits& traits, const RegisterBudget& budget)
{
  for (int size = 8; size <= LargestNetwork; size *= 2)
  {
    if (!traits.HasFewRegisters || size * traits.FragmentWords <= budget.NetworkWords)
    {
      plan.Bins.push_back({ size, ListSort::Network, size, 0 });
    }
    else if (traits.HasSlots && size <= budget.SlotWords)
    {
      plan.Bins.push_back({ size, ListSort::SlotNetwork, size, 0 });
    }
  }
}

void AddRuns(SortPlan& plan, const RunPlan& runs)
{
  plan.MaximumRuns = runs.MaximumRuns;
  plan.RunGroup = runs.RunGroup;
  for (const int merged : { runs.RunGroup, runs.MaximumRuns })
  {
    const int limit = runs.RunSize * merged;
    if (limit > plan.Bins.back().Limit)
    {
      plan.Bins.push_back({ limit, ListSort::Runs, merged, runs.RunSize });
    }
  }
  plan.Bins.push_back({ std::numeric_limits<int>::max(), ListSort::LongRuns, runs.MaximumRuns,
    runs.BlockOfLongRuns });
}

}

SortPlan PlanSort(const SortTraits& traits)
{
  const RegisterBudget budget = BudgetOf(traits.HasTolerance);
  SortPlan plan{};
  plan.BlendsInTurn = traits.HasFewRegisters && traits.HasTolerance;
  AddNetworks(plan, traits, budget);
  AddRuns(plan, traits.HasFewRegisters ? RunsOfDevice(traits, budget) : RunsOfSoftware);
  return plan;
}

}
