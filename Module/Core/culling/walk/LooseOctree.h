#ifndef VITRINE_CORE_CULLING_WALK_LOOSE_OCTREE_H
#define VITRINE_CORE_CULLING_WALK_LOOSE_OCTREE_H

#include "Core/geometry/BoxLanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * A node of a loose octree. It has up to eight entries, each an item or a child node, with their boxes side by side.
 */
struct alignas(64) LooseNode
{
  static constexpr std::uint32_t None = 0xffffffffu;
  static constexpr std::uint32_t ItemBit = 1u << 31;
  /** Flag of an entry that is longer than the cell of its node. It may hide all the rest. */
  static constexpr std::uint32_t LongBit = 1u << 30;
  static constexpr std::uint32_t NumberBits = LongBit - 1;

  BoxLanes Boxes;
  std::uint32_t Entries[LaneCount] = { None, None, None, None, None, None, None, None };
  std::uint32_t Counts[LaneCount] = {}; ///< number of items in each entry

  bool Has(int lane) const { return this->Entries[lane] != None; }
  bool IsItem(int lane) const { return (this->Entries[lane] & ItemBit) != 0; }

  /** Masks of the lanes that have an entry, and of the lanes that have a long one. */
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
 * An octree in which each item stands once, in the cell that contains the centre of its box. The box of a node holds
 * all of its items and may reach beyond its cell (T. Ulrich: Loose octrees, Game Programming Gems 1, 2000). Items that
 * are longer than a cell stand apart from the others in it.
 *
 * Parts of an assembly are as large as the distances between them. In an octree of disjoint cells (Octree.h) each part
 * would stand in some twenty leaves.
 *
 * Items and nodes stand in one table of eight lanes, so that their boxes are tested eight at a time. A cell of up to 64
 * items is not cut into octants, most of which would hold two or three items. It is cut into as few lanes of eight
 * neighbours as possible.
 */
class LooseOctree
{
public:
  /** Makes an empty tree. */
  LooseOctree() = default;

  /** Makes a tree of the items 0, 1, ... with these boxes. Items with empty or infinite boxes are not in the tree. */
  explicit LooseOctree(const std::vector<Box>& boxes);

  bool IsEmpty() const { return this->Nodes.empty() || this->Nodes[0].Count() == 0; }

  /** Returns a node. Node 0 is the root, if there is one. */
  const LooseNode& Node(std::uint32_t node) const { return this->Nodes[node]; }

  /** A hint that the node will be read soon. */
  void PrefetchNode(std::uint32_t node) const { PrefetchAll(this->Nodes[node]); }

  /** Returns true if the item is in the tree. */
  bool Holds(std::uint32_t item) const { return item < this->IsHeld.size() && this->IsHeld[item]; }

  /** One more than the largest number of an item that was ever given. */
  std::size_t ItemCount() const { return this->IsHeld.size(); }

  /** The items that are not in the tree, in ascending order. */
  const std::vector<std::uint32_t>& Unplaced() const { return this->WithoutPlace; }

  /**
   * Moves an item to a box, or adds it. An item with an empty or infinite box leaves the tree. Only the nodes above its
   * old and new place change.
   */
  void SetBox(std::uint32_t item, const Box& box);

  /**
   * The number of calls of SetBox() since the tree was built. After many of them it is better to build the tree anew.
   */
  std::size_t ChangeCount() const { return this->Changes; }

  /** The memory that the tree takes, in bytes. */
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

  /** How the lanes of a node divide its entries. */
  enum class Ways
  {
    NotAtAll, ///< Entries stand in any lane.
    ByOctant,
    ByNearness, ///< Few items stand in as few lanes as hold them, each with its neighbours.
    BySize ///< Items that are longer than the cell stand in the first lane, the others in the second.
  };

  /** The smallest cube around the centres of the boxes in a node when it was filled. */
  struct Cell
  {
    glm::vec3 Centre{ 0.0f };
    float Half = 0.0f;
    Ways Way = Ways::NotAtAll;
    std::uint32_t Parent = LooseNode::None;
    int Lane = 0; ///< lane in the parent

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
  std::vector<Cell> Cells;          ///< the cell of each node
  std::vector<Place> Places;        ///< the place of each item
  std::vector<std::uint8_t> IsHeld; ///< 1 for each item that is in the tree
  std::vector<std::uint32_t> WithoutPlace;
  std::size_t Changes = 0;
};

}

#endif
