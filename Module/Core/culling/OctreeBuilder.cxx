#include "Core/culling/OctreeBuilder.h"

#include "Core/culling/Octree.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace vitrine
{

namespace
{

// Boxes that are asked for at once, so many that they stay in the first cache.
constexpr std::size_t ChunkSize = 256;

// A list's boxes are copied where that costs less memory than a share of this of all boxes,
constexpr std::size_t FirstCopyShare = 4;
// again where they lie among this many times as many,
constexpr std::size_t NextCopyShare = 12;
// and not where so few of them are about: 400 kB stay in the second cache.
constexpr std::size_t FewBoxes = 16384;

// A node that would make only a few leaves is not split where these would list its items so many times over.
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

// Calls `visit` with each octant that has its bit set; mostly there is one.
template <class Visit>
void ForEachOctant(unsigned octants, Visit&& visit)
{
  for (; octants != 0; octants &= octants - 1)
  {
    visit(LowestBitOf.Bits[octants]);
  }
}

// For each set of octants a word with a byte for each octant: 1 if it is in the set, else 0.
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

// Counts items by octant without branches: a byte of a word for each octant, added up before a byte can overflow.
class OctantCounts
{
public:
  void Add(unsigned octants)
  {
    this->Word += WordOf.Words[octants];
    this->Kept += octants == 0;
    if (++this->InWord == 255)
    {
      this->Flush();
    }
  }

  void Flush()
  {
    for (int octant = 0; octant < 8; ++octant)
    {
      this->Counts[octant] += this->Word >> 8 * octant & 255;
    }
    this->Word = 0;
    this->InWord = 0;
  }

  // By slot, after Flush().
  std::array<std::size_t, OctreeNode::OwnSlot + 1> BySlot() const
  {
    std::array<std::size_t, OctreeNode::OwnSlot + 1> counts{};
    std::copy(this->Counts.begin(), this->Counts.end(), counts.begin());
    counts[OctreeNode::OwnSlot] = this->Kept;
    return counts;
  }

private:
  std::array<std::size_t, 8> Counts{};
  std::uint64_t Word = 0;
  std::size_t Kept = 0;
  int InWord = 0;
};

}

void OctreeBuilder::Build(
  std::uint32_t node, const OctreeCell& cell, int depth, std::vector<std::uint32_t> items)
{
  const Range range{ 0, items.size() };
  this->Scratch = std::move(items);
  this->ItemCount = range.Size();
  this->Divide(node, cell, depth, range);
}

// Calls `visit` with the number of each entry and its box.
template <class Visit>
void OctreeBuilder::ForEachBox(const Range& range, Visit&& visit)
{
  if (this->Near)
  {
    for (std::size_t i = range.Begin; i < range.End; ++i)
    {
      visit(i, this->Near->Boxes[this->Scratch[i]]);
    }
    return;
  }
  std::array<Box, ChunkSize> boxes;
  for (std::size_t begin = range.Begin; begin < range.End; begin += ChunkSize)
  {
    const std::size_t count = std::min(ChunkSize, range.End - begin);
    this->Boxes.Read(this->Scratch.data() + begin, count, boxes.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      visit(begin + i, boxes[i]);
    }
  }
}

void OctreeBuilder::Divide(
  std::uint32_t node, const OctreeCell& cell, int depth, const Range& range)
{
  if (this->IsWorthCopying(range.Size()))
  {
    const Copies copies = this->Copy(range);
    const Copies* const before = std::exchange(this->Near, &copies);
    this->Divide(node, cell, depth, range);
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
  this->Scratch.resize(slots[0].Begin);
  this->Page.Nodes[node] = { bounds, first, OctreeNode::InnerDetail(slotBits) };
}

bool OctreeBuilder::IsWorthCopying(std::size_t size) const
{
  if (this->Near == nullptr)
  {
    return size <= std::max(this->ItemCount / FirstCopyShare, FewBoxes);
  }
  const std::size_t about = this->Near->Boxes.size();
  return about > FewBoxes && size <= about / NextCopyShare;
}

// Copies a list's boxes and replaces the list's entries by the numbers of the copies.
OctreeBuilder::Copies OctreeBuilder::Copy(const Range& range)
{
  Copies copies;
  copies.Boxes.resize(range.Size());
  copies.Items.resize(range.Size());
  this->ForEachBox(range,
    [&](std::size_t i, const Box& box)
    {
      const std::size_t number = i - range.Begin;
      copies.Boxes[number] = box;
      copies.Items[number] = this->Near ? this->Near->Items[this->Scratch[i]] : this->Scratch[i];
    });
  for (std::size_t i = range.Begin; i < range.End; ++i)
  {
    this->Scratch[i] = static_cast<std::uint32_t>(i - range.Begin);
  }
  return copies;
}

// Appends to the scratch list what stands in each octant, and last what the cell keeps. Does nothing and returns false
// where that would not separate the items.
bool OctreeBuilder::Scatter(const OctreeCell& cell, const Range& range, Slots& slots)
{
  std::vector<std::uint8_t>& octantsOf = this->Octants;
  if (octantsOf.size() < range.Size())
  {
    octantsOf.resize(range.Size());
  }
  OctantCounts counter;
  this->ForEachBox(range,
    [&](std::size_t i, const Box& box)
    {
      const std::uint8_t octants = cell.OctantsFor(box);
      octantsOf[i - range.Begin] = octants;
      counter.Add(octants);
    });
  counter.Flush();
  const std::array<std::size_t, OctreeNode::OwnSlot + 1> counts = counter.BySlot();
  const std::size_t largest = *std::max_element(counts.begin(), counts.end());
  const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 });
  const bool isMostlyRepeated =
    sum > MostRepetition * range.Size() && range.Size() <= FewLeaves * this->LeafSize;
  const bool isInVain = isMostlyRepeated || counts[OctreeNode::OwnSlot] == range.Size() ||
    (largest == range.Size() && (!cell.IsDivisible() || this->HaveCommonPoint(range)));
  if (isInVain)
  {
    return false;
  }

  std::size_t end = this->Scratch.size();
  std::array<std::size_t, OctreeNode::OwnSlot + 1> ends;
  for (int slot = 0; slot <= OctreeNode::OwnSlot; ++slot)
  {
    ends[slot] = end;
    slots[slot] = { end, end + counts[slot] };
    end += counts[slot];
  }
  this->Scratch.resize(end);
  for (std::size_t i = range.Begin; i < range.End; ++i)
  {
    const std::uint32_t entry = this->Scratch[i];
    const unsigned octants = octantsOf[i - range.Begin];
    if (octants == 0)
    {
      this->Scratch[ends[OctreeNode::OwnSlot]++] = entry;
    }
    ForEachOctant(octants, [&](int octant) { this->Scratch[ends[octant]++] = entry; });
  }
  return true;
}

bool OctreeBuilder::HaveCommonPoint(const Range& range)
{
  Box common = Box::Everything();
  this->ForEachBox(range, [&](std::size_t, const Box& box) { common = common.ClippedTo(box); });
  return !common.IsEmpty();
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
  this->ForEachBox(range,
    [&](std::size_t i, const Box& box)
    {
      bounds.Add(box.ClippedTo(cell.Extent));
      *item++ = this->Near ? this->Near->Items[this->Scratch[i]] : this->Scratch[i];
    });
  this->Page.Nodes[node] = { bounds, first, OctreeNode::LeafDetail(range.Size()) };
}

}
