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
 * Writes a tree into a file of pages: subtrees that are small enough, and the remaining top of the tree. The file is
 * written under another name first, so it is complete or not there. Only machines of the same byte order can read it.
 * @param tree       a tree that is wholly in memory
 * @param pageBytes  largest size of pages in bytes; the top, and leaves that are larger, may exceed it
 * @throws           std::runtime_error if the file cannot be written
 */
void WriteOctreeFile(const Octree& tree, const std::filesystem::path& file, std::size_t pageBytes);

/** A file of WriteOctreeFile(). All that is read is checked, so that no file can lead a walk astray. */
class OctreeFile
{
public:
  /**
   * Opens a file and reads its header.
   * @param itemCount  number of items; a file that refers to more is refused
   * @throws           std::runtime_error if the file is missing, truncated, damaged or something else
   */
  OctreeFile(const std::filesystem::path& file, std::uint32_t itemCount);

  const OctreeCell& Root() const { return this->RootCell; }
  std::uint32_t LeafSize() const { return this->LargestLeaf; }
  const std::vector<std::uint32_t>& Unplaced() const { return this->UnplacedItems; }

  /** Returns the memory use of a page in bytes. */
  std::size_t BytesOf(std::uint32_t page) const;

  /** Returns the number of pages. Page 0 is the top of the tree. */
  std::uint32_t PageCount() const { return static_cast<std::uint32_t>(this->Pages.size()); }

  /**
   * Reads a page. Several threads may call this.
   * @throws  std::runtime_error if the file is truncated or damaged
   */
  OctreePage Read(std::uint32_t page) const;

  /**
   * Returns true if a walk through a page ends and meets only existing nodes, lists and items.
   * @param isTop  true for the top of a tree; only the top may be empty and refer to other pages
   */
  static bool IsSound(
    const OctreePage& page, bool isTop, std::uint32_t itemCount, std::uint32_t pageCount);

  /** The place of a page in the file. */
  struct PagePlace
  {
    std::uint64_t Offset;
    std::uint64_t Checksum; // Checksum of the page's nodes and lists.
    std::uint32_t Nodes;
    std::uint32_t Items; // Numbers in the page's lists, including the rooms of the lists.
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
