#ifndef VITRINE_CORE_CULLING_OCTREE_BUILDER_H
#define VITRINE_CORE_CULLING_OCTREE_BUILDER_H

#include "Core/culling/ItemBoxes.h"
#include "Core/culling/OctreeCell.h"
#include "Core/culling/OctreePage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Divides lists of items into nodes of a page, from the top down. What takes time is to fetch boxes that lie far apart in
 * memory, so those of a list are copied side by side once it is a fraction of all, and again as it gets shorter. Building
 * takes, beside the tree, some 20 bytes per item.
 */
class OctreeBuilder
{
public:
  OctreeBuilder(const ItemBoxes& boxes, std::uint32_t leafSize, OctreePage& page)
    : Boxes(boxes)
    , LeafSize(leafSize)
    , Page(page)
  {
  }

  /**
   * Makes a node, whatever it was, the root of a subtree.
   * @param items  placeable ones that have points in the cell, none twice; room for twice as many saves a copy
   */
  void Build(
    std::uint32_t node, const OctreeCell& cell, int depth, std::vector<std::uint32_t> items);

private:
  // The boxes of a list, side by side.
  struct Copies
  {
    std::vector<Box> Boxes;
    std::vector<std::uint32_t> Items;
  };

  // Entries of the scratch list: items, or while there are copies the numbers of those.
  struct Range
  {
    std::size_t Begin;
    std::size_t End;

    std::size_t Size() const { return this->End - this->Begin; }
  };

  template <class Visit>
  void ForEachBox(const Range& range, Visit&& visit);
  void Divide(std::uint32_t node, const OctreeCell& cell, int depth, const Range& range);
  bool IsWorthCopying(std::size_t size) const;
  Copies Copy(const Range& range);
  using Slots = std::array<Range, OctreeNode::OwnSlot + 1>;
  bool Scatter(const OctreeCell& cell, const Range& range, Slots& slots);
  bool HaveCommonPoint(const Range& range);
  void MakeLeaf(std::uint32_t node, const OctreeCell& cell, const Range& range);

  const ItemBoxes& Boxes;
  std::uint32_t LeafSize;
  OctreePage& Page;
  std::vector<std::uint32_t> Scratch; // a stack of lists
  std::vector<std::uint8_t> Octants;  // of each entry of the list that is being divided
  std::size_t ItemCount = 0;
  const Copies* Near = nullptr;
};

}

#endif
