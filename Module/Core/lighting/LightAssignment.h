#ifndef VITRINE_CORE_LIGHTING_LIGHT_ASSIGNMENT_H
#define VITRINE_CORE_LIGHTING_LIGHT_ASSIGNMENT_H

#include "Core/lighting/BoxScatter.h"
#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightChunk.h"
#include "Core/lighting/LightTree.h"
#include "Core/lighting/LightVolume.h"
#include "Core/lighting/WorldGrid.h"

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

struct AssignmentSettings
{
  LightTest Test = LightTest::Volume;
  unsigned Threads = 2;
};

/**
 * Finds the lights of each cluster. A light is in the list of each cluster that it reaches, and of some that it does not. What that costs grows
 * with the clusters that lights reach. Memory is kept from one time to the next.
 */
class LightAssigner
{
public:
  explicit LightAssigner(const AssignmentSettings& settings = {})
    : Settings(settings)
  {
  }

  /**
   * @param used    nonzero for clusters that hold something to be lit; the others' lists are empty
   * @param marked  the lights to be looked at, if not all: those of a LightTree that may be in view
   * @throws std::length_error  where lists hold 2^32 numbers or more together
   */
  void Assign(const ClusterGrid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
    const std::vector<std::uint8_t>* used = nullptr, const LightMarks* marked = nullptr);

  /** The same with volumes in world coordinates. */
  void Assign(const WorldGrid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
    const std::vector<std::uint8_t>* used = nullptr);

private:
  template <class Scatter>
  void AssignBy(const Scatter& scatter, const std::vector<LightVolume>& volumes, LightLists& lists,
    const std::vector<std::uint8_t>* used);
  void PlaceLists(std::uint32_t clusters, const std::vector<std::uint8_t>* used, LightLists& lists);

  AssignmentSettings Settings;
  std::vector<LightChunk> Chunks;
};

/** The same once. */
template <class Grid>
void Assign(const Grid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
  const std::vector<std::uint8_t>* used = nullptr, const AssignmentSettings& settings = {})
{
  LightAssigner(settings).Assign(grid, volumes, lists, used);
}

}

#endif
