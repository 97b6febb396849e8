#ifndef VITRINE_CORE_MEASURE_MESH_STORE_H
#define VITRINE_CORE_MEASURE_MESH_STORE_H

#include "Core/measure/PartMesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

namespace vitrine
{

/**
 * A file in the folder for temporary files. Where the system can, it has no name, and goes with the process. Elsewhere
 * it goes with this.
 */
class ScratchFile
{
public:
  /** @throws  std::runtime_error if there can be none */
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /**
   * Writes at the end, and returns where that is.
   * @throws  std::runtime_error if the disk is full, for example; what was written before stays
   */
  std::uint64_t Append(const void* data, std::size_t bytes);

  /**
   * Reads what was written.
   * @throws  std::runtime_error if it cannot be read
   */
  void Read(std::uint64_t place, void* data, std::size_t bytes);

private:
  std::filesystem::path Path;
  std::fstream Stream;
  std::uint64_t Size = 0;
};

/**
 * Meshes within a budget of memory. If all need more, each is written to a file, and read again when it is asked for.
 * The least recently used ones are dropped then. A mesh that somebody holds stays until he lets it go. Octrees and all
 * else that a mesh makes when it is asked is made again.
 */
class MeshStore
{
public:
  static constexpr std::size_t Unlimited = std::numeric_limits<std::size_t>::max();

  /**
   * Sets how many bytes meshes may take, Unlimited at first.
   * @throws  std::runtime_error if they have to be written and cannot be; the budget stays as it was then
   */
  void SetBudget(std::size_t bytes);

  /**
   * Keeps a mesh, and returns its number.
   * @throws  std::runtime_error if meshes have to be written and cannot be; this one is not kept then
   */
  std::uint32_t Keep(std::shared_ptr<const PartMesh> mesh);

  /**
   * Returns the mesh of a number. May be called in several threads.
   * @throws  std::runtime_error if it cannot be read
   */
  std::shared_ptr<const PartMesh> Load(std::uint32_t mesh) const;

  /** Returns how many bytes a mesh counts for: its arrays, and about what its octree takes. */
  static std::size_t BytesOf(const PartMesh& mesh);

  /** Returns the bytes of the meshes in memory. */
  std::size_t ResidentBytes() const;

  /** Returns how many meshes were read so far. */
  std::uint64_t ReadCount() const;

private:
  struct Slot
  {
    std::shared_ptr<const PartMesh> Mesh; ///< null if it is on disk alone
    std::size_t Bytes = 0;
    std::uint64_t Place = 0;
    std::size_t PointCount = 0;
    std::size_t TriangleCount = 0;
    std::list<std::uint32_t>::iterator InUse; ///< if it is in memory
  };

  void BeginFile();
  static std::uint64_t Write(const PartMesh& mesh, ScratchFile& file);
  std::shared_ptr<const PartMesh> ReadMesh(const Slot& slot) const;
  void DropUnused() const;

  std::size_t Budget = Unlimited;
  std::size_t TotalBytes = 0;
  std::unique_ptr<ScratchFile> File; ///< has all meshes; null as long as they fit
  mutable std::mutex Access;
  mutable std::vector<Slot> Slots;
  mutable std::list<std::uint32_t> Residents; ///< the most recently used one is first
  mutable std::size_t Bytes = 0;
  mutable std::uint64_t Reads = 0;
};

}

#endif
