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
 * A node of an octree. It is a leaf, which holds a range of items; or inner, with children that stand side by side: one for
 * each octant that holds anything, in ascending order, and behind them perhaps a leaf with the items that are too long to be
 * handed to octants; or stored, which stands for the root of another page.
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
  static constexpr int OwnSlot = 8; ///< slots 0 to 7 are the octants'

  Box Bounds; ///< the tightest around the parts of its items that lie in its cell
  std::uint32_t First =
    0; ///< leaf: of its items; inner: of its children; stored: number of the page
  std::uint32_t Detail =
    0; ///< two bits of kind; leaf: how many items; inner: a bit for each slot that has a child

  static std::uint32_t LeafDetail(std::size_t count)
  {
    assert(count <= LargestCount);
    return static_cast<std::uint32_t>(count);
  }
  static std::uint32_t InnerDetail(std::uint32_t slots) { return 1u << 30 | slots; }
  static std::uint32_t StoredDetail() { return 2u << 30; }

  Kinds Kind() const { return static_cast<Kinds>(this->Detail >> 30); }
  bool IsLeaf() const { return this->Detail >> 30 == 0; }

  /** Items of a leaf. */
  std::uint32_t Count() const
  {
    assert(this->IsLeaf());
    return this->Detail;
  }

  /** The slots of an inner node that have a child, a bit each. */
  std::uint32_t Slots() const
  {
    assert(this->Kind() == Kinds::Inner);
    return this->Detail & LargestCount;
  }
  bool HasChild(int slot) const { return (this->Slots() >> slot & 1) != 0; }
  std::uint32_t ChildCount() const { return CountBelow(OwnSlot + 1); }

  /** The number of the child in a slot that has one. */
  std::uint32_t Child(int slot) const
  {
    assert(this->HasChild(slot));
    return this->First + this->CountBelow(slot);
  }

  /** How many of the slots before this one have a child. */
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
 * Nodes and lists of items in two flat arrays: a whole octree, or a subtree of one. Node 0 is the root; there is none where
 * nothing is held. Blocks of nodes and lists of items that were given back are handed out again. Before each list stands
 * one number, how many items it has room for.
 */
class OctreePage
{
public:
  std::vector<OctreeNode> Nodes;
  std::vector<std::uint32_t> Items;

  /** A block of nodes side by side. @throws std::length_error if they cannot be numbered in 32 bits */
  std::uint32_t NewNodes(std::uint32_t count);
  void FreeNodes(std::uint32_t first, std::uint32_t count);

  /** A list with room for so many items. @throws std::length_error if they cannot be numbered in 32 bits */
  std::uint32_t NewList(std::uint32_t room);
  void FreeList(std::uint32_t first);

  std::uint32_t RoomOf(std::uint32_t list) const { return this->Items[list - 1]; }

  const std::uint32_t* ItemsOf(const OctreeNode& leaf) const
  {
    return this->Items.data() + leaf.First;
  }
  std::uint32_t* ItemsOf(const OctreeNode& leaf) { return this->Items.data() + leaf.First; }

  /** Memory that it takes. */
  std::size_t Bytes() const;

private:
  std::array<std::vector<std::uint32_t>, OctreeNode::OwnSlot + 2> FreeBlocks; // by count
  std::array<std::vector<std::uint32_t>, 32>
    FreeLists; // by the logarithm of the room, rounded down
};

/** Where the pages of an octree are that are not in memory all the time. */
class OctreePages
{
public:
  virtual ~OctreePages() = default;

  /**
   * The page, which stays in memory at least as long as somebody holds the pointer. Safe to be called by several threads.
   * @throws std::runtime_error if it cannot be read
   */
  virtual std::shared_ptr<const OctreePage> Load(std::uint32_t page) = 0;
};

}

#endif
