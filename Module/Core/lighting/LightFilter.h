#ifndef VITRINE_CORE_LIGHTING_LIGHT_FILTER_H
#define VITRINE_CORE_LIGHTING_LIGHT_FILTER_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightVolume.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace vitrine
{

/** Tells quickly which lights surely reach nothing of a grid: those whose balls lie on the outer side of one of its sides. */
class LightFilter
{
public:
  static constexpr std::size_t BlockSize = 64;

  explicit LightFilter(const ClusterGrid& grid)
    : Sides(grid.OuterSides())
  {
  }

  /** A bit for each of up to BlockSize lights that may reach something, the first one the lowest. */
  std::uint64_t MayReach(const LightVolume* volumes, std::size_t count) const;

private:
  std::array<glm::vec4, 5> Sides;
};

}

#endif
