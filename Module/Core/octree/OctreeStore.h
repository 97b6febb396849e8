#ifndef VITRINE_CORE_OCTREE_OCTREE_STORE_H
#define VITRINE_CORE_OCTREE_OCTREE_STORE_H

#include "Core/octree/OctreeFile.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace vitrine
{

/**
 * Octrees whose subtrees are on disk. A page is read when a walk first enters it. If the pages in memory would exceed a
 * budget, the least recently used are dropped. The tree gives the same results as the one that was written. Items'
 * boxes are not stored; they may come from arrays that are memory-mapped files.
 */
class OctreeStore : public OctreePages
{
public:
  static constexpr std::size_t DefaultPageBytes = 256 * 1024;

  /**
   * Writes a tree, which must be wholly in memory, into an existing folder.
   * @throws  std::runtime_error if it cannot be written
   */
  static void Write(const Octree& tree, const std::filesystem::path& folder,
    std::size_t pageBytes = DefaultPageBytes);

  /**
   * Opens the tree that was written into a folder.
   * @param budget     bytes of memory for pages, without the top, which stays; a page that a walk is in stays until the
   *                   walk leaves it
   * @param itemCount  current number of items; a tree that refers to more is refused
   * @throws           std::runtime_error if there is no tree, or it is truncated or damaged
   */
  static Octree Open(
    const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount);

  OctreeStore(const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount);

  /** Returns the tree of a store. The tree keeps the store alive. */
  static Octree TreeOf(const std::shared_ptr<OctreeStore>& store);

  std::shared_ptr<const OctreePage> Load(std::uint32_t page) override;

  /** Returns the bytes of the pages in memory, without the top. */
  std::size_t ResidentBytes() const;

  /** Returns the number of pages read so far, without the top. */
  std::uint64_t ReadCount() const;

  /** Returns the bytes of all pages, without the top. */
  std::size_t TotalBytes() const;

private:
  struct Resident
  {
    std::uint32_t Page;
    std::shared_ptr<const OctreePage> Content;
  };
  void MakeRoomFor(std::size_t bytes);

  OctreeFile File;
  std::size_t Budget;
  mutable std::mutex Access;
  std::list<Resident> Residents; // The most recently used page is first.
  std::unordered_map<std::uint32_t, std::list<Resident>::iterator> ByPage;
  std::size_t Bytes = 0;
  std::uint64_t Reads = 0;
};

}

#endif
