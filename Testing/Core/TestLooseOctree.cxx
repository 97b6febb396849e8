// That each item stands once where its box is, whatever is put, moved and taken out.

#include "Core/culling/walk/LooseOctree.h"

#include "NonFinite.h"
#include "OctreeScenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using octree_scenes::AllKinds;
using octree_scenes::Kinds;
using vitrine::BitsOf;
using vitrine::Box;
using vitrine::LaneCount;
using vitrine::LooseNode;
using vitrine::LooseOctree;

std::vector<Box> RandomBoxes(Kinds kind, std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  return octree_scenes::RandomBoxes(kind, count, random);
}

/** Checks all below a node; returns how many items there are. */
std::uint32_t CheckNode(const LooseOctree& tree, std::uint32_t node, const std::vector<Box>& boxes,
  std::vector<int>& seen)
{
  const LooseNode& at = tree.Node(node);
  std::uint32_t sum = 0;
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    if (!at.Has(lane))
    {
      EXPECT_EQ(at.Counts[lane], 0u);
      EXPECT_TRUE(at.Boxes.At(lane).IsEmpty());
    }
    else if (at.IsItem(lane))
    {
      ++seen[at.ItemAt(lane)];
      EXPECT_EQ(at.Boxes.At(lane), boxes[at.ItemAt(lane)]);
      EXPECT_EQ(at.Counts[lane], 1u);
      ++sum;
    }
    else
    {
      const std::uint32_t below = CheckNode(tree, at.NodeAt(lane), boxes, seen);
      EXPECT_EQ(at.Counts[lane], below);
      EXPECT_EQ(at.Boxes.At(lane), tree.Node(at.NodeAt(lane)).Boxes.Bounds());
      sum += below;
    }
  }
  return sum;
}

void Check(const LooseOctree& tree, const std::vector<Box>& boxes)
{
  std::vector<int> seen(boxes.size(), 0);
  if (!tree.IsEmpty())
  {
    CheckNode(tree, 0, boxes, seen);
  }
  std::vector<std::uint32_t> unplaced;
  for (std::uint32_t item = 0; item < boxes.size(); ++item)
  {
    ASSERT_EQ(seen[item], boxes[item].IsPlaceable()) << item;
    ASSERT_EQ(tree.Holds(item), boxes[item].IsPlaceable()) << item;
    if (!boxes[item].IsPlaceable())
    {
      unplaced.push_back(item);
    }
  }
  EXPECT_EQ(tree.Unplaced(), unplaced);
  EXPECT_EQ(tree.ItemCount(), boxes.size());
}

std::size_t NodesOf(const LooseOctree& tree, std::uint32_t node = 0)
{
  std::size_t sum = 1;
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    if (tree.Node(node).Has(lane) && !tree.Node(node).IsItem(lane))
    {
      sum += NodesOf(tree, tree.Node(node).NodeAt(lane));
    }
  }
  return sum;
}

}

TEST(LooseOctree, HoldsEachItemOnce)
{
  for (const Kinds kind : AllKinds())
  {
    for (const std::uint32_t count : { 1u, 2u, 8u, 9u, 100u, 3000u })
    {
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << " " << count);
      const std::vector<Box> boxes = RandomBoxes(kind, count, count);
      Check(LooseOctree(boxes), boxes);
    }
  }
}

TEST(LooseOctree, HoldsWhatIsPutMovedAndTakenOut)
{
  for (const Kinds kind : AllKinds())
  {
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << " " << seed);
      std::mt19937 random(seed);
      const std::vector<Box> places = RandomBoxes(kind, 400, seed);
      std::vector<Box> boxes(places.begin(), places.begin() + random() % 40);
      LooseOctree tree(boxes);
      for (std::uint32_t i = 0; i < 400; ++i)
      {
        const std::uint32_t item = random() % 3 == 0 || boxes.empty()
          ? static_cast<std::uint32_t>(boxes.size())
          : random() % static_cast<std::uint32_t>(boxes.size());
        boxes.resize(std::max<std::size_t>(boxes.size(), item + 1));
        boxes[item] = random() % 8 == 0 ? Box() : places[random() % places.size()];
        tree.SetBox(item, boxes[item]);
        EXPECT_EQ(tree.ChangeCount(), i + 1);
        if (i % 20 == 0)
        {
          Check(tree, boxes);
        }
      }
      Check(tree, boxes);
    }
  }
}

TEST(LooseOctree, IsEmptyOnceAllIsTakenOut)
{
  std::vector<Box> boxes = RandomBoxes(Kinds::Small, 200, 1);
  LooseOctree tree(boxes);
  for (std::uint32_t item = 0; item < boxes.size(); ++item)
  {
    EXPECT_FALSE(tree.IsEmpty());
    boxes[item] = Box();
    tree.SetBox(item, Box());
  }
  EXPECT_TRUE(tree.IsEmpty());
  boxes[7] = octree_scenes::BoxAt({ 1, 2, 3 }, { 1, 1, 1 });
  tree.SetBox(7, boxes[7]);
  Check(tree, boxes);
}

TEST(LooseOctree, OfNothing)
{
  EXPECT_TRUE(LooseOctree().IsEmpty());
  EXPECT_TRUE(LooseOctree({ Box(), Box() }).IsEmpty());
  EXPECT_FALSE(LooseOctree().Holds(0));
}

TEST(LooseOctree, KeepsNeighboursTogether)
{
  // A lattice of 16 to an edge: in a perfect tree 8^3 nodes hold 8 items each.
  std::vector<Box> boxes;
  for (int i = 0; i < 4096; ++i)
  {
    boxes.push_back(octree_scenes::BoxAt(
      { float(i % 16), float(i / 16 % 16), float(i / 256) }, { 0.5f, 0.5f, 0.5f }));
  }
  EXPECT_EQ(NodesOf(LooseOctree(boxes)), 1u + 8u + 64u + 512u);

  LooseOctree grown;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
  {
    const std::uint32_t item = i * 1597 % 4096;
    grown.SetBox(item, boxes[item]);
  }
  Check(grown, boxes);
  EXPECT_LT(NodesOf(grown), 2u * 585u);
}

TEST(LooseOctree, LeavesAnItemWhereItIsWhileItsCentreStaysInTheCell)
{
  std::vector<Box> boxes = RandomBoxes(Kinds::Small, 2000, 3);
  LooseOctree tree(boxes);
  const std::size_t nodes = NodesOf(tree);
  for (Box& box : boxes)
  {
    box.Max += glm::vec3(1e-7f);
    tree.SetBox(static_cast<std::uint32_t>(&box - boxes.data()), box);
  }
  Check(tree, boxes);
  EXPECT_EQ(NodesOf(tree), nodes);
}

TEST(LooseOctree, WhatIsLongStandsApartBeforeTheRest)
{
  std::vector<Box> boxes = RandomBoxes(Kinds::Small, 500, 4);
  const LooseOctree without(boxes);
  Box all;
  for (const Box& box : boxes)
  {
    all.Add(box);
  }
  boxes.push_back(all);
  boxes.back().Max.x += 1.0f;
  const LooseOctree tree(boxes);
  Check(tree, boxes);
  const LooseNode& root = tree.Node(0);
  EXPECT_TRUE(BitsOf(root.AreLong()) & 1u);
  EXPECT_TRUE(root.IsItem(0));
  EXPECT_EQ(root.ItemAt(0), 500u);
  EXPECT_FALSE(BitsOf(root.AreLong()) & 2u);
  EXPECT_EQ(root.Counts[1], 500u);
  EXPECT_FALSE(BitsOf(without.Node(0).AreLong()) & 1u);
}

TEST(LooseOctree, FewInOneCellStandInAsFewLeavesAsHaveRoom)
{
  for (const Kinds kind : { Kinds::Small, Kinds::Points })
  {
    for (std::size_t count = 10; count <= 64; ++count)
    {
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << " " << count);
      const std::vector<Box> boxes = RandomBoxes(kind, count, static_cast<unsigned>(count));
      const LooseOctree tree(boxes);
      Check(tree, boxes);
      EXPECT_EQ(NodesOf(tree), 1u + (count + 7) / 8);
      std::vector<std::uint32_t> counts;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        if (tree.Node(0).Has(lane))
        {
          counts.push_back(tree.Node(0).Counts[lane]);
        }
      }
      EXPECT_EQ(counts.size(), (count + 7) / 8);
      const auto ends = std::minmax_element(counts.begin(), counts.end());
      EXPECT_LE(*ends.second, 8u);
      EXPECT_LE(*ends.second, *ends.first + 1) << "each has as many";
    }
  }
}

TEST(LooseOctree, LeavesHoldNeighbours)
{
  // Eight heaps of eight in a row.
  std::mt19937 random(5);
  std::vector<Box> boxes;
  for (int i = 0; i < 64; ++i)
  {
    const glm::vec3 heap(0.0f, 10.0f * static_cast<float>(i * 29 % 8), 0.0f);
    boxes.push_back(octree_scenes::BoxAt(
      heap + octree_scenes::RandomPoint(random, 0.0f, 1.0f), { 0.1f, 0.1f, 0.1f }));
  }
  const LooseOctree tree(boxes);
  Check(tree, boxes);
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    ASSERT_TRUE(tree.Node(0).Has(lane));
    const Box bounds = tree.Node(0).Boxes.At(lane);
    EXPECT_LT(bounds.Max.y - bounds.Min.y, 2.0f);
  }
}

TEST(LooseOctree, OneMoreThanALeafHoldsIsCutIntoOctants)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 9, seed);
    const LooseOctree tree(boxes);
    Check(tree, boxes);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (tree.Node(0).Has(lane))
      {
        Box centres, all;
        for (const Box& box : boxes)
        {
          const glm::vec3 centre = 0.5f * box.Min + 0.5f * box.Max;
          centres.Add({ centre, centre });
        }
        const glm::vec3 middle = 0.5f * centres.Min + 0.5f * centres.Max;
        const Box there = tree.Node(0).Boxes.At(lane);
        for (const Box& box : boxes)
        {
          const glm::vec3 centre = 0.5f * box.Min + 0.5f * box.Max;
          const int octant = (centre.x >= middle.x ? 1 : 0) | (centre.y >= middle.y ? 2 : 0) |
            (centre.z >= middle.z ? 4 : 0);
          if (octant == lane)
          {
            all.Add(box);
          }
        }
        EXPECT_EQ(there, all);
      }
    }
  }
}

TEST(LooseOctree, FewInOneCellAreFoundWhereverTheyMove)
{
  for (const std::size_t count : { 10u, 33u, 64u })
  {
    for (unsigned seed = 1; seed <= 8; ++seed)
    {
      SCOPED_TRACE(testing::Message() << count << " " << seed);
      std::mt19937 random(seed);
      std::vector<Box> boxes = RandomBoxes(Kinds::Small, count, seed);
      LooseOctree tree(boxes);
      for (int i = 0; i < 300; ++i)
      {
        const auto item = static_cast<std::uint32_t>(random() % count);
        const glm::vec3 size = boxes[item].Max - boxes[item].Min;
        const glm::vec3 place = random() % 4 == 0
          ? octree_scenes::RandomPoint(random, -3.0f, 3.0f)
          : boxes[item].Min + octree_scenes::RandomPoint(random, -0.2f, 0.2f);
        boxes[item] = octree_scenes::BoxAt(place, size);
        tree.SetBox(item, boxes[item]);
        if (i % 10 == 0)
        {
          Check(tree, boxes);
        }
      }
      Check(tree, boxes);
    }
  }
}
