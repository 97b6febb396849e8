#ifndef VITRINE_CORE_LEVELS_MESH_REDUCTION_H
#define VITRINE_CORE_LEVELS_MESH_REDUCTION_H

#include "Core/levels/WeldedMesh.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * Makes a mesh coarser, step by step, by moving vertices onto neighbours. OpenMesh's decimater chooses them by quadrics
 * of the surface's planes, and of planes through open and hard edges. (M. Garland, P. S. Heckbert: Surface
 * simplification using quadric error metrics, SIGGRAPH 1997)
 *
 * Points are never moved: what is left is some of the mesh's points. A vertex of an open or a hard edge moves along
 * that edge alone, and one where three such edges meet stays. One whose neighbours have another colour stays. No
 * triangle turns by more than 75 degrees in a step.
 *
 * OpenMesh knows manifolds only. A triangle that does not fit, as the third one of an edge, is kept as it is, and so
 * are the vertices where it is.
 */
class MeshReduction
{
public:
  explicit MeshReduction(const WeldedMesh& mesh);
  ~MeshReduction();
  MeshReduction(const MeshReduction&) = delete;
  MeshReduction& operator=(const MeshReduction&) = delete;

  /** Goes on until there are at most so many triangles, no vertex can move, or it is stopped. */
  void ReduceTo(std::size_t triangles, const std::atomic<bool>& isStopped);

  /** Returns the triangles that are left: three numbers of points for each. */
  std::vector<std::uint32_t> Triangles() const;

  /** Returns the number of triangles of the mesh that did not fit. */
  std::size_t CountOfUnfit() const;

private:
  class Work;
  std::unique_ptr<Work> Mesh;
};

}

#endif
