/** The triangles of a part's geometry, and its levels of detail. */
#ifndef VITRINE_ASSEMBLY_PART_DETAIL_H
#define VITRINE_ASSEMBLY_PART_DETAIL_H

#include "Core/levels/MeshLevels.h"
#include "Core/levels/MeshSpeck.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <unordered_map>
#include <vector>

class vtkPolyData;

namespace vitrine
{

class CadCache;

/** The triangles of a geometry, all and fewer. Their corners are numbers of its points. */
struct PartDetail
{
  std::vector<std::uint32_t> Whole; ///< three for each triangle
  std::vector<MeshLevel> Levels;
  std::vector<double> Shares; ///< the area of each level, as a share of that of all triangles
  std::optional<MeshSpeck> Speck;
};

/** Returns true if a geometry is drawn by triangles alone: it has polygons or strips, but no lines or vertices. */
bool HasTrianglesAlone(vtkPolyData* geometry);

/** Returns the triangles of a mesh with its levels, or null if the mesh is not usable. */
std::shared_ptr<const PartDetail> MakePartDetail(
  const DetailedMesh& mesh, std::vector<MeshLevel> levels, const std::atomic<bool>& isStopped);

/** Reads the triangles of a geometry, with normals and colours at its points. */
DetailedMesh DetailedMeshOf(vtkPolyData* geometry);

/**
 * Makes levels of geometries in a thread of its own. They must not change meanwhile. Levels that take a second or more
 * are kept in the cache, vitrine/levels of the system's folder for caches, and taken from there the next time.
 */
class DetailWork
{
public:
  using Geometries = std::vector<vtkSmartPointer<vtkPolyData>>;

  /** Begins at once. */
  DetailWork(Geometries geometries, bool useCache);

  /** Stops the work. */
  ~DetailWork();

  DetailWork(const DetailWork&) = delete;
  DetailWork& operator=(const DetailWork&) = delete;

  std::size_t CountOfDone() const { return this->Done; }
  std::size_t Count() const { return this->Work.size(); }
  bool IsDone() const { return this->CountOfDone() == this->Count(); }
  void Wait();

  /**
   * Returns what was made of a geometry, or null if it was not given, is not usable, or has changed since. Only if
   * IsDone().
   */
  std::shared_ptr<const PartDetail> Of(vtkPolyData* geometry) const;

  /** Returns when a geometry changed last. */
  vtkMTimeType TimeOfChange() const;

private:
  void Run();
  void MakeByCache(const CadCache& cache);
  void Make();

  Geometries Work;
  bool UseCache;
  std::vector<std::shared_ptr<const PartDetail>> Made;
  std::unordered_map<vtkPolyData*, std::size_t> PlaceOf;
  std::vector<vtkMTimeType> Times; ///< when each geometry had changed last
  std::atomic<std::size_t> Done{ 0 };
  std::atomic<bool> IsStopped{ false };
  std::thread Thread;
};

}

#endif
