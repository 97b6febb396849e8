#ifndef VITRINE_CORE_OCTREE_OCTREE_BUILDER_H
#define VITRINE_CORE_OCTREE_OCTREE_BUILDER_H

#include "Core/octree/ItemBoxes.h"
#include "Core/octree/OctreeCell.h"
#include "Core/octree/OctreePage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Divides lists of items into nodes of a page, from the top down. Most time goes into fetching boxes that lie far apart
 * in memory. So the boxes of a list are copied side by side once the list is a small fraction of those it lies among.
 * Beside the tree, building takes about 40 bytes per item.
 */
class OctreeBuilder
{
public:
  OctreeBuilder(std::uint32_t leafSize, OctreePage& page)
    : LeafSize(leafSize)
    , Page(page)
  {
  }

  /**
   * Makes a node the root of a subtree, whatever it was before.
   * @param items  distinct placeable items that share points with the cell; spare capacity of an eighth saves a copy
   */
  void Build(std::uint32_t node, const OctreeCell& cell, int depth, std::vector<BoxedItem> items);

private:
  // A list in a stack of lists.
  struct Range
  {
    std::size_t Begin;
    std::size_t End;

    std::size_t Size() const { return this->End - this->Begin; }
  };

  using Counts = std::array<std::size_t, OctreeNode::OwnSlot + 1>;
  using Slots = std::array<Range, OctreeNode::OwnSlot + 1>;

  template <class Visit>
  void ForEachItem(Range range, Visit visit) const;
  void Divide(std::uint32_t node, const OctreeCell& cell, int depth, Range range);
  bool IsWorthCopying(std::size_t size) const;
  Range Copy(const Range& range);
  bool Scatter(const OctreeCell& cell, const Range& range, Slots& slots);
  void FindOctants(const OctreeCell& cell, const Range& range);
  static Counts CountBySlot(const std::uint8_t* octants, std::size_t count);
  bool IsInVain(const OctreeCell& cell, const Range& range, const Counts& counts) const;
  bool HaveCommonPoint(const Range& range) const;
  Slots AppendSlots(const Counts& counts);
  void FillSlots(const Range& range, const Slots& slots);
  void MakeLeaf(std::uint32_t node, const OctreeCell& cell, const Range& range);

  std::uint32_t LeafSize;
  OctreePage& Page;
  std::vector<BoxedItem> Copies;      // A stack of lists.
  Range Near{};                       // The last list of Copies.
  std::vector<std::uint32_t> Entries; // A stack of lists of indices into Near.
  std::vector<std::uint8_t> Octants; // The octants of each entry of the list that is being divided.
};

}

#endif
