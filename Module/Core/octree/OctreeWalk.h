#ifndef VITRINE_CORE_OCTREE_OCTREE_WALK_H
#define VITRINE_CORE_OCTREE_OCTREE_WALK_H

#include "Core/octree/Octree.h"

#include <glm/vec3.hpp>

namespace vitrine
{

/**
 * The order of a perspective view. In each cell the eye's octant comes first, and no octant precedes one that may hide
 * it.
 */
class OrderFromEye
{
public:
  explicit OrderFromEye(const glm::vec3& eye)
    : Eye(eye)
  {
  }

  int NearestOctant(const OctreeCell& cell) const
  {
    return (this->Eye.x >= cell.Centre.x ? 1 : 0) | (this->Eye.y >= cell.Centre.y ? 2 : 0) |
      (this->Eye.z >= cell.Centre.z ? 4 : 0);
  }

private:
  glm::vec3 Eye;
};

/** The order of a parallel view along a direction. */
class OrderAlong
{
public:
  explicit OrderAlong(const glm::vec3& direction)
    : Nearest((direction.x < 0 ? 1 : 0) | (direction.y < 0 ? 2 : 0) | (direction.z < 0 ? 4 : 0))
  {
  }

  int NearestOctant(const OctreeCell&) const { return this->Nearest; }

private:
  int Nearest;
};

/**
 * Walks a tree from front to back. In a cell, the items that are too long for octants come first, then octant after
 * octant. The earlier one of two octants is on the viewer's side of the plane between them, so nothing in the later
 * cell can hide anything in the earlier one. If a number of the order is not finite, the whole tree is still walked.
 *
 * Pages on disk are loaded when they are entered, and held while the walk is in them.
 *
 * @param order    OrderFromEye, OrderAlong, or an object with their NearestOctant()
 * @param visitor  `bool Enter(const OctreeNode& node)`: returns true to enter a node, whose Bounds contain everything
 *                 below; `void Visit(const OctreeNode& leaf, const std::uint32_t* items, std::uint32_t count)`:
 *                 receives the items of an entered leaf. An item comes once for each leaf that it stands in.
 * @throws         std::runtime_error if a page cannot be read
 */
template <class Order, class Visitor>
void WalkFrontToBack(const Octree& tree, const Order& order, Visitor& visitor);

/** The steps of WalkFrontToBack(). */
template <class Order, class Visitor>
class OctreeWalker
{
public:
  OctreeWalker(const Octree& tree, const Order& order, Visitor& visitor)
    : Tree(tree)
    , Sequence(order)
    , Caller(visitor)
  {
  }

  void Walk(const OctreePage& page, const OctreeNode& node, const OctreeCell& cell)
  {
    if (this->Caller.Enter(node))
    {
      this->WalkInto(page, node, cell);
    }
  }

private:
  void WalkInto(const OctreePage& page, const OctreeNode& node, const OctreeCell& cell)
  {
    switch (node.Kind())
    {
      case OctreeNode::Kinds::Leaf:
        this->Caller.Visit(node, page.ItemsOf(node), node.Count());
        break;
      case OctreeNode::Kinds::Inner:
        this->WalkChildren(page, node, cell);
        break;
      case OctreeNode::Kinds::Stored:
        const std::shared_ptr<const OctreePage> stored = this->Tree.LoadPage(node);
        this->WalkInto(*stored, stored->Nodes[0], cell);
        break;
    }
  }

  void WalkChildren(const OctreePage& page, const OctreeNode& node, const OctreeCell& cell)
  {
    if (node.HasChild(OctreeNode::OwnSlot))
    {
      this->Walk(page, page.Nodes[node.Child(OctreeNode::OwnSlot)], cell);
    }
    const int nearest = this->Sequence.NearestOctant(cell);
    for (int i = 0; i < 8; ++i)
    {
      const int octant = i ^ nearest;
      if (node.HasChild(octant))
      {
        const OctreeNode& child = page.Nodes[node.Child(octant)];
        if (this->Caller.Enter(child))
        {
          this->WalkInto(page, child, cell.Octant(octant));
        }
      }
    }
  }

  const Octree& Tree;
  const Order& Sequence;
  Visitor& Caller;
};

template <class Order, class Visitor>
void WalkFrontToBack(const Octree& tree, const Order& order, Visitor& visitor)
{
  if (!tree.IsEmpty())
  {
    OctreeWalker<Order, Visitor>(tree, order, visitor)
      .Walk(tree.TopPage(), tree.TopPage().Nodes[0], tree.RootCell());
  }
}

}

#endif
