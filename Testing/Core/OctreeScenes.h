#ifndef VITRINE_TESTING_CORE_OCTREE_SCENES_H
#define VITRINE_TESTING_CORE_OCTREE_SCENES_H

#include "Core/octree/OctreeWalk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace octree_scenes
{

using vitrine::Box;
using vitrine::BoxArray;
using vitrine::Octree;
using vitrine::OctreeCell;
using vitrine::OctreeNode;
using vitrine::OctreePage;

inline float Uniform(std::mt19937& random, float low, float high)
{
  return low + (high - low) * static_cast<float>(random() / 4294967296.0);
}

inline Box BoxAt(const glm::vec3& corner, const glm::vec3& size)
{
  return { corner, corner + size };
}

enum class Kinds
{
  Small,      // boxes much smaller than the scene
  Mixed,      // of all sizes, plates and rods among them
  Points,     // without extent, on a coarse lattice, so that many coincide and lie in split planes
  Clusters,   // tiny heaps far from each other
  Coincident, // all the same
  Hostile     // with NaN, infinite, huge, denormal and inverted ones
};

inline const std::vector<Kinds>& AllKinds()
{
  static const std::vector<Kinds> kinds{ Kinds::Small, Kinds::Mixed, Kinds::Points, Kinds::Clusters,
    Kinds::Coincident, Kinds::Hostile };
  return kinds;
}

inline glm::vec3 RandomPoint(std::mt19937& random, float low, float high)
{
  const float x = Uniform(random, low, high);
  const float y = Uniform(random, low, high);
  return { x, y, Uniform(random, low, high) };
}

inline float HostileNumber(std::mt19937& random)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float numbers[] = { std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 3e38f,
    -3e38f, 1e-45f, -1e-45f, 0.0f, -0.0f, 1.0f };
  return numbers[random() % std::size(numbers)];
}

inline Box RandomBox(Kinds kind, std::mt19937& random)
{
  switch (kind)
  {
    case Kinds::Small:
      return BoxAt(RandomPoint(random, -1, 1), RandomPoint(random, 0, 0.05f));
    case Kinds::Mixed:
    {
      glm::vec3 size;
      for (int axis = 0; axis < 3; ++axis)
      {
        size[axis] = std::pow(2.0f, Uniform(random, -12, 1));
      }
      return BoxAt(RandomPoint(random, -1, 1), size);
    }
    case Kinds::Points:
    {
      const glm::vec3 point(random() % 9, random() % 9, random() % 9);
      return { point, point };
    }
    case Kinds::Clusters:
    {
      const glm::vec3 heap(random() % 3 * 1e5f, random() % 2 * -1e6f, 0);
      return BoxAt(heap + RandomPoint(random, 0, 1), RandomPoint(random, 0, 0.1f));
    }
    case Kinds::Coincident:
      return { glm::vec3(1, 2, 3), glm::vec3(4, 5, 6) };
    case Kinds::Hostile:
      break;
  }
  Box box = BoxAt(RandomPoint(random, -1, 1), RandomPoint(random, -0.1f, 0.5f));
  while (random() % 3 == 0)
  {
    (random() % 2 == 0 ? box.Min : box.Max)[random() % 3] = HostileNumber(random);
  }
  return box;
}

inline std::vector<Box> RandomBoxes(Kinds kind, std::size_t count, std::mt19937& random)
{
  std::vector<Box> boxes(count);
  for (Box& box : boxes)
  {
    box = RandomBox(kind, random);
  }
  return boxes;
}

// Everything that a tree promises of its nodes, by looking at all of them.
class TreeCheck
{
public:
  TreeCheck(const Octree& tree, const std::vector<Box>& boxes, const std::set<std::uint32_t>& items)
    : Tree(tree)
    , Boxes(boxes)
  {
    std::vector<std::uint32_t> placed;
    std::vector<std::uint32_t> unplaced;
    for (const std::uint32_t item : items)
    {
      (boxes[item].IsPlaceable() ? placed : unplaced).push_back(item);
    }
    EXPECT_EQ(tree.UnplacedItems(), unplaced);
    EXPECT_EQ(tree.IsEmpty(), placed.empty());
    if (!tree.IsEmpty())
    {
      this->CheckNode(tree.TopPage(), 0, tree.RootCell(), 0, placed);
    }
  }

private:
  // Checks that the node holds exactly these items, in the leaves where they belong, under the tightest boxes.
  void CheckNode(const OctreePage& page, std::uint32_t number, const OctreeCell& cell, int depth,
    const std::vector<std::uint32_t>& items)
  {
    const OctreeNode& node = page.Nodes[number];
    ASSERT_FALSE(items.empty());
    Box bounds;
    for (const std::uint32_t item : items)
    {
      bounds.Add(this->Boxes[item].ClippedTo(cell.Extent));
    }
    EXPECT_EQ(node.Bounds, bounds);
    if (node.Kind() == OctreeNode::Kinds::Stored)
    {
      const auto stored = this->Tree.LoadPage(node);
      this->CheckNode(*stored, 0, cell, depth, items);
      return;
    }
    if (node.IsLeaf())
    {
      std::vector<std::uint32_t> held(page.ItemsOf(node), page.ItemsOf(node) + node.Count());
      std::sort(held.begin(), held.end());
      EXPECT_EQ(held, items);
      EXPECT_LE(depth, Octree::LargestDepth);
      return;
    }
    EXPECT_EQ(node.Slots() >> (OctreeNode::OwnSlot + 1), 0u);
    for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
    {
      std::vector<std::uint32_t> below;
      for (const std::uint32_t item : items)
      {
        const unsigned octants = cell.OctantsFor(this->Boxes[item]);
        const bool isHere = slot == OctreeNode::OwnSlot ? octants == 0 : (octants >> slot & 1) != 0;
        if (isHere)
        {
          below.push_back(item);
        }
      }
      ASSERT_EQ(node.HasChild(slot), !below.empty());
      if (below.empty())
      {
        continue;
      }
      if (slot == OctreeNode::OwnSlot)
      {
        EXPECT_NE(page.Nodes[node.Child(slot)].Kind(), OctreeNode::Kinds::Inner);
        this->CheckNode(page, node.Child(slot), cell, depth, below);
      }
      else
      {
        this->CheckNode(page, node.Child(slot), cell.Octant(slot), depth + 1, below);
      }
    }
  }

  const Octree& Tree;
  const std::vector<Box>& Boxes;
};

inline void CheckTree(const Octree& tree, const std::vector<Box>& boxes)
{
  std::set<std::uint32_t> items;
  for (std::uint32_t item = 0; item < boxes.size(); ++item)
  {
    items.insert(items.end(), item);
  }
  TreeCheck(tree, boxes, items);
}

inline BoxArray ViewOf(const std::vector<Box>& boxes)
{
  return BoxArray(boxes.data(), static_cast<std::uint32_t>(boxes.size()));
}

}

#endif
