// Changes of an Octree after it was built.

#include "Core/octree/Octree.h"
#include "Core/octree/OctreeBuilder.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

namespace
{

// Returns true if shrinking `part`, which lies in `whole`, may shrink `whole`.
bool ReachesSideOf(const Box& part, const Box& whole)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (part.Min[axis] <= whole.Min[axis] || part.Max[axis] >= whole.Max[axis])
    {
      return true;
    }
  }
  return false;
}

std::vector<BoxedItem> WithBoxes(const std::vector<std::uint32_t>& items, const ItemBoxes& boxes)
{
  std::vector<BoxedItem> boxed;
  boxed.reserve(items.size());
  for (const std::uint32_t item : items)
  {
    boxed.push_back({ boxes.At(item), item });
  }
  return boxed;
}

}

// An item on its way into the tree or out of it.
struct Octree::Change
{
  std::uint32_t Item;
  Box Place; // The box where the item is put or was found.
  const ItemBoxes& Boxes;
};

void Octree::Insert(std::uint32_t item, const ItemBoxes& boxes)
{
  assert(!this->Pages);
  const Change change{ item, boxes.At(item), boxes };
  if (!change.Place.IsPlaceable())
  {
    const auto at = std::lower_bound(this->Unplaced.begin(), this->Unplaced.end(), item);
    assert(at == this->Unplaced.end() || *at != item);
    this->Unplaced.insert(at, item);
    return;
  }
  if (this->IsEmpty())
  {
    this->Built = change.Place;
    this->Root = OctreeCell::Around(this->Built);
    this->Top = {};
    this->Top.NewNodes(1);
    this->Top.Nodes[0].First = this->Top.NewList(1);
  }
  this->Strays += !Contains(this->Built, change.Place);
  this->InsertInto(change, 0, this->Root, 0);
}

void Octree::Remove(std::uint32_t item, const Box& before, const ItemBoxes& boxes)
{
  const MovedItem removed{ item, before };
  this->Remove(&removed, 1, boxes);
}

void Octree::Remove(const MovedItem* removed, std::size_t count, const ItemBoxes& boxes)
{
  assert(!this->Pages);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Change change{ removed[i].Item, removed[i].Before, boxes };
    if (!change.Place.IsPlaceable())
    {
      const auto at = std::lower_bound(this->Unplaced.begin(), this->Unplaced.end(), change.Item);
      assert(at != this->Unplaced.end() && *at == change.Item);
      this->Unplaced.erase(at);
      continue;
    }
    assert(!this->IsEmpty());
    this->Strays -= !Contains(this->Built, change.Place);
    this->EraseFrom(change, 0, this->Root);
  }
  // Boxes of items may be read only now that no leaf holds a removed item.
  for (std::size_t i = 0; i < count; ++i)
  {
    if (removed[i].Before.IsPlaceable())
    {
      this->Refit({ removed[i].Item, removed[i].Before, boxes }, 0, this->Root);
    }
  }
  if (!this->IsEmpty() && this->Top.Nodes[0].IsLeaf() && this->Top.Nodes[0].Count() == 0)
  {
    this->Top = {};
  }
}

void Octree::Move(const MovedItem* moved, std::size_t count, const ItemBoxes& boxes)
{
  this->Remove(moved, count, boxes);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Insert(moved[i].Item, boxes);
  }
}

void Octree::InsertInto(const Change& change, std::uint32_t node, const OctreeCell& cell, int depth)
{
  this->Top.Nodes[node].Bounds.Add(change.Place.ClippedTo(cell.Extent));
  if (this->Top.Nodes[node].IsLeaf())
  {
    this->AppendToLeaf(change, node, cell, depth);
    return;
  }
  const std::uint32_t octants = cell.OctantsFor(change.Place);
  const bool isKept = octants == 0;
  const std::uint32_t slots = isKept ? 1u << OctreeNode::OwnSlot : octants;
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    if ((slots >> slot & 1) == 0)
    {
      continue;
    }
    if (!this->Top.Nodes[node].HasChild(slot))
    {
      this->AddChild(node, slot);
    }
    const std::uint32_t child = this->Top.Nodes[node].Child(slot);
    // The list of long items has the largest depth of a leaf, so it is never split.
    this->InsertInto(
      change, child, isKept ? cell : cell.Octant(slot), isKept ? LargestDepth : depth + 1);
  }
}

void Octree::AppendToLeaf(
  const Change& change, std::uint32_t leaf, const OctreeCell& cell, int depth)
{
  const std::uint32_t list = this->Top.Nodes[leaf].First;
  const std::uint32_t count = this->Top.Nodes[leaf].Count();
  if (count < this->Top.RoomOf(list))
  {
    this->Top.Items[list + count] = change.Item;
    this->Top.Nodes[leaf].Detail = OctreeNode::LeafDetail(count + 1);
    return;
  }
  // A split is tried each time the list has to grow, so trying costs no more than growing.
  std::vector<std::uint32_t> items(
    this->Top.Items.begin() + list, this->Top.Items.begin() + list + count);
  items.push_back(change.Item);
  this->Top.FreeList(list);
  const bool isFull = items.size() > this->LargestLeaf && depth < LargestDepth;
  if (isFull)
  {
    OctreeBuilder(this->LargestLeaf, this->Top)
      .Build(leaf, cell, depth, WithBoxes(items, change.Boxes));
    if (!this->Top.Nodes[leaf].IsLeaf())
    {
      return;
    }
    this->Top.FreeList(this->Top.Nodes[leaf].First);
  }
  const std::uint32_t grown = this->Top.NewList(2 * count + 1);
  std::copy(items.begin(), items.end(), this->Top.Items.begin() + grown);
  this->Top.Nodes[leaf].First = grown;
  this->Top.Nodes[leaf].Detail = OctreeNode::LeafDetail(items.size());
}

// Gives an inner node an empty leaf for a slot that has no child.
void Octree::AddChild(std::uint32_t node, int slot)
{
  const OctreeNode parent = this->Top.Nodes[node];
  const std::uint32_t count = parent.ChildCount();
  const std::uint32_t below = parent.CountBelow(slot);
  const std::uint32_t first = this->Top.NewNodes(count + 1);
  const auto children = this->Top.Nodes.begin();
  std::copy_n(children + parent.First, below, children + first);
  std::copy_n(children + parent.First + below, count - below, children + first + below + 1);
  this->Top.FreeNodes(parent.First, count);
  const std::uint32_t list = this->Top.NewList(1);
  this->Top.Nodes[first + below] = { Box(), list, OctreeNode::LeafDetail(0) };
  this->Top.Nodes[node].First = first;
  this->Top.Nodes[node].Detail = OctreeNode::InnerDetail(parent.Slots() | 1u << slot);
}

// Removes the item from its leaves and changes nothing else.
void Octree::EraseFrom(const Change& change, std::uint32_t node, const OctreeCell& cell)
{
  OctreeNode& parent = this->Top.Nodes[node];
  if (parent.IsLeaf())
  {
    std::uint32_t* items = this->Top.ItemsOf(parent);
    std::uint32_t* const found = std::find(items, items + parent.Count(), change.Item);
    assert(found != items + parent.Count());
    *found = items[parent.Count() - 1];
    parent.Detail = OctreeNode::LeafDetail(parent.Count() - 1);
    return;
  }
  const std::uint32_t octants = cell.OctantsFor(change.Place);
  if (octants == 0)
  {
    this->EraseFrom(change, parent.Child(OctreeNode::OwnSlot), cell);
  }
  for (int octant = 0; octant < OctreeNode::OwnSlot; ++octant)
  {
    if ((octants >> octant & 1) != 0)
    {
      this->EraseFrom(change, parent.Child(octant), cell.Octant(octant));
    }
  }
}

// Drops empty leaves, tightens boxes and merges nodes wherever the item was.
void Octree::Refit(const Change& change, std::uint32_t node, const OctreeCell& cell)
{
  if (this->Top.Nodes[node].IsLeaf())
  {
    this->RefitLeaf(change, this->Top.Nodes[node], cell);
    return;
  }
  const std::uint32_t octants = cell.OctantsFor(change.Place);
  const bool isKept = octants == 0;
  const std::uint32_t slots = isKept ? 1u << OctreeNode::OwnSlot : octants;
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    // The refit after another item may have dropped this child, or all children.
    const OctreeNode& parent = this->Top.Nodes[node];
    if (parent.IsLeaf() || (slots >> slot & 1) == 0 || !parent.HasChild(slot))
    {
      continue;
    }
    const std::uint32_t child = parent.Child(slot);
    this->Refit(change, child, isKept ? cell : cell.Octant(slot));
    if (this->Top.Nodes[child].IsLeaf() && this->Top.Nodes[child].Count() == 0)
    {
      this->DropChild(node, slot);
    }
  }
  OctreeNode& parent = this->Top.Nodes[node];
  if (parent.IsLeaf())
  {
    return;
  }
  if (ReachesSideOf(change.Place.ClippedTo(cell.Extent), parent.Bounds))
  {
    Box bounds;
    for (std::uint32_t i = 0; i < parent.ChildCount(); ++i)
    {
      bounds.Add(this->Top.Nodes[parent.First + i].Bounds);
    }
    parent.Bounds = bounds;
  }
  this->MergeChildren(node);
}

void Octree::RefitLeaf(const Change& change, OctreeNode& leaf, const OctreeCell& cell)
{
  if (!ReachesSideOf(change.Place.ClippedTo(cell.Extent), leaf.Bounds))
  {
    return;
  }
  Box bounds;
  for (std::uint32_t i = 0; i < leaf.Count(); ++i)
  {
    bounds.Add(change.Boxes.At(this->Top.ItemsOf(leaf)[i]).ClippedTo(cell.Extent));
  }
  leaf.Bounds = bounds;
}

// Removes the empty leaf of a slot from an inner node. The node becomes an empty leaf if it has no other child.
void Octree::DropChild(std::uint32_t node, int slot)
{
  const OctreeNode parent = this->Top.Nodes[node];
  const std::uint32_t count = parent.ChildCount();
  const std::uint32_t below = parent.CountBelow(slot);
  const std::uint32_t list = this->Top.Nodes[parent.First + below].First;
  if (count == 1)
  {
    this->Top.FreeNodes(parent.First, count);
    this->Top.Nodes[node] = { Box(), list, OctreeNode::LeafDetail(0) };
    return;
  }
  this->Top.FreeList(list);
  const std::uint32_t first = this->Top.NewNodes(count - 1);
  const auto children = this->Top.Nodes.begin();
  std::copy_n(children + parent.First, below, children + first);
  std::copy_n(children + parent.First + below + 1, count - below - 1, children + first + below);
  this->Top.FreeNodes(parent.First, count);
  this->Top.Nodes[node].First = first;
  this->Top.Nodes[node].Detail = OctreeNode::InnerDetail(parent.Slots() & ~(1u << slot));
}

// Turns a node into a leaf if its children are leaves with so few items that a new split is not near.
void Octree::MergeChildren(std::uint32_t node)
{
  const OctreeNode parent = this->Top.Nodes[node];
  if (parent.IsLeaf())
  {
    return;
  }
  std::vector<std::uint32_t> items;
  for (std::uint32_t i = 0; i < parent.ChildCount(); ++i)
  {
    const OctreeNode& child = this->Top.Nodes[parent.First + i];
    if (!child.IsLeaf() || items.size() + child.Count() > this->LargestLeaf / 2)
    {
      return;
    }
    const std::uint32_t* first = this->Top.ItemsOf(child);
    items.insert(items.end(), first, first + child.Count());
  }
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  for (std::uint32_t i = 0; i < parent.ChildCount(); ++i)
  {
    this->Top.FreeList(this->Top.Nodes[parent.First + i].First);
  }
  this->Top.FreeNodes(parent.First, parent.ChildCount());
  const std::uint32_t list =
    this->Top.NewList(std::max<std::uint32_t>(1, static_cast<std::uint32_t>(items.size())));
  std::copy(items.begin(), items.end(), this->Top.Items.begin() + list);
  this->Top.Nodes[node].First = list;
  this->Top.Nodes[node].Detail = OctreeNode::LeafDetail(items.size());
}

}
