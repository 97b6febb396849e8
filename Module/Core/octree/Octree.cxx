#include "Core/octree/Octree.h"

#include "Core/octree/OctreeBuilder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace vitrine
{

Octree::Octree(const ItemBoxes& boxes, std::uint32_t leafSize)
  : LargestLeaf(leafSize)
{
  assert(leafSize >= 1);
  std::vector<BoxedItem> items = this->ReadPlaceable(boxes);
  if (items.empty())
  {
    return;
  }
  this->Root = OctreeCell::Around(this->Built);
  const std::uint32_t root = this->Top.NewNodes(1);
  OctreeBuilder(leafSize, this->Top).Build(root, this->Root, 0, std::move(items));
  this->Top.Nodes.shrink_to_fit();
  this->Top.Items.shrink_to_fit();
}

// Separates the unplaced items and finds the box around all others.
std::vector<BoxedItem> Octree::ReadPlaceable(const ItemBoxes& boxes)
{
  constexpr std::uint32_t ChunkSize = 256;
  std::vector<BoxedItem> placeable;
  // The additional eighth is the builder's working space.
  placeable.reserve(boxes.Count() + std::size_t{ boxes.Count() } / 8);
  std::array<std::uint32_t, ChunkSize> chunk;
  std::array<Box, ChunkSize> boxesOfChunk;
  for (std::uint32_t begin = 0; begin < boxes.Count();)
  {
    const std::uint32_t count = std::min(ChunkSize, boxes.Count() - begin);
    std::iota(chunk.begin(), chunk.begin() + count, begin);
    boxes.Read(chunk.data(), count, boxesOfChunk.data());
    for (std::uint32_t i = 0; i < count; ++i)
    {
      if (boxesOfChunk[i].IsPlaceable())
      {
        this->Built.Add(boxesOfChunk[i]);
        placeable.push_back({ boxesOfChunk[i], begin + i });
      }
      else
      {
        this->Unplaced.push_back(begin + i);
      }
    }
    begin += count;
  }
  return placeable;
}

Octree::Octree(OctreePage top, const OctreeCell& root, std::vector<std::uint32_t> unplaced,
  std::uint32_t leafSize, std::shared_ptr<OctreePages> pages)
  : Top(std::move(top))
  , Root(root)
  , Unplaced(std::move(unplaced))
  , LargestLeaf(leafSize)
  , Pages(std::move(pages))
{
}

std::shared_ptr<const OctreePage> Octree::LoadPage(const OctreeNode& node) const
{
  assert(node.Kind() == OctreeNode::Kinds::Stored && this->Pages);
  return this->Pages->Load(node.First);
}

std::size_t Octree::Bytes() const
{
  return sizeof(*this) + this->Top.Bytes() + this->Unplaced.capacity() * sizeof(std::uint32_t);
}

}
