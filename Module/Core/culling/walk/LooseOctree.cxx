#include "Core/culling/walk/LooseOctree.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace vitrine
{

namespace
{

glm::vec3 CentreOf(const Box& box)
{
  return 0.5f * box.Min + 0.5f * box.Max;
}

// A node whose lanes are leaves has room for 64 items. From 10 items on a node is divided by nearness. A leaf that is
// divided for its ninth item gets octants, which leave more room to grow.
const std::size_t MostOfLeaves = std::size_t{ LaneCount } * LaneCount;
const std::size_t LeastOfLeaves = LaneCount + 2;

// An item stays in a leaf while its centre is within this multiple of the half size of the cell.
const float Beyond = 1.5f;

float LengthsOf(const Box& box)
{
  const glm::vec3 size = box.Max - box.Min;
  return size.x + size.y + size.z;
}

/**
 * Returns the lane whose box grows least by another box, among lanes that hold something. Returns lane 0 if no lane
 * does. Lanes that become long are mended when the tree is built anew.
 */
int LaneNearest(const LooseNode& node, const Box& box)
{
  int nearest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    Box both = node.Boxes.At(lane);
    const float before = LengthsOf(both);
    both.Add(box);
    const float growth = LengthsOf(both) - before;
    if (node.Has(lane) && growth < least)
    {
      nearest = lane;
      least = growth;
    }
  }
  return nearest;
}

int OctantOf(const glm::vec3& point, const glm::vec3& centre)
{
  return (point.x >= centre.x ? 1 : 0) | (point.y >= centre.y ? 2 : 0) |
    (point.z >= centre.z ? 4 : 0);
}
}

LooseOctree::LooseOctree(const std::vector<Box>& boxes)
{
  assert(boxes.size() <= LooseNode::NumberBits);
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  this->IsHeld.resize(boxes.size(), 0);
  for (std::uint32_t item = 0; item < boxes.size(); ++item)
  {
    if (boxes[item].IsPlaceable())
    {
      entries.push_back({ item, boxes[item] });
      this->IsHeld[item] = 1;
    }
    else
    {
      this->WithoutPlace.push_back(item);
    }
  }
  this->Places.resize(boxes.size());
  if (!entries.empty())
  {
    this->Nodes.reserve(entries.size() / 4 + 1);
    this->Cells.reserve(entries.size() / 4 + 1);
    this->Fill(this->NewNode(LooseNode::None, 0), entries.data(), entries.size());
  }
}

std::uint32_t LooseOctree::NewNode(std::uint32_t parent, int lane)
{
  this->Nodes.emplace_back();
  this->Cells.emplace_back();
  this->Cells.back().Parent = parent;
  this->Cells.back().Lane = lane;
  return static_cast<std::uint32_t>(this->Nodes.size() - 1);
}

/** Fills an empty node with entries, which are reordered. Makes child nodes as needed. */
void LooseOctree::Fill(std::uint32_t node, Entry* entries, std::size_t count)
{
  this->Cells[node].FitTo(entries, count);
  if (count <= LaneCount)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->PutIntoLane(node, static_cast<int>(i), entries[i]);
    }
    return;
  }
  const Ends ends = this->Cells[node].Sort(entries, count);
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    this->FillLane(node, lane, entries + ends[lane], ends[lane + 1] - ends[lane]);
  }
}

/** Makes the cell the smallest cube around the centres of all entries. */
void LooseOctree::Cell::FitTo(const Entry* entries, std::size_t count)
{
  Box centres;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec3 centre = CentreOf(entries[i].Bounds);
    centres.Add({ centre, centre });
  }
  const glm::vec3 size = centres.Max - centres.Min;
  this->Centre = CentreOf(centres);
  this->Half = 0.5f * std::max(size.x, std::max(size.y, size.z));
  this->Way = count <= LaneCount ? Ways::NotAtAll : this->WayFor(entries, count, centres);
}

LooseOctree::Ways LooseOctree::Cell::WayFor(
  const Entry* entries, std::size_t count, const Box& centres) const
{
  // If the extent is one step of floats, rounding may leave all centres on one side of the middle.
  if (OctantOf(centres.Min, this->Centre) == OctantOf(centres.Max, this->Centre))
  {
    return Ways::NotAtAll;
  }
  const std::ptrdiff_t longOnes = std::count_if(
    entries, entries + count, [&](const Entry& entry) { return this->IsLong(entry.Bounds); });
  const bool differ = longOnes > 0 && longOnes < static_cast<std::ptrdiff_t>(count);
  const bool areFew = LeastOfLeaves <= count && count <= MostOfLeaves;
  return differ ? Ways::BySize : areFew ? Ways::ByNearness : Ways::ByOctant;
}

bool LooseOctree::Cell::IsLong(const Box& box) const
{
  const glm::vec3 size = box.Max - box.Min;
  return std::max(size.x, std::max(size.y, size.z)) > 2.0f * this->Half;
}

/** Returns the lane of a box, if lanes stand for octants or sizes. */
int LooseOctree::Cell::LaneOf(const Box& box) const
{
  return this->Way == Ways::BySize ? (this->IsLong(box) ? 0 : 1)
                                   : OctantOf(CentreOf(box), this->Centre);
}

/**
 * Sorts entries into lanes of neighbours. It halves them along the axis on which their centres reach farthest.
 * @param lanes  number of lanes to fill
 * @param ends   is set to the end of the entries of each lane
 */
void LooseOctree::SortByNearness(
  Entry* entries, std::size_t count, std::size_t lanes, std::size_t* ends)
{
  if (lanes == 1)
  {
    *ends = count;
    return;
  }
  Box centres;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec3 centre = CentreOf(entries[i].Bounds);
    centres.Add({ centre, centre });
  }
  const glm::vec3 size = centres.Max - centres.Min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = lanes / 2, middle = count * half / lanes;
  std::nth_element(entries, entries + middle, entries + count,
    [axis](const Entry& a, const Entry& b)
    { return a.Bounds.Min[axis] + a.Bounds.Max[axis] < b.Bounds.Min[axis] + b.Bounds.Max[axis]; });
  SortByNearness(entries, middle, half, ends);
  SortByNearness(entries + middle, count - middle, lanes - half, ends + half);
  std::for_each(ends + half, ends + lanes, [middle](std::size_t& end) { end += middle; });
}

/** Sorts entries by lane. Returns where the entries of each lane begin, and where the last one ends. */
LooseOctree::Ends LooseOctree::Cell::Sort(Entry* entries, std::size_t count) const
{
  Ends ends{};
  if (this->Way == Ways::NotAtAll)
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      ends[lane + 1] = count * (lane + 1) / LaneCount;
    }
    return ends;
  }
  if (this->Way == Ways::ByNearness)
  {
    const std::size_t lanes = (count + LaneCount - 1) / LaneCount;
    SortByNearness(entries, count, lanes, ends.data() + 1);
    std::fill(ends.data() + 1 + lanes, ends.data() + ends.size(), count);
    return ends;
  }
  const std::vector<Entry> before(entries, entries + count);
  for (const Entry& entry : before)
  {
    ++ends[this->LaneOf(entry.Bounds) + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  Ends next = ends;
  for (const Entry& entry : before)
  {
    entries[next[this->LaneOf(entry.Bounds)]++] = entry;
  }
  return ends;
}

bool LooseOctree::Cell::Holds(const glm::vec3& point) const
{
  const glm::vec3 away = glm::abs(point - this->Centre);
  const float reach = Beyond * this->Half;
  return away.x <= reach && away.y <= reach && away.z <= reach;
}

void LooseOctree::FillLane(std::uint32_t node, int lane, Entry* entries, std::size_t count)
{
  if (count == 1)
  {
    this->PutIntoLane(node, lane, *entries);
  }
  else if (count > 1)
  {
    const std::uint32_t child = this->NewNode(node, lane);
    this->Fill(child, entries, count);
    this->SetEntry(node, lane, child);
    this->Nodes[node].Boxes.Set(lane, this->Nodes[child].Boxes.Bounds());
    this->Nodes[node].Counts[lane] = static_cast<std::uint32_t>(count);
  }
}

void LooseOctree::SetEntry(std::uint32_t node, int lane, std::uint32_t entry)
{
  const bool isLong = this->Cells[node].Way == Ways::BySize && lane == 0;
  this->Nodes[node].Entries[lane] =
    isLong && entry != LooseNode::None ? entry | LooseNode::LongBit : entry;
}

void LooseOctree::PutIntoLane(std::uint32_t node, int lane, const Entry& entry)
{
  this->SetEntry(node, lane, entry.Item | LooseNode::ItemBit);
  this->Nodes[node].Boxes.Set(lane, entry.Bounds);
  this->Nodes[node].Counts[lane] = 1;
  this->Places[entry.Item] = { node, lane };
}

void LooseOctree::AddItemsUpTo(std::uint32_t item)
{
  for (auto added = static_cast<std::uint32_t>(this->IsHeld.size()); added <= item; ++added)
  {
    this->Places.emplace_back();
    this->IsHeld.push_back(0);
    this->WithoutPlace.push_back(added);
  }
}

void LooseOctree::SetHeld(std::uint32_t item, bool isHeld)
{
  if (this->Holds(item) == isHeld)
  {
    return;
  }
  this->IsHeld[item] = isHeld;
  const auto place = std::lower_bound(this->WithoutPlace.begin(), this->WithoutPlace.end(), item);
  if (isHeld)
  {
    this->WithoutPlace.erase(place);
  }
  else
  {
    this->WithoutPlace.insert(place, item);
  }
}

void LooseOctree::SetBox(std::uint32_t item, const Box& box)
{
  ++this->Changes;
  this->AddItemsUpTo(item);
  const Place place = this->Places[item];
  const bool isHeld = this->Holds(item);
  if (!box.IsPlaceable())
  {
    if (isHeld)
    {
      this->Remove(place);
      this->SetHeld(item, false);
    }
    return;
  }
  this->SetHeld(item, true);
  const Entry entry{ item, box };
  if (isHeld && this->IsStillThere(place, entry))
  {
    this->Nodes[place.Node].Boxes.Set(place.Lane, box);
    this->UpdateAbove(place.Node);
    return;
  }
  if (isHeld)
  {
    this->Remove(place);
  }
  this->Insert(entry);
}

/** Returns true if the item may stay at its place. */
bool LooseOctree::IsStillThere(const Place& place, const Entry& entry) const
{
  const Cell& cell = this->Cells[place.Node];
  return cell.HasLanesForPlaces() ? cell.LaneOf(entry.Bounds) == place.Lane
                                  : cell.Holds(CentreOf(entry.Bounds));
}

void LooseOctree::Insert(const Entry& entry)
{
  if (this->Nodes.empty())
  {
    this->NewNode(LooseNode::None, 0);
  }
  std::uint32_t node = 0;
  int lane = this->LaneFor(node, entry);
  while (this->Nodes[node].Has(lane) && !this->Nodes[node].IsItem(lane))
  {
    node = this->Nodes[node].NodeAt(lane);
    lane = this->LaneFor(node, entry);
  }
  if (!this->Nodes[node].Has(lane))
  {
    this->PutIntoLane(node, lane, entry);
  }
  else if (this->Cells[node].HasLanesForPlaces() || !this->Nodes[node].IsFullOfItems())
  {
    std::array<Entry, 2> both{ this->EntryAt(node, lane), entry };
    this->FillLane(node, lane, both.data(), both.size());
  }
  else
  {
    this->Divide(node, entry);
  }
  this->UpdateAbove(node);
}

/** Returns the lane for a new entry: by the meaning of lanes, by nearness, or the lane with the fewest items. */
int LooseOctree::LaneFor(std::uint32_t node, const Entry& entry) const
{
  const Cell& cell = this->Cells[node];
  if (cell.HasLanesForPlaces())
  {
    return cell.LaneOf(entry.Bounds);
  }
  const auto& counts = this->Nodes[node].Counts;
  return cell.Way == Ways::ByNearness
    ? LaneNearest(this->Nodes[node], entry.Bounds)
    : static_cast<int>(std::min_element(counts, counts + LaneCount) - counts);
}

/** Makes room for one more item in a node that has an item in each lane. */
void LooseOctree::Divide(std::uint32_t node, const Entry& entry)
{
  std::array<Entry, LaneCount + 1> entries;
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    entries[lane] = this->EntryAt(node, lane);
  }
  entries[LaneCount] = entry;
  this->Nodes[node] = LooseNode();
  this->Fill(node, entries.data(), entries.size());
}

LooseOctree::Entry LooseOctree::EntryAt(std::uint32_t node, int lane) const
{
  return { this->Nodes[node].ItemAt(lane), this->Nodes[node].Boxes.At(lane) };
}

/** Removes an item from its node. The caller updates Places. */
void LooseOctree::Remove(const Place& place)
{
  LooseNode& node = this->Nodes[place.Node];
  node.Entries[place.Lane] = LooseNode::None;
  node.Boxes.Set(place.Lane, Box());
  node.Counts[place.Lane] = 0;
  this->UpdateAbove(place.Node);
}

/** Updates the boxes and counts of all nodes above. An empty node leaves its parent. */
void LooseOctree::UpdateAbove(std::uint32_t node)
{
  for (std::uint32_t child = node; this->Cells[child].Parent != LooseNode::None;
       child = this->Cells[child].Parent)
  {
    LooseNode& parent = this->Nodes[this->Cells[child].Parent];
    const int lane = this->Cells[child].Lane;
    const std::uint32_t count = this->Nodes[child].Count();
    this->SetEntry(this->Cells[child].Parent, lane, count > 0 ? child : LooseNode::None);
    parent.Boxes.Set(lane, this->Nodes[child].Boxes.Bounds());
    parent.Counts[lane] = count;
  }
}

std::size_t LooseOctree::Bytes() const
{
  return sizeof(*this) + this->Nodes.capacity() * sizeof(LooseNode) +
    this->Cells.capacity() * sizeof(Cell) + this->Places.capacity() * sizeof(Place) +
    this->IsHeld.capacity() + this->WithoutPlace.capacity() * sizeof(std::uint32_t);
}

}
