#ifndef VITRINE_CORE_OCTREE_OCTREE_H
#define VITRINE_CORE_OCTREE_OCTREE_H

#include "Core/octree/ItemBoxes.h"
#include "Core/octree/OctreeCell.h"
#include "Core/octree/OctreePage.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * An octree over the boxes of items, such as the triangles of one or many meshes, or whole parts. (D. Meagher:
 * Geometric modeling using octree encoding, Computer Graphics and Image Processing 19, 1982; for the walk by the eye's
 * octant, H. Samet: Applications of spatial data structures, 1990)
 *
 * A node is split while it holds more than a set number of items. Items are not cut: an item stands in every leaf whose
 * cell shares points with its box, and ItemMarks tells who has seen it. Three rules bound these repetitions. An item
 * longer than a cell's edge stays in the cell's own list, which is a leaf beside the octants. A node whose boxes all
 * share a point is not split, because some octant would hold them all again. A node with up to four times the set
 * number is not split if its octants would list its items more than 2.5 times over.
 *
 * An item whose box is empty or not finite is unplaced and stands in a list of its own. All queries (OctreeQueries.h
 * and similar) consider it. The walk (OctreeWalk.h) does not.
 *
 * A tree keeps no boxes. Call Move() if the box of an item has changed. A tree that is partly on disk (OctreeStore.h)
 * cannot be changed.
 */
class Octree
{
public:
  static constexpr std::uint32_t DefaultLeafSize = 64;
  static constexpr int LargestDepth = 100; ///< Largest depth of a leaf. The root has depth 0.

  /** Creates an empty tree. */
  Octree() = default;

  /**
   * Builds the tree of all items.
   * @param leafSize  largest number of items in a node that is not split. Triangles of a mesh reach into neighbouring
   *                  cells, so half as many per leaf would take twice the memory. For parts, use 16.
   */
  explicit Octree(const ItemBoxes& boxes, std::uint32_t leafSize = DefaultLeafSize);

  /**
   * Creates a tree whose stored nodes stand for pages.
   * @param unplaced  the unplaced items in ascending order
   */
  Octree(OctreePage top, const OctreeCell& root, std::vector<std::uint32_t> unplaced,
    std::uint32_t leafSize, std::shared_ptr<OctreePages> pages);

  /** Returns true if all items are unplaced or there are none. */
  bool IsEmpty() const { return this->Top.Nodes.empty(); }

  /** Returns the tightest box around all placed items. It is empty if there are none. */
  Box Bounds() const { return this->IsEmpty() ? Box() : this->Top.Nodes[0].Bounds; }

  /** Returns the items whose boxes are empty or not finite, in ascending order. */
  const std::vector<std::uint32_t>& UnplacedItems() const { return this->Unplaced; }

  /** Returns the nodes and lists of items in memory. */
  const OctreePage& TopPage() const { return this->Top; }

  /**
   * Returns the page that a stored node stands for.
   * @throws  std::runtime_error if the page cannot be read
   */
  std::shared_ptr<const OctreePage> LoadPage(const OctreeNode& node) const;

  const OctreeCell& RootCell() const { return this->Root; }
  std::uint32_t LeafSize() const { return this->LargestLeaf; }

  /** Returns the memory use in bytes, without pages on disk. */
  std::size_t Bytes() const;

  /**
   * Adds an item that the tree does not hold. Insert(), Remove() and Move() touch only nodes that the item's box lies
   * in.
   * @param boxes  the boxes of all items as they were inserted or last moved, and the box of the new item
   */
  void Insert(std::uint32_t item, const ItemBoxes& boxes);

  /**
   * Removes an item.
   * @param before  its box when it was inserted or last moved
   * @param boxes   the boxes of the remaining items
   */
  void Remove(std::uint32_t item, const Box& before, const ItemBoxes& boxes);

  /** An item whose box has changed, and its box when it was inserted or last moved. */
  struct MovedItem
  {
    std::uint32_t Item;
    Box Before;
  };

  /**
   * Updates the places of items whose boxes have changed.
   * @param moved  all items whose boxes have changed, each once
   * @param boxes  the current boxes
   */
  void Move(const MovedItem* moved, std::size_t count, const ItemBoxes& boxes);

  /**
   * Returns the number of items inserted outside of the space that the tree was built for. They are found, but slowly.
   * Rebuild the tree if there are many.
   */
  std::uint32_t StrayCount() const { return this->Strays; }

private:
  struct Change;
  std::vector<BoxedItem> ReadPlaceable(const ItemBoxes& boxes);
  void Remove(const MovedItem* removed, std::size_t count, const ItemBoxes& boxes);
  void InsertInto(const Change& change, std::uint32_t node, const OctreeCell& cell, int depth);
  void AppendToLeaf(const Change& change, std::uint32_t leaf, const OctreeCell& cell, int depth);
  void AddChild(std::uint32_t node, int slot);
  void EraseFrom(const Change& change, std::uint32_t node, const OctreeCell& cell);
  void Refit(const Change& change, std::uint32_t node, const OctreeCell& cell);
  void RefitLeaf(const Change& change, OctreeNode& leaf, const OctreeCell& cell);
  void DropChild(std::uint32_t node, int slot);
  void MergeChildren(std::uint32_t node);

  OctreePage Top;
  OctreeCell Root;
  Box Built; // The box around everything that the root's cell was made for.
  std::vector<std::uint32_t> Unplaced;
  std::uint32_t LargestLeaf = DefaultLeafSize;
  std::uint32_t Strays = 0;
  std::shared_ptr<OctreePages> Pages;
};

}

#endif
