#ifndef VITRINE_CORE_LIGHTING_LIGHT_FILTER_H
#define VITRINE_CORE_LIGHTING_LIGHT_FILTER_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightVolume.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace vitrine
{

/** Rejects lights that certainly reach nothing of a grid, because their balls lie outside one of its outer planes. */
class LightFilter
{
public:
  static constexpr std::size_t BlockSize = 64;

  explicit LightFilter(const ClusterGrid& grid)
    : Sides(grid.OuterSides())
  {
  }

  /**
   * Returns one bit for each of up to BlockSize lights. It is set if the light may reach the grid. The first light has
   * the lowest bit.
   */
  std::uint64_t MayReach(const LightVolume* volumes, std::size_t count) const;

private:
  std::array<glm::vec4, 5> Sides;
};

}

#endif
