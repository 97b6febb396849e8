#ifndef VITRINE_CORE_LIGHTING_USED_CLUSTERS_H
#define VITRINE_CORE_LIGHTING_USED_CLUSTERS_H

#include "Core/lighting/ClusterGrid.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Marks the clusters of a grid that contain something lit. The mark of a cluster is nonzero if it does. */
class UsedClusters
{
public:
  explicit UsedClusters(const ClusterGrid& grid)
    : Grid(grid)
    , Marks(grid.Count(), 0)
  {
  }

  /**
   * Marks the clusters of the pixels of a depth buffer. It also marks neighbouring slices that a shader may find
   * because of rounding.
   * @param depths  window depths of the picture's pixels, row by row. Depths of 1 or more (the background) and NaN mark
   *                nothing.
   * @param width   the width of the picture for which the grid was made
   * @param height  the height of that picture
   */
  void AddDepths(const float* depths, int width, int height);

  /** Marks all clusters. */
  void AddAll();

  /** Marks all clusters that a box in view coordinates (VC) may touch. An empty box marks nothing. */
  void AddBox(const Box& box);

  const std::vector<std::uint8_t>& All() const { return this->Marks; }

  /** Returns the number of marked clusters. */
  std::uint32_t Count() const;

private:
  void AddPart(int slice, const glm::dvec3& low, const glm::dvec3& high);

  const ClusterGrid& Grid;
  std::vector<std::uint8_t> Marks;
};

}

#endif
