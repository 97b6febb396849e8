#include "Core/lists/SortPlan.h"

#include <limits>

namespace vitrine
{
namespace
{

// The largest network, which is also the largest of which a proof is known (SortingNetworkTables).
constexpr int LargestNetwork = 64;
static_assert(LargestNetwork <= 1 << SlotBits, "slots name all fragments of a network");

// Registers of a device that a network may take. Intel's have 128 a thread, of which addresses, colours and exchanges
// take the rest.
constexpr int NetworkWords = 64;

SortPlan PlanForSoftware()
{
  return { {}, 32, 32, 8 };
}

SortPlan PlanForDevice()
{
  return { {}, 16, 16, 4 };
}

void AddRuns(SortPlan& plan)
{
  plan.Bins.push_back({ plan.RunSize * plan.RunGroup, ListSort::Runs, plan.RunGroup });
  plan.Bins.push_back({ plan.RunSize * plan.MaximumRuns, ListSort::Runs, plan.MaximumRuns });
  plan.Bins.push_back({ std::numeric_limits<int>::max(), ListSort::LongRuns, plan.MaximumRuns });
}

}

SortPlan PlanSort(const SortTraits& traits)
{
  SortPlan plan = traits.HasFewRegisters ? PlanForDevice() : PlanForSoftware();
  for (int size = 8; size <= LargestNetwork; size *= 2)
  {
    if (!traits.HasFewRegisters || size * traits.FragmentWords <= NetworkWords)
    {
      plan.Bins.push_back({ size, ListSort::Network, size });
    }
    else if (traits.HasSlots)
    {
      plan.Bins.push_back({ size, ListSort::SlotNetwork, size });
    }
  }
  AddRuns(plan);
  return plan;
}

}
