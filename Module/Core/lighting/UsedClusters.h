#ifndef VITRINE_CORE_LIGHTING_USED_CLUSTERS_H
#define VITRINE_CORE_LIGHTING_USED_CLUSTERS_H

#include "Core/lighting/ClusterGrid.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Which clusters of a grid hold something to be lit: nonzero for each that does. */
class UsedClusters
{
public:
  explicit UsedClusters(const ClusterGrid& grid)
    : Grid(grid)
    , Marks(grid.Count(), 0)
  {
  }

  /**
   * Marks what a depth buffer shows, and what a shader may take it for whose distances are a little off.
   * @param depths   window depths from 0 to 1 of the picture's pixels, line after line; those of 1 and beyond, the background, and those that are
   *                 no numbers show nothing
   * @param width    of the picture that the grid was made for
   * @param height   likewise
   */
  void AddDepths(const float* depths, int width, int height);

  /** Marks all there are. */
  void AddAll();

  /** Marks all that a box in view coordinates (VC) may touch; nothing if it is empty. */
  void AddBox(const Box& box);

  const std::vector<std::uint8_t>& All() const { return this->Marks; }

  /** How many there are. */
  std::uint32_t Count() const;

private:
  void AddPart(int slice, const glm::dvec3& low, const glm::dvec3& high);

  const ClusterGrid& Grid;
  std::vector<std::uint8_t> Marks;
};

}

#endif
