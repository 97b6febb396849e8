// Runs of items: they hold all items in their order, and lie where the items do.
#include "Core/culling/mesh/OrderedRuns.h"

#include <gtest/gtest.h>

using vitrine::Box;
using vitrine::CutIntoRuns;
using vitrine::LeastItemsOfARun;
using vitrine::MostItemsOfARun;
using vitrine::OrderedRun;

namespace
{

Box Unit(float x, float y = 0.0f, float z = 0.0f)
{
  return { { x, y, z }, { x + 1.0f, y + 1.0f, z + 1.0f } };
}

/** Boxes of parts far from each other, each of so many items. */
std::vector<Box> PartsOf(const std::vector<std::uint32_t>& sizes)
{
  std::vector<Box> boxes;
  for (std::size_t part = 0; part < sizes.size(); ++part)
  {
    boxes.insert(boxes.end(), sizes[part],
      Unit(1000.0f * static_cast<float>(part % 7), 900.0f * static_cast<float>(part % 5)));
  }
  return boxes;
}

std::vector<std::uint32_t> SizesOf(const std::vector<OrderedRun>& runs)
{
  std::vector<std::uint32_t> sizes;
  for (const OrderedRun& run : runs)
  {
    sizes.push_back(run.Count);
  }
  return sizes;
}

void ExpectToHoldAll(const std::vector<OrderedRun>& runs, const std::vector<Box>& boxes)
{
  std::uint32_t next = 0;
  for (const OrderedRun& run : runs)
  {
    EXPECT_EQ(run.First, next);
    EXPECT_LE(run.Count, MostItemsOfARun);
    EXPECT_TRUE(runs.size() == 1 || run.Count >= LeastItemsOfARun) << run.Count;
    Box around;
    for (std::uint32_t i = run.First; i < run.First + run.Count; ++i)
    {
      around.Add(boxes[i]);
    }
    EXPECT_TRUE(run.Bounds == around) << "run at " << run.First;
    next += run.Count;
  }
  EXPECT_EQ(next, boxes.size());
}
}

TEST(OrderedRuns, AreThePartsOfAMesh)
{
  const std::vector<std::uint32_t> sizes = { 300, 1000, 256, 4000, 700, 280, 2222 };
  const std::vector<Box> boxes = PartsOf(sizes);
  const std::vector<OrderedRun> runs = CutIntoRuns(boxes);
  ExpectToHoldAll(runs, boxes);
  EXPECT_EQ(SizesOf(runs), sizes);
}

TEST(OrderedRuns, HoldSeveralPartsThatAreSmall)
{
  const std::vector<Box> boxes = PartsOf(std::vector<std::uint32_t>(500, 12));
  const std::vector<OrderedRun> runs = CutIntoRuns(boxes);
  ExpectToHoldAll(runs, boxes);
  EXPECT_GT(runs.size(), 6000u / MostItemsOfARun);
}

TEST(OrderedRuns, AreNotCutWhereThatSavesNothing)
{
  EXPECT_EQ(CutIntoRuns(std::vector<Box>(MostItemsOfARun, Unit(3.0f))).size(), 1u);
}

TEST(OrderedRuns, AreNeverLongerThanTheMost)
{
  for (const Box& box : { Unit(3.0f), Box{ { 1, 1, 1 }, { 1, 1, 1 } },
         Box{ { -3e38f, -3e38f, -3e38f }, { 3e38f, 3e38f, 3e38f } } })
  {
    const std::vector<Box> boxes(3 * MostItemsOfARun + 1, box);
    ExpectToHoldAll(CutIntoRuns(boxes), boxes);
  }
}

TEST(OrderedRuns, AreFewWhereThereAreFewItems)
{
  EXPECT_TRUE(CutIntoRuns({}).empty());
  for (const std::uint32_t count : { 1u, 2u, LeastItemsOfARun, 2 * LeastItemsOfARun - 1 })
  {
    const std::vector<Box> boxes = PartsOf({ count / 2, count - count / 2 });
    const std::vector<OrderedRun> runs = CutIntoRuns(boxes);
    ExpectToHoldAll(runs, boxes);
    EXPECT_EQ(runs.size(), 1u);
  }
}
