#ifndef VITRINE_CORE_OCTREE_OCTREE_PAGE_CUTTER_H
#define VITRINE_CORE_OCTREE_OCTREE_PAGE_CUTTER_H

#include "Core/octree/OctreePage.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vitrine
{

/** Cuts a tree into pages for a file. The first page has the nodes above the roots of all others. */
class OctreePageCutter
{
public:
  /**
   * Finds where to cut a tree.
   * @param whole      nodes and lists of the tree, all in memory; must outlive the cutter
   * @param pageBytes  largest size of a page in bytes; the first page, and single leaves, may exceed it
   */
  OctreePageCutter(const OctreePage& whole, std::size_t pageBytes);

  std::uint32_t PageCount() const { return static_cast<std::uint32_t>(this->Roots.size()); }

  OctreePage Page(std::uint32_t number) const;

private:
  std::uint64_t Measure(std::uint32_t number);
  void Cut(std::uint32_t number);
  void Copy(std::uint32_t from, OctreePage& page, std::uint32_t to, bool isTop) const;

  /** Returns the page that begins with a node, or 0 if none does. */
  std::uint32_t PageOf(std::uint32_t node) const;

  const OctreePage& Whole;
  std::size_t PageBytes;
  std::vector<std::uint64_t> BytesBelow; ///< Bytes below each node, including the node.
  std::vector<std::uint32_t> Roots;      ///< Root of each page.
  std::unordered_map<std::uint32_t, std::uint32_t> Numbers; ///< Page number of each root.
};

}

#endif
