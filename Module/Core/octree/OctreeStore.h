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
 * Octrees whose subtrees are on disk. A page is read when a walk first enters it; where the pages in memory would exceed a
 * budget, those that were not needed for longest are dropped. The tree gives the same answers as the one that was
 * written. Items' boxes are not stored: they are asked for as ever, say of arrays that are files mapped into memory.
 */
class OctreeStore : public OctreePages
{
public:
  static constexpr std::size_t DefaultPageBytes = 256 * 1024;

  /**
   * Writes a tree, which is wholly in memory, into a folder that exists.
   * @throws std::runtime_error if it cannot be written
   */
  static void Write(const Octree& tree, const std::filesystem::path& folder,
    std::size_t pageBytes = DefaultPageBytes);

  /**
   * The tree that was written into a folder.
   *
   * @param budget     bytes that pages may take in memory, its top aside, which stays. A page that a walk is in stays until
   *                   the walk leaves it.
   * @param itemCount  how many items there are now; a tree that knows of more is refused
   * @throws std::runtime_error if there is none, or it is truncated or damaged
   */
  static Octree Open(
    const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount);

  OctreeStore(const std::filesystem::path& folder, std::size_t budget, std::uint32_t itemCount);

  /** The tree of a store, which it keeps alive. */
  static Octree TreeOf(const std::shared_ptr<OctreeStore>& store);

  std::shared_ptr<const OctreePage> Load(std::uint32_t page) override;

  /** Bytes of the pages that are in memory, the top aside. */
  std::size_t ResidentBytes() const;

  /** Pages read so far, the top aside. */
  std::uint64_t ReadCount() const;

  /** Bytes of all pages, the top aside. */
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
  std::list<Resident> Residents; // the one needed last is the first
  std::unordered_map<std::uint32_t, std::list<Resident>::iterator> ByPage;
  std::size_t Bytes = 0;
  std::uint64_t Reads = 0;
};

}

#endif
