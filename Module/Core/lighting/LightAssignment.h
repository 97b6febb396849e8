#ifndef VITRINE_CORE_LIGHTING_LIGHT_ASSIGNMENT_H
#define VITRINE_CORE_LIGHTING_LIGHT_ASSIGNMENT_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** The lights of all clusters, one list after the other. */
struct LightLists
{
  std::vector<std::uint32_t>
    Offsets; ///< where each cluster's list begins, and where the last one ends
  std::vector<std::uint32_t> Indices; ///< numbers of lights, ascending within a cluster

  std::size_t CountOf(std::uint32_t cluster) const
  {
    return this->Offsets[cluster + 1] - this->Offsets[cluster];
  }
  const std::uint32_t* BeginOf(std::uint32_t cluster) const
  {
    return this->Indices.data() + this->Offsets[cluster];
  }
  const std::uint32_t* EndOf(std::uint32_t cluster) const
  {
    return this->Indices.data() + this->Offsets[cluster + 1];
  }
};

/** What of a light is tested against clusters. */
enum class LightTest
{
  Volume, ///< its ball, or its cone
  Box     ///< the box around it, as the paper does
};

struct AssignmentSettings
{
  LightTest Test = LightTest::Volume;
  unsigned Threads = 2;
};

/**
 * Finds the lights of each cluster. A light is in the list of each cluster that it reaches, and of some that it does not. What that costs grows
 * with the clusters that lights reach.
 * @param used  nonzero for clusters that hold something to be lit; the others' lists are empty
 * @throws std::length_error  where lists hold 2^32 numbers or more together
 */
void Assign(const ClusterGrid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
  const std::vector<std::uint8_t>* used = nullptr, const AssignmentSettings& settings = {});

}

#endif
