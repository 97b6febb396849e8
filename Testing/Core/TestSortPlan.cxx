// Tests which program sorts lists of each length (Core/lists/SortPlan).
#include "Core/lists/SortPlan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using vitrine::ListSort;
using vitrine::PlanSort;
using vitrine::SortBin;
using vitrine::SortPlan;
using vitrine::SortTraits;

namespace
{

// A device with few registers. Nodes of `words` words of depth and colour have one word more with an extra.
SortTraits Device(
  int words, bool hasSlots = false, bool hasTolerance = false, bool hasSamples = false)
{
  const int extra = hasTolerance || hasSamples ? 1 : 0;
  return { words + (hasTolerance ? 1 : 0), words + extra, hasSlots, true, hasTolerance };
}

const SortBin& BinOf(const SortPlan& plan, int length)
{
  return *std::find_if(
    plan.Bins.begin(), plan.Bins.end(), [=](const SortBin& bin) { return length <= bin.Limit; });
}

TEST(SortPlan, OfSoftwareSortsUpTo64AsAWhole)
{
  for (const int words : { 2, 3, 4 })
  {
    const SortPlan plan = PlanSort({ words, words, true, false, false });
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
      for (const SortBin& bin : PlanSort(Device(words, hasSlots)).Bins)
      {
        EXPECT_LE((bin.Sort == ListSort::Network ? words : 1) * bin.Size, 64);
      }
    }
  }
}

// Sums of coincident fragments take 56 registers of 128.
TEST(SortPlan, OfADeviceLeavesRegistersToGroupsOfCoincidentFragments)
{
  for (const int words : { 2, 3 })
  {
    for (const bool hasSlots : { false, true })
    {
      const SortPlan plan = PlanSort(Device(words, hasSlots, true));
      EXPECT_TRUE(plan.BlendsInTurn);
      for (const SortBin& bin : plan.Bins)
      {
        EXPECT_LE((bin.Sort == ListSort::Network ? words + 1 : 1) * bin.Size, 32);
      }
    }
  }
  EXPECT_FALSE(PlanSort(Device(3)).BlendsInTurn);
}

// A run takes the words of its nearest fragment and two of its place. So do the nearest run of each group, and of all.
TEST(SortPlan, OfADeviceMergesAsManyRunsAsRegistersHold)
{
  EXPECT_EQ(PlanSort(Device(2)).MaximumRuns, 16);
  EXPECT_EQ(PlanSort(Device(3)).MaximumRuns, 12);
  EXPECT_EQ(PlanSort(Device(3, false, false, true)).MaximumRuns, 8);
  EXPECT_EQ(PlanSort(Device(3, false, true)).MaximumRuns, 4);
}

// Two blocks of a long run are in registers, and up to as many pages as a block has fragments.
TEST(SortPlan, OfADeviceSortsLongRunsInSmallBlocks)
{
  EXPECT_EQ(PlanSort(Device(3)).Bins.back().RunSize, 8);
  EXPECT_EQ(PlanSort({ 3, 3, false, false, false }).Bins.back().RunSize, 32);
}

TEST(SortPlan, OfADeviceSortsSlotsWhereThereAreAny)
{
  EXPECT_EQ(BinOf(PlanSort(Device(3, true)), 16).Sort, ListSort::Network);
  EXPECT_EQ(BinOf(PlanSort(Device(3, true)), 17).Sort, ListSort::SlotNetwork);
  EXPECT_EQ(BinOf(PlanSort(Device(3, true)), 64).Sort, ListSort::SlotNetwork);
  EXPECT_EQ(BinOf(PlanSort(Device(3, false)), 17).Sort, ListSort::Runs);
  EXPECT_EQ(BinOf(PlanSort(Device(2, true)), 32).Sort, ListSort::Network);
}

TEST(SortPlan, CoversAllLengthsInOrder)
{
  for (const SortTraits& traits : { SortTraits{}, Device(2), Device(3), Device(3, true),
         Device(2, false, true), Device(3, true, true) })
  {
    const SortPlan plan = PlanSort(traits);
    for (std::size_t i = 1; i < plan.Bins.size(); ++i)
    {
      EXPECT_LT(plan.Bins[i - 1].Limit, plan.Bins[i].Limit);
    }
    EXPECT_EQ(plan.Bins.back().Limit, std::numeric_limits<int>::max());
    EXPECT_EQ(plan.MaximumRuns % plan.RunGroup, 0);
  }
}

}
