#include "Core/octree/OctreePage.h"

#include <limits>
#include <stdexcept>

namespace vitrine
{

namespace
{

constexpr std::size_t LargestNumber = std::numeric_limits<std::uint32_t>::max();

int FloorOfLogarithm(std::uint32_t value)
{
  int logarithm = 0;
  while (value >>= 1)
  {
    ++logarithm;
  }
  return logarithm;
}

int CeilingOfLogarithm(std::uint32_t value)
{
  return value <= 1 ? 0 : FloorOfLogarithm(value - 1) + 1;
}

template <class Value>
std::size_t BytesOf(const std::vector<Value>& values)
{
  return values.capacity() * sizeof(Value);
}

}

std::uint32_t OctreePage::NewNodes(std::uint32_t count)
{
  assert(count >= 1 && count < this->FreeBlocks.size());
  std::vector<std::uint32_t>& free = this->FreeBlocks[count];
  if (!free.empty())
  {
    const std::uint32_t first = free.back();
    free.pop_back();
    return first;
  }
  const std::size_t first = this->Nodes.size();
  if (first + count > LargestNumber)
  {
    throw std::length_error("an octree has at most 2^32 - 1 nodes");
  }
  this->Nodes.resize(first + count);
  return static_cast<std::uint32_t>(first);
}

void OctreePage::FreeNodes(std::uint32_t first, std::uint32_t count)
{
  this->FreeBlocks[count].push_back(first);
}

std::uint32_t OctreePage::NewList(std::uint32_t room)
{
  assert(room >= 1);
  // All lists in it have enough room.
  std::vector<std::uint32_t>& free = this->FreeLists[CeilingOfLogarithm(room)];
  if (room <= OctreeNode::LargestCount && !free.empty())
  {
    const std::uint32_t first = free.back();
    free.pop_back();
    return first;
  }
  const std::size_t first = this->Items.size() + 1;
  if (room > OctreeNode::LargestCount || first + room > LargestNumber)
  {
    throw std::length_error(
      "an octree's leaf lists at most 2^30 - 1 items, all its leaves 2^32 - 2");
  }
  this->Items.resize(first + room);
  this->Items[first - 1] = room;
  return static_cast<std::uint32_t>(first);
}

void OctreePage::FreeList(std::uint32_t first)
{
  this->FreeLists[FloorOfLogarithm(this->RoomOf(first))].push_back(first);
}

std::size_t OctreePage::Bytes() const
{
  std::size_t bytes = BytesOf(this->Nodes) + BytesOf(this->Items);
  for (const std::vector<std::uint32_t>& free : this->FreeBlocks)
  {
    bytes += BytesOf(free);
  }
  for (const std::vector<std::uint32_t>& free : this->FreeLists)
  {
    bytes += BytesOf(free);
  }
  return bytes;
}

}
