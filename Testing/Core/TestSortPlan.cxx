// Tests which program sorts lists of each length (Core/lists/SortPlan).
#include "Core/lists/SortPlan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using vitrine::ListSort;
using vitrine::PlanSort;
using vitrine::SortBin;
using vitrine::SortPlan;

namespace
{

const SortBin& BinOf(const SortPlan& plan, int length)
{
  return *std::find_if(
    plan.Bins.begin(), plan.Bins.end(), [=](const SortBin& bin) { return length <= bin.Limit; });
}

TEST(SortPlan, OfSoftwareSortsUpTo64AsAWhole)
{
  for (const int words : { 2, 3, 4 })
  {
    const SortPlan plan = PlanSort({ words, true, false });
    EXPECT_EQ(BinOf(plan, 64).Sort, ListSort::Network);
    EXPECT_EQ(BinOf(plan, 65).Sort, ListSort::Runs);
    EXPECT_EQ(BinOf(plan, 1025).Sort, ListSort::LongRuns);
  }
}

TEST(SortPlan, OfADeviceKeepsAtMost64WordsInANetwork)
{
  for (const int words : { 2, 3, 4 })
  {
    for (const bool hasSlots : { false, true })
    {
      for (const SortBin& bin : PlanSort({ words, hasSlots, true }).Bins)
      {
        EXPECT_LE((bin.Sort == ListSort::Network ? words : 1) * bin.Size, 64);
      }
    }
  }
}

TEST(SortPlan, OfADeviceSortsSlotsWhereThereAreAny)
{
  EXPECT_EQ(BinOf(PlanSort({ 3, true, true }), 16).Sort, ListSort::Network);
  EXPECT_EQ(BinOf(PlanSort({ 3, true, true }), 17).Sort, ListSort::SlotNetwork);
  EXPECT_EQ(BinOf(PlanSort({ 3, true, true }), 64).Sort, ListSort::SlotNetwork);
  EXPECT_EQ(BinOf(PlanSort({ 3, false, true }), 17).Sort, ListSort::Runs);
  EXPECT_EQ(BinOf(PlanSort({ 2, true, true }), 32).Sort, ListSort::Network);
}

TEST(SortPlan, CoversAllLengthsInOrder)
{
  for (const bool isDevice : { false, true })
  {
    const SortPlan plan = PlanSort({ 3, false, isDevice });
    for (std::size_t i = 1; i < plan.Bins.size(); ++i)
    {
      EXPECT_LT(plan.Bins[i - 1].Limit, plan.Bins[i].Limit);
    }
    EXPECT_EQ(plan.Bins.back().Limit, std::numeric_limits<int>::max());
    EXPECT_EQ(plan.MaximumRuns % plan.RunGroup, 0);
  }
}

}
