#ifndef VITRINE_EXAMPLES_BENCHMARK_MESHES_H
#define VITRINE_EXAMPLES_BENCHMARK_MESHES_H

#include "Core/octree/TriangleBoxes.h"

#include <cstdint>
#include <vector>

/** A mesh of about `triangleCount` triangles. It is the same on every machine. */
struct BenchmarkMesh
{
  enum class Kinds
  {
    Spheres,  ///< Sixteen overlapping spheres, row by row, as tessellators write them.
    Shuffled, ///< The same spheres with triangles in random order.
    Soup      ///< Small triangles without neighbours, scattered in a cube in random order.
  };

  BenchmarkMesh(Kinds kind, std::uint32_t triangleCount);

  vitrine::TriangleBoxes<float, std::uint32_t> View() const
  {
    return { this->Points.data(), this->Corners.data(),
      static_cast<std::uint32_t>(this->Corners.size() / 3) };
  }

  std::vector<float> Points;
  std::vector<std::uint32_t> Corners;
};

#endif
