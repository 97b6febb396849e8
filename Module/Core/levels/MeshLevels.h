#ifndef VITRINE_CORE_LEVELS_MESH_LEVELS_H
#define VITRINE_CORE_LEVELS_MESH_LEVELS_H

#include "Core/levels/WeldedMesh.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A mesh of fewer triangles, of the same points. */
struct MeshLevel
{
  std::vector<std::uint32_t> Corners; ///< three numbers of points of the mesh for each triangle
  /**
   * The Hausdorff distance to the mesh is at most this, in units of the mesh: each point of either surface has a point
   * of the other at most so far away.
   */
  double Bound = 0.0;
};

/** The levels of detail of a mesh. */
struct MeshLevels
{
  std::vector<MeshLevel> Levels; ///< the finest first; each has fewer triangles and a greater bound
  std::size_t Unfit =
    0; ///< triangles of the mesh that are kept in all levels, as they fit no manifold
};

/** What stops no work. */
inline const std::atomic<bool> NeverStopped{ false };

/**
 * Makes levels of detail of a mesh. Each has about a quarter of the triangles of the one before. A mesh that is not
 * usable has none. All levels are there only if it was not stopped meanwhile.
 *
 * The bound of a level is that of the level before plus that of the distances of both, which BoundOfDistance()
 * computes.
 */
MeshLevels LevelsOf(const DetailedMesh& mesh, const std::atomic<bool>& isStopped = NeverStopped);

/** Returns the place of the coarsest level whose bound is at most a length, or -1 if only the mesh itself is. */
int CoarsestWithin(const std::vector<MeshLevel>& levels, double length);

}

#endif
