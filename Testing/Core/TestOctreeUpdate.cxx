#include "OctreeScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace octree_scenes;
using Moves = std::vector<Octree::MovedItem>;

const Box HereBox{ glm::vec3(0), glm::vec3(0.1f) };
const Box ThereBox{ glm::vec3(5), glm::vec3(5.1f) };

void MoveAll(Octree& tree, const Moves& moves, const std::vector<Box>& boxes)
{
  tree.Move(moves.data(), moves.size(), ViewOf(boxes));
}

TEST(OctreeUpdate, MovedItemIsWhereItsBoxIsNow)
{
  std::vector<Box> boxes{ HereBox, ThereBox, ThereBox };
  Octree tree(ViewOf(boxes), 1);
  EXPECT_EQ(tree.Bounds(), (Box{ glm::vec3(0), glm::vec3(5.1f) }));
  boxes[0] = ThereBox;
  MoveAll(tree, { { 0, HereBox } }, boxes);
  EXPECT_EQ(tree.Bounds(), ThereBox);
  CheckTree(tree, boxes);
  EXPECT_EQ(tree.StrayCount(), 0u);
}

TEST(OctreeUpdate, LastItemTakenOutLeavesAnEmptyTree)
{
  const std::vector<Box> boxes{ HereBox, ThereBox };
  Octree tree(ViewOf(boxes), 1);
  tree.Remove(0, HereBox, ViewOf(boxes));
  TreeCheck(tree, boxes, { 1 });
  tree.Remove(1, ThereBox, ViewOf(boxes));
  EXPECT_TRUE(tree.IsEmpty());
  tree.Insert(0, ViewOf(boxes));
  EXPECT_EQ(tree.Bounds(), HereBox);
  TreeCheck(tree, boxes, { 0 });
}

TEST(OctreeUpdate, WhatLeavesTheSpaceOfTheTreeIsAStray)
{
  std::vector<Box> boxes{ HereBox, ThereBox, ThereBox };
  Octree tree(ViewOf(boxes), 1);
  boxes[1] = { glm::vec3(500), glm::vec3(501) };
  MoveAll(tree, { { 1, ThereBox } }, boxes);
  EXPECT_EQ(tree.StrayCount(), 1u);
  CheckTree(tree, boxes);
  MoveAll(tree, { { 1, std::exchange(boxes[1], HereBox) } }, boxes);
  EXPECT_EQ(tree.StrayCount(), 0u);
  CheckTree(tree, boxes);
}

TEST(OctreeUpdate, ItemMovesBetweenATreeAndTheUnplaced)
{
  const Box nowhere{ glm::vec3(std::numeric_limits<float>::quiet_NaN()), glm::vec3(1) };
  std::vector<Box> boxes{ HereBox, nowhere, ThereBox };
  Octree tree(ViewOf(boxes), 1);
  EXPECT_EQ(tree.UnplacedItems(), std::vector<std::uint32_t>{ 1 });
  boxes[0] = nowhere;
  boxes[1] = HereBox;
  MoveAll(tree, { { 0, HereBox }, { 1, nowhere } }, boxes);
  EXPECT_EQ(tree.UnplacedItems(), std::vector<std::uint32_t>{ 0 });
  CheckTree(tree, boxes);
}

TEST(OctreeUpdate, NodesAreSplitAndMergedAsItemsComeAndGo)
{
  const unsigned seed = 30;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<Box> boxes = RandomBoxes(Kinds::Small, 2000, random);
  Octree tree;
  for (std::uint32_t item = 0; item < 2000; ++item)
  {
    tree.Insert(item, ViewOf(boxes));
  }
  CheckTree(tree, boxes);
  EXPECT_GT(tree.TopPage().Nodes.size(), 30u);
  for (std::uint32_t item = 0; item < 1990; ++item)
  {
    tree.Remove(item, boxes[item], ViewOf(boxes));
  }
  EXPECT_TRUE(tree.TopPage().Nodes[0].IsLeaf());
}

// Boxes that are all the same, and how many were asked for.
class SameBoxes : public vitrine::ItemBoxes
{
public:
  std::uint32_t Count() const override { return 20000; }

  void Read(const std::uint32_t*, std::size_t count, Box* boxes) const override
  {
    this->Asked += count;
    std::fill_n(boxes, count, HereBox);
  }

  mutable std::size_t Asked = 0;
};

TEST(OctreeUpdate, ThousandsInOnePlaceAreAddedWithoutTryingToSplitThemEachTime)
{
  const SameBoxes boxes;
  Octree tree;
  for (std::uint32_t item = 0; item < boxes.Count(); ++item)
  {
    tree.Insert(item, boxes);
  }
  EXPECT_TRUE(tree.TopPage().Nodes[0].IsLeaf());
  EXPECT_EQ(tree.TopPage().Nodes[0].Count(), boxes.Count());
  EXPECT_LT(boxes.Asked, std::size_t{ 20 } * boxes.Count());
}

TEST(OctreeUpdate, MemoryDoesNotGrowAsItemsMoveToAndFro)
{
  const unsigned seed = 31;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<Box> boxes = RandomBoxes(Kinds::Small, 3000, random);
  Octree tree(ViewOf(boxes), 8);
  const auto shuffle = [&](int rounds)
  {
    for (int i = 0; i < rounds; ++i)
    {
      const std::uint32_t item = random() % 3000;
      MoveAll(
        tree, { { item, std::exchange(boxes[item], RandomBox(Kinds::Small, random)) } }, boxes);
    }
  };
  shuffle(30000);
  const std::size_t bytes = tree.Bytes();
  shuffle(60000);
  EXPECT_LT(tree.Bytes(), bytes + bytes / 2);
}

TEST(OctreeUpdate, RandomMovesLeaveATreeAsIfBuiltAnew)
{
  const unsigned seed = 32;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    for (const std::uint32_t leafSize : { 1u, 2u, 9u })
    {
      SCOPED_TRACE(static_cast<int>(kind));
      SCOPED_TRACE(leafSize);
      std::vector<Box> boxes = RandomBoxes(kind, 300, random);
      Octree tree(ViewOf(boxes), leafSize);
      std::set<std::uint32_t> held;
      for (std::uint32_t item = 0; item < 300; ++item)
      {
        held.insert(item);
      }
      for (int round = 0; round < 60; ++round)
      {
        SCOPED_TRACE(round);
        std::set<std::uint32_t> chosen;
        for (int i = 1 + random() % 30; i > 0; --i)
        {
          chosen.insert(random() % 300);
        }
        Moves moves;
        for (const std::uint32_t item : chosen)
        {
          if (held.count(item) == 0)
          {
            tree.Insert(item, ViewOf(boxes));
            held.insert(item);
          }
          else if (random() % 4 == 0)
          {
            tree.Remove(item, boxes[item], ViewOf(boxes));
            held.erase(item);
          }
          else
          {
            moves.push_back({ item, boxes[item] });
          }
        }
        for (const Octree::MovedItem& move : moves)
        {
          // Now and then to where other kinds are, which is outside of the space that the tree was built around.
          const Kinds target = random() % 10 == 0 ? AllKinds()[random() % 6] : kind;
          boxes[move.Item] = RandomBox(target, random);
        }
        MoveAll(tree, moves, boxes);
        TreeCheck(tree, boxes, held);
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}

}
