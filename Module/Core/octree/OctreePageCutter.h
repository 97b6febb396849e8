#ifndef VITRINE_CORE_OCTREE_OCTREE_PAGE_CUTTER_H
#define VITRINE_CORE_OCTREE_OCTREE_PAGE_CUTTER_H

#include "Core/octree/OctreePage.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vitrine
{

/** Takes a tree apart into pages for a file: the first has the nodes above all others' roots. */
class OctreePageCutter
{
public:
  /**
   * @param whole      the nodes and lists of the tree, all in memory; must outlive the cutter
   * @param pageBytes  that no page but the first exceeds, unless a leaf alone does
   */
  OctreePageCutter(const OctreePage& whole, std::size_t pageBytes);

  std::uint32_t PageCount() const { return static_cast<std::uint32_t>(this->Roots.size()); }

  OctreePage Page(std::uint32_t number) const;

private:
  std::uint64_t Measure(std::uint32_t number);
  void Cut(std::uint32_t number);
  void Copy(std::uint32_t from, OctreePage& page, std::uint32_t to, bool isTop) const;

  /** The page that begins with a node, 0 if none does. */
  std::uint32_t PageOf(std::uint32_t node) const;

  const OctreePage& Whole;
  std::size_t PageBytes;
  std::vector<std::uint64_t> BytesBelow;                    ///< by node, itself included
  std::vector<std::uint32_t> Roots;                         ///< by page
  std::unordered_map<std::uint32_t, std::uint32_t> Numbers; ///< of the pages, by root
};

}

#endif
