#include "NonFinite.h"
#include "OctreeScenes.h"

#include "Core/octree/ItemMarks.h"
#include "Core/octree/Octree.h"
#include "Core/octree/OctreeWalk.h"
#include "Core/octree/TriangleBoxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace
{

using namespace octree_scenes;
using vitrine::ItemMarks;
using vitrine::OrderAlong;
using vitrine::OrderFromEye;
using vitrine::TriangleBoxes;
using vitrine::WalkFrontToBack;

// Enters every node and keeps what it comes by.
struct Recorder
{
  std::vector<std::uint32_t> Items;
  std::vector<Box> Leaves;
  int Nodes = 0;

  bool Enter(const OctreeNode&)
  {
    ++this->Nodes;
    return true;
  }

  void Visit(const OctreeNode& leaf, const std::uint32_t* items, std::uint32_t count)
  {
    this->Items.insert(this->Items.end(), items, items + count);
    this->Leaves.push_back(leaf.Bounds);
  }
};

// A point box at each corner of the unit cube, by the bits of its number.
std::vector<Box> CubeCorners()
{
  std::vector<Box> boxes;
  for (int i = 0; i < 8; ++i)
  {
    const glm::vec3 corner(i & 1, i >> 1 & 1, i >> 2 & 1);
    boxes.push_back({ corner, corner });
  }
  return boxes;
}

TEST(Box, AroundDoublesHoldsThem)
{
  const Box box = Box::Around({ 0.1, -0.1, 1.0 }, { 0.1, -0.1, 1.0 });
  EXPECT_LE(double{ box.Min.x }, 0.1);
  EXPECT_GE(double{ box.Max.x }, 0.1);
  EXPECT_LE(double{ box.Min.y }, -0.1);
  EXPECT_GE(double{ box.Max.y }, -0.1);
  EXPECT_EQ(std::nextafter(box.Min.x, 1.0f), box.Max.x);
  EXPECT_EQ(box.Min.z, 1.0f);
  EXPECT_EQ(box.Max.z, 1.0f);
  const Box huge = Box::Around({ -1e300, 0, NotANumber }, { 1e300, 0, 0 });
  EXPECT_EQ(huge.Max.x, Infinity);
  EXPECT_EQ(huge.Min.x, -Infinity);
  EXPECT_FALSE(huge.IsPlaceable());
  EXPECT_TRUE(huge.IsEmpty());
}

TEST(Box, OfEachHostileKindIsToldApart)
{
  EXPECT_TRUE(Box().IsEmpty());
  EXPECT_FALSE(Box::Everything().IsEmpty());
  EXPECT_FALSE(Box::Everything().IsPlaceable());
  EXPECT_TRUE((Box{ glm::vec3(1), glm::vec3(1) }).IsPlaceable());
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const float number : { NotANumber, Infinity, -Infinity })
    {
      Box box{ glm::vec3(0), glm::vec3(1) };
      box.Min[axis] = number;
      EXPECT_FALSE(box.IsPlaceable());
      EXPECT_EQ(box.IsEmpty(), !(number < 0));
      box = { glm::vec3(0), glm::vec3(1) };
      box.Max[axis] = number;
      EXPECT_FALSE(box.IsPlaceable());
      EXPECT_EQ(box.IsEmpty(), !(number > 0));
    }
    Box inverted{ glm::vec3(1), glm::vec3(1) };
    inverted.Max[axis] = -1;
    EXPECT_TRUE(inverted.IsEmpty());
    EXPECT_FALSE(inverted.IsPlaceable());
    EXPECT_FALSE(Touches(inverted, Box::Everything()));
    EXPECT_FALSE(Contains(Box::Everything(), inverted));
  }
}

TEST(TriangleBoxes, AreTheTightestAndNanWhereAPointIsNotFinite)
{
  const float points[] = { 0, 0, 0, 1, -2, 3, -4, 5, 6, NotANumber, 0, 0, 0, Infinity, 0 };
  const std::uint32_t corners[] = { 0, 1, 2, 0, 1, 3, 3, 1, 0, 4, 1, 0, 1, 0, 4 };
  const TriangleBoxes<float, std::uint32_t> boxes(points, corners, 5);
  EXPECT_EQ(boxes.At(0), (Box{ { -4, -2, 0 }, { 1, 5, 6 } }));
  const double doubles[] = { 0, 0, 0, 1, -2, 3, -4, 5, 6, NotANumber, 0, 0, 0, Infinity, 0 };
  const long long numbers[] = { 0, 1, 2, 0, 1, 3, 3, 1, 0, 4, 1, 0, 1, 0, 4 };
  const TriangleBoxes<double, long long> alike(doubles, numbers, 5);
  EXPECT_EQ(alike.At(0), boxes.At(0));
  for (std::uint32_t item = 1; item < 5; ++item)
  {
    EXPECT_FALSE(boxes.At(item).IsPlaceable()) << item;
    EXPECT_TRUE(boxes.At(item).IsEmpty()) << item;
    EXPECT_TRUE(alike.At(item).IsEmpty()) << item;
  }
}

TEST(OctreeCell, OctantsPartSpace)
{
  const OctreeCell root = OctreeCell::Around({ glm::vec3(-1), glm::vec3(1) });
  EXPECT_EQ(root.Half, 1.0f);
  for (int octant = 0; octant < 8; ++octant)
  {
    const glm::vec3 point(octant & 1 ? 5 : -5, octant & 2 ? 5 : -5, octant & 4 ? 5 : -5);
    EXPECT_EQ(root.OctantsFor({ point, point }), 1u << octant);
    EXPECT_TRUE(Contains(root.Octant(octant).Extent, { point, point }));
  }
  // A point in all three split planes is on their high sides.
  EXPECT_EQ(root.OctantsFor({ glm::vec3(0), glm::vec3(0) }), 1u << 7);
  EXPECT_EQ(root.OctantsFor({ glm::vec3(-0.1f), glm::vec3(0) }), 255u);
  EXPECT_EQ(root.OctantsFor({ { -0.1f, 1, 1 }, { 0, 1, 1 } }), 1u << 6 | 1u << 7);
  // What is longer than the cell is kept, unless it lies in one octant.
  EXPECT_EQ(root.OctantsFor({ { -1, 1, 1 }, { 1, 1, 1 } }), 1u << 6 | 1u << 7);
  EXPECT_EQ(root.OctantsFor({ { -1, 1, 1 }, { 1.5f, 1, 1 } }), 0u);
  EXPECT_EQ(root.OctantsFor({ { 1, 1, 1 }, { 1, 1, 4 } }), 1u << 7);
}

TEST(OctreeCell, IsNotDividedBelowWhatFloatsTellApart)
{
  const float next = std::nextafter(1.0f, 2.0f);
  OctreeCell cell = OctreeCell::Around({ glm::vec3(-1), glm::vec3(1.5f) });
  for (int depth = 0; depth < 100; ++depth)
  {
    cell = cell.Octant(cell.OctantsFor({ glm::vec3(next), glm::vec3(next) }) == 1 ? 0 : 7);
    ASSERT_TRUE(cell.Has(glm::vec3(next)));
  }
  EXPECT_FALSE(cell.IsDivisible());
  EXPECT_FALSE(cell.Has(glm::vec3(1.0f)));
  EXPECT_FALSE(cell.Has(glm::vec3(std::nextafter(next, 2.0f))));
}

TEST(Octree, OfBoxesAsCloseAsFloatsCanBeIsDivided)
{
  std::vector<Box> boxes;
  float place = 1;
  for (int i = 0; i < 200; ++i)
  {
    boxes.push_back({ glm::vec3(place, 0, 0), glm::vec3(place, 0, 0) });
    place = std::nextafter(place, 2.0f);
  }
  boxes.push_back({ glm::vec3(-3e38f), glm::vec3(2.7e38f) });
  boxes.push_back({ glm::vec3(-7e30f), glm::vec3(-7e30f) });
  const Octree tree(ViewOf(boxes), 2);
  CheckTree(tree, boxes);
  Recorder recorder;
  WalkFrontToBack(tree, OrderFromEye(glm::vec3(0)), recorder);
  EXPECT_LT(recorder.Items.size(), 1000u);
}

TEST(Octree, OfNothingIsEmpty)
{
  EXPECT_TRUE(Octree().IsEmpty());
  const Octree tree{ ViewOf({}) };
  EXPECT_TRUE(tree.IsEmpty());
  EXPECT_TRUE(tree.Bounds().IsEmpty());
  Recorder recorder;
  WalkFrontToBack(tree, OrderFromEye(glm::vec3(0)), recorder);
  EXPECT_EQ(recorder.Nodes, 0);
}

TEST(Octree, SplitsWhileANodeHoldsMoreThanTheSetNumber)
{
  const std::vector<Box> corners = CubeCorners();
  const Octree together(ViewOf(corners), 8);
  EXPECT_EQ(together.TopPage().Nodes.size(), 1u);
  EXPECT_EQ(together.Bounds(), (Box{ glm::vec3(0), glm::vec3(1) }));
  const Octree apart(ViewOf(corners), 7);
  EXPECT_EQ(apart.TopPage().Nodes.size(), 9u);
  CheckTree(apart, corners);
}

TEST(Octree, DoesNotSplitWhatHasAPointInCommon)
{
  const std::vector<Box> same(5000, Box{ glm::vec3(1), glm::vec3(2) });
  EXPECT_EQ(Octree(ViewOf(same), 4).TopPage().Nodes.size(), 1u);
  // Long boxes through one point, as the triangles of a fan.
  std::vector<Box> fan;
  for (int i = 0; i < 1000; ++i)
  {
    fan.push_back({ glm::vec3(0), glm::vec3(i, 1000 - i, 1) });
  }
  EXPECT_EQ(Octree(ViewOf(fan), 4).TopPage().Nodes.size(), 1u);
}

TEST(Octree, DoesNotSplitAFewForLeavesThatListThemOverAndOver)
{
  // Overlapping boxes, a third of the row long each.
  std::vector<Box> boxes;
  for (int i = 0; i < 16; ++i)
  {
    boxes.push_back({ glm::vec3(i), glm::vec3(i + 5) });
  }
  EXPECT_EQ(Octree(ViewOf(boxes), 4).TopPage().Nodes.size(), 1u);
  EXPECT_GT(Octree(ViewOf(boxes), 3).TopPage().Nodes.size(), 1u);
  // Apart, they are split.
  for (Box& box : boxes)
  {
    box.Max = box.Min + 0.5f;
  }
  EXPECT_GT(Octree(ViewOf(boxes), 4).TopPage().Nodes.size(), 1u);
}

TEST(Octree, KeepsLongItemsOutOfSmallCells)
{
  std::vector<Box> boxes = CubeCorners();
  boxes.push_back({ glm::vec3(-1), glm::vec3(1.9f) }); // longer than the root's octants
  boxes.push_back({ glm::vec3(-1), glm::vec3(2) });
  const Octree tree(ViewOf(boxes), 1);
  CheckTree(tree, boxes);
  Recorder recorder;
  WalkFrontToBack(tree, OrderFromEye(glm::vec3(0)), recorder);
  EXPECT_LE(recorder.Items.size(), 8u + 2u * 27u);
}

TEST(Octree, OfOneItemFarOutStaysShallowEnough)
{
  std::vector<Box> boxes = CubeCorners();
  boxes.push_back({ glm::vec3(3e38f), glm::vec3(3e38f) });
  boxes.push_back({ glm::vec3(-3e38f), glm::vec3(3e38f) });
  CheckTree(Octree(ViewOf(boxes), 1), boxes);
}

TEST(Octree, BuiltOfRandomBoxesKeepsItsPromises)
{
  const unsigned seed = 20;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    for (const std::uint32_t leafSize : { 1u, 7u, 64u })
    {
      SCOPED_TRACE(static_cast<int>(kind));
      SCOPED_TRACE(leafSize);
      const std::vector<Box> boxes = RandomBoxes(kind, 1 + random() % 3000, random);
      CheckTree(Octree(ViewOf(boxes), leafSize), boxes);
    }
  }
}

TEST(Octree, OfManyItemsIsBuiltFromCopiesOfTheirBoxes)
{
  const unsigned seed = 21;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<Box> boxes = RandomBoxes(Kinds::Small, 300000, random);
  CheckTree(Octree(ViewOf(boxes)), boxes);
}

TEST(ItemMarks, AreSetOnceUntilCleared)
{
  ItemMarks marks(3);
  EXPECT_FALSE(marks.IsMarked(1));
  EXPECT_TRUE(marks.Mark(1));
  EXPECT_FALSE(marks.Mark(1));
  EXPECT_TRUE(marks.IsMarked(1));
  EXPECT_TRUE(marks.Mark(2));
  marks.Clear();
  EXPECT_FALSE(marks.IsMarked(1));
  EXPECT_TRUE(marks.Mark(1));
}

TEST(OctreeWalk, TakesTheCornersOfACubeFromTheEyeOutwards)
{
  const std::vector<Box> boxes = CubeCorners();
  const Octree tree(ViewOf(boxes), 1);
  for (std::uint32_t corner = 0; corner < 8; ++corner)
  {
    const glm::vec3 towards = 3.0f * (boxes[corner].Min - 0.5f);
    Recorder fromEye;
    WalkFrontToBack(tree, OrderFromEye(towards + 0.5f), fromEye);
    Recorder along;
    WalkFrontToBack(tree, OrderAlong(-towards), along);
    EXPECT_EQ(along.Items, fromEye.Items);
    ASSERT_EQ(fromEye.Items.size(), 8u);
    EXPECT_EQ(fromEye.Items.front(), corner);
    EXPECT_EQ(fromEye.Items.back(), 7 - corner);
  }
}

// Whether something in b may hide something in a: not where a plane parts them that has b on its far side.
bool MayHide(const Box& b, const Box& a, const glm::vec3& eye)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool bIsAbove = a.Max[axis] < b.Min[axis] && eye[axis] <= b.Min[axis];
    const bool bIsBelow = a.Min[axis] > b.Max[axis] && eye[axis] >= b.Max[axis];
    if (bIsAbove || bIsBelow)
    {
      return false;
    }
  }
  return true;
}

TEST(OctreeWalk, PutsNoLeafBeforeOneThatMayHideIt)
{
  const unsigned seed = 22;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  // Points are in one leaf each, and no item is kept for its length, so that the leaves have a strict order.
  std::vector<Box> boxes;
  for (int i = 0; i < 600; ++i)
  {
    const glm::vec3 point = RandomPoint(random, -1, 1);
    boxes.push_back({ point, point });
  }
  const Octree tree(ViewOf(boxes), 4);
  for (int trial = 0; trial < 20; ++trial)
  {
    const glm::vec3 eye = RandomPoint(random, -2, 2);
    Recorder recorder;
    WalkFrontToBack(tree, OrderFromEye(eye), recorder);
    for (std::size_t i = 0; i < recorder.Leaves.size(); ++i)
    {
      for (std::size_t j = i + 1; j < recorder.Leaves.size(); ++j)
      {
        ASSERT_FALSE(MayHide(recorder.Leaves[j], recorder.Leaves[i], eye)) << i << ", " << j;
      }
    }
  }
}

TEST(OctreeWalk, ComesByEachItemWhateverTheEye)
{
  const unsigned seed = 23;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    const std::vector<Box> boxes = RandomBoxes(kind, 500, random);
    const Octree tree(ViewOf(boxes), 5);
    for (int trial = 0; trial < 5; ++trial)
    {
      const glm::vec3 eye(HostileNumber(random), HostileNumber(random), HostileNumber(random));
      ItemMarks marks(500);
      Recorder recorder;
      trial % 2 == 0 ? WalkFrontToBack(tree, OrderFromEye(eye), recorder)
                     : WalkFrontToBack(tree, OrderAlong(eye), recorder);
      std::size_t found = 0;
      for (const std::uint32_t item : recorder.Items)
      {
        found += marks.Mark(item);
      }
      EXPECT_EQ(found + tree.UnplacedItems().size(), 500u);
    }
  }
}

TEST(OctreeWalk, LeavesOutWhatIsBelowANodeThatIsNotEntered)
{
  struct LeftHalf : Recorder
  {
    bool Enter(const OctreeNode& node)
    {
      this->Recorder::Enter(node);
      return node.Bounds.Min.x < 0.5f;
    }
  };
  const std::vector<Box> boxes = CubeCorners();
  const Octree tree(ViewOf(boxes), 1);
  LeftHalf visitor;
  WalkFrontToBack(tree, OrderFromEye(glm::vec3(0)), visitor);
  EXPECT_EQ(visitor.Items, (std::vector<std::uint32_t>{ 0, 2, 4, 6 }));
  EXPECT_EQ(visitor.Nodes, 9);
}

}
