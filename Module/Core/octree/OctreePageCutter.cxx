#include "Core/octree/OctreePageCutter.h"

#include <cstring>

namespace vitrine
{

namespace
{

// A page smaller than this share of a full one is not worth a read from disk.
constexpr std::size_t LeastShare = 64;

}

OctreePageCutter::OctreePageCutter(const OctreePage& whole, std::size_t pageBytes)
  : Whole(whole)
  , PageBytes(pageBytes)
  , BytesBelow(whole.Nodes.size())
{
  this->Roots.push_back(0);
  if (!whole.Nodes.empty())
  {
    this->Measure(0);
    this->Cut(0);
  }
}

OctreePage OctreePageCutter::Page(std::uint32_t number) const
{
  OctreePage page;
  if (!this->Whole.Nodes.empty())
  {
    page.NewNodes(1);
    this->Copy(this->Roots[number], page, 0, number == 0);
  }
  return page;
}

std::uint64_t OctreePageCutter::Measure(std::uint32_t number)
{
  const OctreeNode& node = this->Whole.Nodes[number];
  std::uint64_t bytes = sizeof(OctreeNode);
  if (node.IsLeaf())
  {
    bytes += (1 + std::uint64_t{ node.Count() }) * sizeof(std::uint32_t);
  }
  else
  {
    for (std::uint32_t i = 0; i < node.ChildCount(); ++i)
    {
      bytes += this->Measure(node.First + i);
    }
  }
  return this->BytesBelow[number] = bytes;
}

void OctreePageCutter::Cut(std::uint32_t number)
{
  const OctreeNode& node = this->Whole.Nodes[number];
  if (node.IsLeaf())
  {
    return;
  }
  for (std::uint32_t child = node.First; child < node.First + node.ChildCount(); ++child)
  {
    const bool isLeaf = this->Whole.Nodes[child].IsLeaf();
    if (this->BytesBelow[child] > this->PageBytes && !isLeaf)
    {
      this->Cut(child);
    }
    else if (this->BytesBelow[child] > this->PageBytes / LeastShare)
    {
      this->Numbers[child] = this->PageCount();
      this->Roots.push_back(child);
    }
  }
}

void OctreePageCutter::Copy(
  std::uint32_t from, OctreePage& page, std::uint32_t to, bool isTop) const
{
  const OctreeNode& node = this->Whole.Nodes[from];
  page.Nodes[to] = node;
  if (node.IsLeaf())
  {
    const std::uint32_t first = page.NewList(node.Count());
    std::memcpy(
      page.Items.data() + first, this->Whole.ItemsOf(node), node.Count() * sizeof(std::uint32_t));
    page.Nodes[to].First = first;
    return;
  }
  const std::uint32_t first = page.NewNodes(node.ChildCount());
  page.Nodes[to].First = first;
  for (std::uint32_t i = 0; i < node.ChildCount(); ++i)
  {
    const std::uint32_t stored = isTop ? this->PageOf(node.First + i) : 0;
    if (stored != 0)
    {
      page.Nodes[first + i] = { this->Whole.Nodes[node.First + i].Bounds, stored,
        OctreeNode::StoredDetail() };
    }
    else
    {
      this->Copy(node.First + i, page, first + i, isTop);
    }
  }
}

std::uint32_t OctreePageCutter::PageOf(std::uint32_t node) const
{
  const auto found = this->Numbers.find(node);
  return found == this->Numbers.end() ? 0 : found->second;
}

}
