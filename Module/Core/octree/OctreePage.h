#ifndef VITRINE_CORE_OCTREE_OCTREE_PAGE_H
#define VITRINE_CORE_OCTREE_OCTREE_PAGE_H

#include "Core/geometry/Box.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * A node of an octree. A leaf holds a range of items. An inner node has consecutive children: one for each octant that
 * holds anything, in ascending order, and perhaps a last leaf with the items that are too long for octants. A stored
 * node stands for the root of another page.
 */
struct OctreeNode
{
  enum class Kinds : std::uint32_t
  {
    Leaf,
    Inner,
    Stored
  };

  static constexpr std::uint32_t LargestCount = (1u << 30) - 1;
  /** The slot of the leaf with long items. Slots 0 to 7 belong to the octants. */
  static constexpr int OwnSlot = 8;

  Box Bounds; ///< The tightest box around the parts of its items that lie in its cell.
  /** First item of a leaf, first child of an inner node, or page number of a stored node. */
  std::uint32_t First = 0;
  /**
   * Kind in the two highest bits. The rest is the number of a leaf's items, or a bit for each slot of an inner node
   * with a child.
   */
  std::uint32_t Detail = 0;

  static std::uint32_t LeafDetail(std::size_t count)
  {
    assert(count <= LargestCount);
    return static_cast<std::uint32_t>(count);
  }
  static std::uint32_t InnerDetail(std::uint32_t slots) { return 1u << 30 | slots; }
  static std::uint32_t StoredDetail() { return 2u << 30; }

  Kinds Kind() const { return static_cast<Kinds>(this->Detail >> 30); }
  bool IsLeaf() const { return this->Detail >> 30 == 0; }

  /** Returns the number of items of a leaf. */
  std::uint32_t Count() const
  {
    assert(this->IsLeaf());
    return this->Detail;
  }

  /** Returns the slots of an inner node that have a child, one bit each. */
  std::uint32_t Slots() const
  {
    assert(this->Kind() == Kinds::Inner);
    return this->Detail & LargestCount;
  }
  bool HasChild(int slot) const { return (this->Slots() >> slot & 1) != 0; }
  std::uint32_t ChildCount() const { return CountBelow(OwnSlot + 1); }

  /** Returns the index of the child in a slot, which must have one. */
  std::uint32_t Child(int slot) const
  {
    assert(this->HasChild(slot));
    return this->First + this->CountBelow(slot);
  }

  /** Returns the number of slots before this one that have a child. */
  std::uint32_t CountBelow(int slot) const;
};
static_assert(sizeof(OctreeNode) == 32, "two nodes fill a cache line");

namespace detail
{

struct BitCounts
{
  std::uint8_t Counts[512] = {};

  constexpr BitCounts()
  {
    for (unsigned i = 0; i < 512; ++i)
    {
      Counts[i] = static_cast<std::uint8_t>(Counts[i / 2] + (i & 1u));
    }
  }
};

inline constexpr BitCounts BitCountsTable;

}

inline std::uint32_t OctreeNode::CountBelow(int slot) const
{
  return detail::BitCountsTable.Counts[this->Slots() & ((1u << slot) - 1)];
}

/**
 * Nodes and lists of items in two flat arrays: a whole octree or a subtree. Node 0 is the root; an empty page has no
 * nodes. Freed blocks of nodes and freed lists are reused. The number before each list is its capacity.
 */
class OctreePage
{
public:
  std::vector<OctreeNode> Nodes;
  std::vector<std::uint32_t> Items;

  /**
   * Returns a block of consecutive nodes.
   * @throws  std::length_error if they cannot be numbered in 32 bits
   */
  std::uint32_t NewNodes(std::uint32_t count);
  void FreeNodes(std::uint32_t first, std::uint32_t count);

  /**
   * Returns a list with room for so many items.
   * @throws  std::length_error if they cannot be numbered in 32 bits
   */
  std::uint32_t NewList(std::uint32_t room);
  void FreeList(std::uint32_t first);

  std::uint32_t RoomOf(std::uint32_t list) const { return this->Items[list - 1]; }

  const std::uint32_t* ItemsOf(const OctreeNode& leaf) const
  {
    return this->Items.data() + leaf.First;
  }
  std::uint32_t* ItemsOf(const OctreeNode& leaf) { return this->Items.data() + leaf.First; }

  /** Returns the memory use in bytes. */
  std::size_t Bytes() const;

private:
  // Blocks by node count.
  std::array<std::vector<std::uint32_t>, OctreeNode::OwnSlot + 2> FreeBlocks;
  // Lists by the logarithm of their room, rounded down.
  std::array<std::vector<std::uint32_t>, 32> FreeLists;
};

/** Source of the pages of an octree that are not always in memory. */
class OctreePages
{
public:
  virtual ~OctreePages() = default;

  /**
   * Returns a page. It stays in memory at least as long as somebody holds the pointer. Several threads may call this.
   * @throws  std::runtime_error if the page cannot be read
   */
  virtual std::shared_ptr<const OctreePage> Load(std::uint32_t page) = 0;
};

}

#endif
