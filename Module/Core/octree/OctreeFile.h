#ifndef VITRINE_CORE_OCTREE_OCTREE_FILE_H
#define VITRINE_CORE_OCTREE_OCTREE_FILE_H

#include "Core/octree/Octree.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <vector>

namespace vitrine
{

/**
 * Writes a tree into a file of its own, as pages: subtrees cut off where they are small enough, and the top of the tree,
 * which holds what remains. The file is complete or not there: it is written beside itself first. It is read by
 * machines of the same byte order.
 *
 * @param tree       one that is wholly in memory
 * @param pageBytes  how large the pages are at most, the top and leaves larger than that aside
 * @throws std::runtime_error if the file cannot be written
 */
void WriteOctreeFile(const Octree& tree, const std::filesystem::path& file, std::size_t pageBytes);

/** A file of WriteOctreeFile(). What is read from it is checked, so that no file makes a walk go astray. */
class OctreeFile
{
public:
  /**
   * @param itemCount  how many items there are; a file that knows of more is refused
   * @throws std::runtime_error if the file is missing, truncated, damaged or something else
   */
  OctreeFile(const std::filesystem::path& file, std::uint32_t itemCount);

  const OctreeCell& Root() const { return this->RootCell; }
  std::uint32_t LeafSize() const { return this->LargestLeaf; }
  const std::vector<std::uint32_t>& Unplaced() const { return this->UnplacedItems; }

  /** Memory that a page takes. */
  std::size_t BytesOf(std::uint32_t page) const;

  /** Pages there are; page 0 is the top of the tree. */
  std::uint32_t PageCount() const { return static_cast<std::uint32_t>(this->Pages.size()); }

  /** Safe to be called by several threads. @throws std::runtime_error if the file is truncated or damaged */
  OctreePage Read(std::uint32_t page) const;

  /**
   * Whether a walk through a page comes to an end and finds only nodes, lists and items that are there.
   * @param isTop  whether it is the top of a tree, which alone may be empty and may stand on other pages
   */
  static bool IsSound(
    const OctreePage& page, bool isTop, std::uint32_t itemCount, std::uint32_t pageCount);

  /** Where a page lies in the file. */
  struct PagePlace
  {
    std::uint64_t Offset;
    std::uint64_t Checksum; // of its nodes and lists
    std::uint32_t Nodes;
    std::uint32_t Items; // numbers in its lists, the rooms of the lists among them
  };

private:
  std::filesystem::path Path;
  std::uint32_t ItemCount;
  mutable std::mutex Access;
  mutable std::ifstream Stream;
  OctreeCell RootCell;
  std::uint32_t LargestLeaf = 0;
  std::vector<std::uint32_t> UnplacedItems;
  std::vector<PagePlace> Pages;
};

}

#endif
