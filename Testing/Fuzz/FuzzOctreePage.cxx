// Takes bytes for a page of an octree read from disk. A page that passes the check is walked. The walk has to end and
// to stay within the page, which the address sanitizer checks.

#include "FuzzBytes.h"

#include "Core/octree/OctreeFile.h"
#include "Core/octree/OctreeWalk.h"

#include <vector>

namespace
{

using namespace vitrine;

constexpr std::uint32_t ItemCount = 64;

struct Visitor
{
  std::size_t Nodes = 0;

  bool Enter(const OctreeNode&)
  {
    ++this->Nodes;
    return true;
  }
  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    for (std::uint32_t i = 0; i < count; ++i)
    {
      Require(items[i] < ItemCount, "the page lists an item that there is not");
    }
  }
};

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  OctreePage page;
  page.Nodes.resize(bytes.Below(24));
  for (OctreeNode& node : page.Nodes)
  {
    // Small numbers most of the time, which make trees; now and then large ones.
    const bool isLarge = bytes.Below(16) == 0;
    node.First = isLarge ? bytes.Byte() * 0x01010101u : bytes.Below(32);
    const std::uint32_t detail = isLarge ? bytes.Byte() * 0x01010101u : bytes.Below(512);
    node.Detail = detail | std::uint32_t{ bytes.Below(4) } << 30;
  }
  page.Items.resize(bytes.Below(40));
  for (std::uint32_t& item : page.Items)
  {
    item = bytes.Below(ItemCount + 1);
  }
  if (OctreeFile::IsSound(page, true, ItemCount, 1))
  {
    const std::size_t nodes = page.Nodes.size();
    const Octree tree(std::move(page), OctreeCell(), {}, 8, nullptr);
    Visitor visitor;
    WalkFrontToBack(tree, OrderFromEye(glm::vec3(0)), visitor);
    Require(visitor.Nodes <= nodes, "the walk comes by a node twice");
  }
  return 0;
}
