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
 * An octree over the boxes of items: of the triangles of a mesh, of many meshes, or of whole parts. (D. Meagher: Geometric
 * modeling using octree encoding, Computer Graphics and Image Processing 19, 1982; for the walk by the eye's octant,
 * H. Samet: Applications of spatial data structures, 1990)
 *
 * A node is split while it holds more than a set number of items. Items are not cut: one stands in every leaf whose cell
 * its box has points in, and ItemMarks tell who has seen it already. Three rules bound how often that is. An item longer
 * than a cell's edge is not handed to the cell's octants but stays in a list of its own, which is a leaf beside them. A
 * node whose boxes all have a point in common is not split, since some octant would hold them all again. And neither is one
 * with up to four times the set number where its octants would list its items more than 2.5 times over.
 *
 * An item whose box is empty or not finite has no place; it stands in a list of its own. Every question to a tree
 * (OctreeQueries.h and its like) considers it, the walk (OctreeWalk.h) does not.
 *
 * A tree keeps no boxes of items. Whoever changes some afterwards says so by Move(). A tree that is partly on disk
 * (OctreeStore.h) cannot be changed.
 */
class Octree
{
public:
  static constexpr std::uint32_t DefaultLeafSize = 64;
  static constexpr int LargestDepth = 100; ///< of a leaf; the root has depth 0

  /** A tree of nothing. */
  Octree() = default;

  /**
   * Builds the tree of all items.
   * @param leafSize  how many items a node holds at most without being split. Triangles of a mesh reach into their
   *                  neighbours' cells: half as many to a leaf would take twice the memory. For parts, 16 is few enough.
   */
  explicit Octree(const ItemBoxes& boxes, std::uint32_t leafSize = DefaultLeafSize);

  /** A tree whose stored nodes stand for pages. @param unplaced  the items that have no place, in ascending order */
  Octree(OctreePage top, const OctreeCell& root, std::vector<std::uint32_t> unplaced,
    std::uint32_t leafSize, std::shared_ptr<OctreePages> pages);

  /** Whether no item has a place. */
  bool IsEmpty() const { return this->Top.Nodes.empty(); }

  /** The tightest box around all items that have a place; empty if there is none. */
  Box Bounds() const { return this->IsEmpty() ? Box() : this->Top.Nodes[0].Bounds; }

  /** Items whose boxes are empty or not finite, in ascending order. */
  const std::vector<std::uint32_t>& UnplacedItems() const { return this->Unplaced; }

  /** The nodes and lists of items in memory. */
  const OctreePage& TopPage() const { return this->Top; }

  /** The page that a stored node stands for. @throws std::runtime_error if it cannot be read */
  std::shared_ptr<const OctreePage> LoadPage(const OctreeNode& node) const;

  const OctreeCell& RootCell() const { return this->Root; }
  std::uint32_t LeafSize() const { return this->LargestLeaf; }

  /** Memory that the tree takes, pages on disk aside. */
  std::size_t Bytes() const;

  /**
   * Adds an item that the tree does not hold. Like the next two, this touches only nodes that the item's box lies in.
   * @param boxes  tells the boxes of all items of the tree, as they were when put in or moved, and of this one
   */
  void Insert(std::uint32_t item, const ItemBoxes& boxes);

  /**
   * Removes an item.
   * @param before  its box when it was put in or last moved
   * @param boxes   tells the boxes of the items that remain
   */
  void Remove(std::uint32_t item, const Box& before, const ItemBoxes& boxes);

  /** An item whose box has changed, and what the box was when the item was put in or last moved. */
  struct MovedItem
  {
    std::uint32_t Item;
    Box Before;
  };

  /**
   * Puts items where their boxes are now.
   * @param moved  all items whose boxes have changed, each once
   * @param boxes  tells the boxes as they are now
   */
  void Move(const MovedItem* moved, std::size_t count, const ItemBoxes& boxes);

  /**
   * How many items were put outside of the space that the tree was built around. They are found, but not fast: where they
   * are many, the tree is better built anew.
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
  Box Built; // around all that the root's cell was made for
  std::vector<std::uint32_t> Unplaced;
  std::uint32_t LargestLeaf = DefaultLeafSize;
  std::uint32_t Strays = 0;
  std::shared_ptr<OctreePages> Pages;
};

}

#endif
