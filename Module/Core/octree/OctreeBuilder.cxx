#include "Core/octree/OctreeBuilder.h"

#include "Core/geometry/Lanes.h"
#include "Core/octree/Octree.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace vitrine
{

namespace
{

// The boxes of a list are copied if the list lies among at least this many times as many boxes.
constexpr std::size_t CopyShare = 16;
// Boxes are not copied from so few, because 460 kB stay in the second-level cache.
constexpr std::size_t FewBoxes = 16384;

// Prefetch distance of boxes, in entries.
constexpr std::size_t Ahead = 16;

// A node that makes only a few leaves is not split if these would list its items so many times over.
constexpr std::size_t FewLeaves = 4;
constexpr double MostRepetition = 2.5;

struct LowestBits
{
  std::uint8_t Bits[256] = {};

  constexpr LowestBits()
  {
    for (unsigned i = 1; i < 256; ++i)
    {
      Bits[i] = (i & 1u) != 0 ? 0 : static_cast<std::uint8_t>(Bits[i / 2] + 1);
    }
  }
};

constexpr LowestBits LowestBitOf;

// Calls `visit` with each octant whose bit is set. Mostly there is one.
template <class Visit>
void ForEachOctant(unsigned octants, Visit&& visit)
{
  for (; octants != 0; octants &= octants - 1)
  {
    visit(LowestBitOf.Bits[octants]);
  }
}

// A word per set of octants, with one byte per octant: 1 if it is in the set, else 0.
struct OctantWords
{
  std::uint64_t Words[256] = {};

  constexpr OctantWords()
  {
    for (unsigned octants = 0; octants < 256; ++octants)
    {
      for (unsigned octant = 0; octant < 8; ++octant)
      {
        Words[octants] |= std::uint64_t{ octants >> octant & 1 } << 8 * octant;
      }
    }
  }
};

constexpr OctantWords WordOf;

}

void OctreeBuilder::Build(
  std::uint32_t node, const OctreeCell& cell, int depth, std::vector<BoxedItem> items)
{
  this->Near = { 0, items.size() };
  this->Copies = std::move(items);
  this->Entries.reserve(2 * this->Near.Size() + this->Near.Size() / 4); // This mostly suffices.
  this->Entries.resize(this->Near.Size());
  std::iota(this->Entries.begin(), this->Entries.end(), 0u);
  this->Divide(node, cell, depth, this->Near);
}

// Calls `visit` with the number of each entry and its item.
template <class Visit>
void OctreeBuilder::ForEachItem(const Range range, Visit visit) const
{
  const BoxedItem* const near = this->Copies.data() + this->Near.Begin;
  const std::uint32_t* const entries = this->Entries.data();
  for (std::size_t i = range.Begin; i < range.End; ++i)
  {
    if (i + Ahead < range.End)
    {
      Prefetch(near + entries[i + Ahead]);
    }
    visit(i, near[entries[i]]);
  }
}

void OctreeBuilder::Divide(std::uint32_t node, const OctreeCell& cell, int depth, Range range)
{
  if (this->IsWorthCopying(range.Size()))
  {
    const Range before = std::exchange(this->Near, this->Copy(range));
    this->Divide(node, cell, depth, range);
    this->Copies.resize(this->Near.Begin);
    this->Near = before;
    return;
  }
  Slots slots;
  const bool isLeaf = range.Size() <= this->LeafSize || depth == Octree::LargestDepth ||
    !this->Scatter(cell, range, slots);
  if (isLeaf)
  {
    this->MakeLeaf(node, cell, range);
    return;
  }

  std::uint32_t slotBits = 0;
  std::uint32_t count = 0;
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    if (slots[slot].Size() > 0)
    {
      slotBits |= 1u << slot;
      ++count;
    }
  }
  const std::uint32_t first = this->Page.NewNodes(count);
  Box bounds;
  std::uint32_t child = first;
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    if (slots[slot].Size() == 0)
    {
      continue;
    }
    if (slot == OctreeNode::OwnSlot)
    {
      this->MakeLeaf(child, cell, slots[slot]);
    }
    else
    {
      this->Divide(child, cell.Octant(slot), depth + 1, slots[slot]);
    }
    bounds.Add(this->Page.Nodes[child].Bounds);
    ++child;
  }
  this->Entries.resize(slots[0].Begin);
  this->Page.Nodes[node] = { bounds, first, OctreeNode::InnerDetail(slotBits) };
}

bool OctreeBuilder::IsWorthCopying(std::size_t size) const
{
  return this->Near.Size() > FewBoxes && size <= this->Near.Size() / CopyShare;
}

// Appends copies of a list's items and redirects its entries to them.
OctreeBuilder::Range OctreeBuilder::Copy(const Range& range)
{
  const std::size_t first = this->Copies.size();
  this->Copies.resize(first + range.Size());
  BoxedItem* copy = this->Copies.data() + first;
  this->ForEachItem(range, [copy](std::size_t, const BoxedItem& item) mutable { *copy++ = item; });
  const auto entries = this->Entries.begin();
  std::iota(entries + range.Begin, entries + range.End, 0u);
  return { first, first + range.Size() };
}

// Appends the entries of each octant, and last those that the cell keeps. Returns false without a change if that would
// not separate the items.
bool OctreeBuilder::Scatter(const OctreeCell& cell, const Range& range, Slots& slots)
{
  this->FindOctants(cell, range);
  const Counts counts = CountBySlot(this->Octants.data(), range.Size());
  if (this->IsInVain(cell, range, counts))
  {
    return false;
  }
  slots = this->AppendSlots(counts);
  this->FillSlots(range, slots);
  return true;
}

void OctreeBuilder::FindOctants(const OctreeCell& cell, const Range& range)
{
  if (this->Octants.size() < range.Size())
  {
    this->Octants.resize(range.Size());
  }
  // The lambda has its own copy of the cell, because the compiler must assume that written bytes change anything else.
  std::uint8_t* octants = this->Octants.data();
  this->ForEachItem(range,
    [cell, octants](std::size_t, const BoxedItem& item) mutable
    { *octants++ = cell.OctantsFor(item.Extent); });
}

// This avoids branches: each octant has a byte of a word, which is added up before a byte can overflow.
OctreeBuilder::Counts OctreeBuilder::CountBySlot(const std::uint8_t* octants, std::size_t count)
{
  constexpr std::size_t LargestByte = 255;
  Counts counts{};
  for (std::size_t begin = 0; begin < count; begin += LargestByte)
  {
    const std::size_t end = std::min(begin + LargestByte, count);
    std::uint64_t word = 0;
    std::size_t kept = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      word += WordOf.Words[octants[i]];
      kept += octants[i] == 0;
    }
    for (int octant = 0; octant < OctreeNode::OwnSlot; ++octant)
    {
      counts[octant] += word >> 8 * octant & LargestByte;
    }
    counts[OctreeNode::OwnSlot] += kept;
  }
  return counts;
}

// Returns true if octants with these counts are not worth having.
bool OctreeBuilder::IsInVain(const OctreeCell& cell, const Range& range, const Counts& counts) const
{
  const std::size_t largest = *std::max_element(counts.begin(), counts.end());
  const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 });
  const bool isMostlyRepeated =
    sum > MostRepetition * range.Size() && range.Size() <= FewLeaves * this->LeafSize;
  return isMostlyRepeated || counts[OctreeNode::OwnSlot] == range.Size() ||
    (largest == range.Size() && (!cell.IsDivisible() || this->HaveCommonPoint(range)));
}

bool OctreeBuilder::HaveCommonPoint(const Range& range) const
{
  Box common = Box::Everything();
  this->ForEachItem(
    range, [&](std::size_t, const BoxedItem& item) { common = common.ClippedTo(item.Extent); });
  return !common.IsEmpty();
}

// Makes room for lists of these lengths.
OctreeBuilder::Slots OctreeBuilder::AppendSlots(const Counts& counts)
{
  Slots slots;
  std::size_t end = this->Entries.size();
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    slots[slot] = { end, end + counts[slot] };
    end += counts[slot];
  }
  this->Entries.resize(end);
  return slots;
}

void OctreeBuilder::FillSlots(const Range& range, const Slots& slots)
{
  Counts ends;
  std::transform(
    slots.begin(), slots.end(), ends.begin(), [](const Range& slot) { return slot.Begin; });
  std::uint32_t* const entries = this->Entries.data();
  for (std::size_t i = range.Begin; i < range.End; ++i)
  {
    const std::uint32_t entry = entries[i];
    const unsigned octants = this->Octants[i - range.Begin];
    if (octants == 0)
    {
      entries[ends[OctreeNode::OwnSlot]++] = entry;
    }
    ForEachOctant(octants, [&](int octant) { entries[ends[octant]++] = entry; });
  }
}

void OctreeBuilder::MakeLeaf(std::uint32_t node, const OctreeCell& cell, const Range& range)
{
  assert(range.Size() > 0);
  if (range.Size() > OctreeNode::LargestCount)
  {
    throw std::length_error("an octree's leaf lists at most 2^30 - 1 items");
  }
  const std::uint32_t first = this->Page.NewList(static_cast<std::uint32_t>(range.Size()));
  Box bounds;
  std::uint32_t* item = this->Page.Items.data() + first;
  this->ForEachItem(range,
    [&](std::size_t, const BoxedItem& boxed)
    {
      bounds.Add(boxed.Extent.ClippedTo(cell.Extent));
      *item++ = boxed.Item;
    });
  this->Page.Nodes[node] = { bounds, first, OctreeNode::LeafDetail(range.Size()) };
}

}
