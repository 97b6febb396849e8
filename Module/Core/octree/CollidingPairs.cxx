#include "Core/octree/CollidingPairs.h"

#include "Core/octree/OctreeQueries.h"

#include <algorithm>
#include <memory>

namespace vitrine
{

namespace
{

// A node on the way down, with its cell. It keeps the page of the node in memory.
struct Place
{
  const OctreePage* Page;
  const OctreeNode* Node;
  OctreeCell Cell;
  std::shared_ptr<const OctreePage> Hold;
};

Place RootOf(const Octree& tree)
{
  return { &tree.TopPage(), &tree.TopPage().Nodes[0], tree.RootCell(), nullptr };
}

// Returns the node itself if it is in memory, else the root of the page that it stands for.
Place Loaded(const Octree& tree, const Place& place)
{
  if (place.Node->Kind() != OctreeNode::Kinds::Stored)
  {
    return place;
  }
  std::shared_ptr<const OctreePage> page = tree.LoadPage(*place.Node);
  const OctreePage* const content = page.get();
  return { content, &content->Nodes[0], place.Cell, std::move(page) };
}

template <class Visit>
void ForEachChild(const Place& place, Visit&& visit)
{
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    if (place.Node->HasChild(slot))
    {
      const OctreeNode* child = &place.Page->Nodes[place.Node->Child(slot)];
      const bool isOwn = slot == OctreeNode::OwnSlot;
      visit(Place{ place.Page, child, isOwn ? place.Cell : place.Cell.Octant(slot), place.Hold });
    }
  }
}

// Descends two trees at once, wherever the boxes of their nodes touch.
//
// An item stands in several leaves, so two items may meet in several pairs of leaves. The pair counts in one of them:
// both leaves' cells must contain the lowest corner of the intersection of the items' boxes. Each point is in one
// octant of a cell. An item whose box contains the point is in that octant, or in the list of items that the cell
// keeps.
class PairSearch
{
public:
  PairSearch(const Octree& first, const ItemBoxes& firstBoxes, const Octree& second,
    const ItemBoxes& secondBoxes, std::function<bool(std::uint32_t, std::uint32_t)> visit)
    : First(first)
    , FirstBoxes(firstBoxes)
    , Second(second)
    , SecondBoxes(secondBoxes)
    , IsDoneAfter(std::move(visit))
  {
  }

  void Search()
  {
    this->SearchUnplaced();
    if (!this->First.IsEmpty() && !this->Second.IsEmpty())
    {
      this->Descend(RootOf(this->First), RootOf(this->Second));
    }
  }

private:
  // Tests unplaced items of each tree against the other tree. Pairs of two unplaced items count once.
  void SearchUnplaced()
  {
    for (const std::uint32_t item : this->First.UnplacedItems())
    {
      for (const std::uint32_t other :
        ItemsTouching(this->Second, this->SecondBoxes, this->FirstBoxes.At(item)))
      {
        this->Offer(item, other);
      }
    }
    for (const std::uint32_t item : this->Second.UnplacedItems())
    {
      for (const std::uint32_t other :
        ItemsTouching(this->First, this->FirstBoxes, this->SecondBoxes.At(item)))
      {
        if (this->FirstBoxes.At(other).IsPlaceable())
        {
          this->Offer(other, item);
        }
      }
    }
  }

  void Offer(std::uint32_t first, std::uint32_t second)
  {
    this->IsDone = this->IsDone || this->IsDoneAfter(first, second);
  }

  void Descend(const Place& a, const Place& b)
  {
    if (this->IsDone || !Touches(a.Node->Bounds, b.Node->Bounds))
    {
      return;
    }
    const Place first = Loaded(this->First, a);
    const Place second = Loaded(this->Second, b);
    if (first.Node->IsLeaf() && second.Node->IsLeaf())
    {
      this->PairLeaves(first, second);
    }
    else if (second.Node->IsLeaf() ||
      (!first.Node->IsLeaf() && first.Cell.Half >= second.Cell.Half))
    {
      ForEachChild(first, [&](const Place& child) { this->Descend(child, second); });
    }
    else
    {
      ForEachChild(second, [&](const Place& child) { this->Descend(first, child); });
    }
  }

  void PairLeaves(const Place& first, const Place& second)
  {
    this->FirstOfLeaf.Read(first, this->FirstBoxes, second.Node->Bounds);
    this->SecondOfLeaf.Read(second, this->SecondBoxes, first.Node->Bounds);
    for (std::size_t i = 0; i < this->FirstOfLeaf.Items.size() && !this->IsDone; ++i)
    {
      const Box& box = this->FirstOfLeaf.Boxes[i];
      for (std::size_t j = 0; j < this->SecondOfLeaf.Items.size(); ++j)
      {
        const Box& other = this->SecondOfLeaf.Boxes[j];
        if (!Touches(box, other))
        {
          continue;
        }
        const glm::vec3 corner = box.ClippedTo(other).Min;
        if (first.Cell.Has(corner) && second.Cell.Has(corner))
        {
          this->Offer(this->FirstOfLeaf.Items[i], this->SecondOfLeaf.Items[j]);
        }
      }
    }
  }

  // Items of a leaf and their boxes.
  struct Candidates
  {
    std::vector<std::uint32_t> Items;
    std::vector<Box> Boxes;

    // Reads the items whose boxes touch `near`.
    void Read(const Place& leaf, const ItemBoxes& boxes, const Box& near)
    {
      const std::uint32_t* items = leaf.Page->ItemsOf(*leaf.Node);
      this->Items.assign(items, items + leaf.Node->Count());
      this->Boxes.resize(this->Items.size());
      boxes.Read(this->Items.data(), this->Items.size(), this->Boxes.data());
      std::size_t kept = 0;
      for (std::size_t i = 0; i < this->Items.size(); ++i)
      {
        if (Touches(this->Boxes[i], near))
        {
          this->Items[kept] = this->Items[i];
          this->Boxes[kept++] = this->Boxes[i];
        }
      }
      this->Items.resize(kept);
      this->Boxes.resize(kept);
    }
  };

  const Octree& First;
  const ItemBoxes& FirstBoxes;
  const Octree& Second;
  const ItemBoxes& SecondBoxes;
  std::function<bool(std::uint32_t, std::uint32_t)> IsDoneAfter;
  bool IsDone = false;
  Candidates FirstOfLeaf;
  Candidates SecondOfLeaf;
};

}

std::vector<ItemPair> CollidingPairs(const Octree& first, const ItemBoxes& firstBoxes,
  const Octree& second, const ItemBoxes& secondBoxes, const PairTest& test)
{
  std::vector<ItemPair> pairs;
  const auto keep = [&](std::uint32_t a, std::uint32_t b)
  {
    if (test(a, b))
    {
      pairs.emplace_back(a, b);
    }
    return false;
  };
  PairSearch(first, firstBoxes, second, secondBoxes, keep).Search();
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<ItemPair> CollidingPairs(
  const Octree& tree, const ItemBoxes& boxes, const PairTest& test)
{
  // Each pair comes in both orders, and each item with itself.
  return CollidingPairs(tree, boxes, tree, boxes,
    [&](std::uint32_t a, std::uint32_t b) { return a < b && test(a, b); });
}

bool Collide(const Octree& first, const ItemBoxes& firstBoxes, const Octree& second,
  const ItemBoxes& secondBoxes, const PairTest& test)
{
  bool isFound = false;
  const auto stop = [&](std::uint32_t a, std::uint32_t b)
  {
    isFound = test(a, b);
    return isFound;
  };
  PairSearch(first, firstBoxes, second, secondBoxes, stop).Search();
  return isFound;
}

}
