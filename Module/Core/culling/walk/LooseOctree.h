#ifndef VITRINE_CORE_CULLING_WALK_LOOSE_OCTREE_H
#define VITRINE_CORE_CULLING_WALK_LOOSE_OCTREE_H

#include "Core/geometry/BoxLanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A node of a loose octree: up to eight entries, items or nodes, with their boxes side by side. */
struct alignas(64) LooseNode
{
  static constexpr std::uint32_t None = 0xffffffffu;
  static constexpr std::uint32_t ItemBit = 1u << 31;
  static constexpr std::uint32_t LongBit = 1u
    << 30; ///< of what is longer than the cell: it may hide all the rest
  static constexpr std::uint32_t NumberBits = LongBit - 1;

  BoxLanes Boxes;
  std::uint32_t Entries[LaneCount] = { None, None, None, None, None, None, None, None };
  std::uint32_t Counts[LaneCount] = {}; ///< of items in each entry

  bool Has(int lane) const { return this->Entries[lane] != None; }
  bool IsItem(int lane) const { return (this->Entries[lane] & ItemBit) != 0; }

  /** The lanes that have an entry, and those of which it is long. */
  VITRINE_INLINE LaneMask AreThere() const
  {
    return LoadMask(this->Entries) != static_cast<std::int32_t>(None);
  }
  VITRINE_INLINE LaneMask AreLong() const
  {
    return (LoadMask(this->Entries) & static_cast<std::int32_t>(LongBit)) != 0;
  }

  std::uint32_t ItemAt(int lane) const { return this->Entries[lane] & NumberBits; }
  std::uint32_t NodeAt(int lane) const { return this->Entries[lane] & NumberBits; }

  bool IsFullOfItems() const
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (!this->Has(lane) || !this->IsItem(lane))
      {
        return false;
      }
    }
    return true;
  }

  std::uint32_t Count() const
  {
    std::uint32_t sum = 0;
    for (const std::uint32_t count : this->Counts)
    {
      sum += count;
    }
    return sum;
  }
};

static_assert(sizeof(LooseNode) == 256, "a node fills four cache lines");

/**
 * An octree in which each item stands once, in the cell that the centre of its box lies in; a node's box holds all of its items and may
 * reach beyond its cell (T. Ulrich: Loose octrees, Game Programming Gems 1, 2000). What is longer than a cell stands apart from what is in it. Parts of an assembly are as large as the distances
 * between them: in an octree that keeps to its cells (Octree.h), each would stand in some twenty leaves.
 *
 * Items and nodes stand in one table of eight lanes, so that their boxes are tested eight at a time. A cell of no more than 64 items is not cut into octants, most of which would have two or
 * three, but into as few lanes of eight neighbours as it takes.
 */
class LooseOctree
{
public:
  /** A tree of nothing. */
  LooseOctree() = default;

  /** Of items 0, 1, ... Those whose boxes are empty or not finite have no place in the tree. */
  explicit LooseOctree(const std::vector<Box>& boxes);

  bool IsEmpty() const { return this->Nodes.empty() || this->Nodes[0].Count() == 0; }

  /** The root, if there is one, is node 0. */
  const LooseNode& Node(std::uint32_t node) const { return this->Nodes[node]; }

  /** The node will be read soon. */
  void PrefetchNode(std::uint32_t node) const { PrefetchAll(this->Nodes[node]); }

  /** Whether the item stands in the tree. */
  bool Holds(std::uint32_t item) const { return item < this->IsHeld.size() && this->IsHeld[item]; }

  /** One more than the largest number of an item that was ever put. */
  std::size_t ItemCount() const { return this->IsHeld.size(); }

  /** Those of them that do not stand in the tree, in order. */
  const std::vector<std::uint32_t>& Unplaced() const { return this->WithoutPlace; }

  /**
   * Puts an item where its box is, whether it was in the tree before or not; one without a place leaves the tree. Touches the nodes that
   * the item is and was in.
   */
  void SetBox(std::uint32_t item, const Box& box);

  /** How many items were put since the tree was built: where they are many, it is better built anew. */
  std::size_t ChangeCount() const { return this->Changes; }

  /** Memory that it takes. */
  std::size_t Bytes() const;

private:
  struct Place
  {
    std::uint32_t Node = LooseNode::None;
    int Lane = 0;
  };

  struct Entry
  {
    std::uint32_t Item = 0;
    Box Bounds;
  };

  using Ends = std::array<std::size_t, LaneCount + 1>;

  /** How a node divides what is in it. */
  enum class Ways
  {
    NotAtAll, ///< entries stand in any lane
    ByOctant,
    ByNearness, ///< few items, in as few lanes as have room for them, each in one with its neighbours
    BySize ///< items that are longer than the cell stand in the first lane, the others in the second
  };

  /** The cube that a node's centres lay in when it was filled. */
  struct Cell
  {
    glm::vec3 Centre{ 0.0f };
    float Half = 0.0f;
    Ways Way = Ways::NotAtAll;
    std::uint32_t Parent = LooseNode::None;
    int Lane = 0; ///< of the parent's

    void FitTo(const Entry* entries, std::size_t count);
    bool HasLanesForPlaces() const
    {
      return this->Way == Ways::ByOctant || this->Way == Ways::BySize;
    }
    int LaneOf(const Box& box) const;
    Ends Sort(Entry* entries, std::size_t count) const;
    bool Holds(const glm::vec3& point) const;

  private:
    Ways WayFor(const Entry* entries, std::size_t count, const Box& centres) const;
    bool IsLong(const Box& box) const;
  };

  static void SortByNearness(
    Entry* entries, std::size_t count, std::size_t lanes, std::size_t* ends);
  std::uint32_t NewNode(std::uint32_t parent, int lane);
  void Fill(std::uint32_t node, Entry* entries, std::size_t count);
  void FillLane(std::uint32_t node, int lane, Entry* entries, std::size_t count);
  void SetEntry(std::uint32_t node, int lane, std::uint32_t entry);
  void AddItemsUpTo(std::uint32_t item);
  void SetHeld(std::uint32_t item, bool isHeld);
  void PutIntoLane(std::uint32_t node, int lane, const Entry& entry);
  bool IsStillThere(const Place& place, const Entry& entry) const;
  void Insert(const Entry& entry);
  int LaneFor(std::uint32_t node, const Entry& entry) const;
  void Divide(std::uint32_t node, const Entry& entry);
  Entry EntryAt(std::uint32_t node, int lane) const;
  void Remove(const Place& place);
  void UpdateAbove(std::uint32_t node);

  std::vector<LooseNode> Nodes;
  std::vector<Cell> Cells;          ///< of the nodes
  std::vector<Place> Places;        ///< of the items
  std::vector<std::uint8_t> IsHeld; ///< each item
  std::vector<std::uint32_t> WithoutPlace;
  std::size_t Changes = 0;
};

}

#endif
