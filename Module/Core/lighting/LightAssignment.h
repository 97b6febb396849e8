/**
 * Assigns lights to clusters. The result is one list of lights for each cluster, in two arrays:
 *
 *   cluster = (slice * Rows + row) * Columns + column
 *
 *               0   1   2   3          Count()
 *   Offsets   [ 0 | 2 | 2 | 5 | ... | N ]        prefix sum of the lists' lengths
 *               |   |   |   |
 *               |   +-+-+   +---+                cluster 1 has no lights
 *               v     v         v
 *   Indices   [ 3 7 | 0 3 9 | 4 ...     ]        N light numbers, ascending within a list
 *                 |
 *                 v
 *   lights    [ ... | 7 | ... ]                  the caller's array of LightVolume
 */
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

/** The lists of lights of all clusters, one after the other. */
struct LightLists
{
  /** The start of each cluster's list, and the end of the last one. */
  std::vector<std::uint32_t> Offsets;
  /** Numbers of lights, ascending within a cluster. */
  std::vector<std::uint32_t> Indices;

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
 * Finds the lights of each cluster. The lists are conservative: a light is in the list of each cluster that it reaches,
 * and of some that it does not reach. The cost grows with the number of clusters that lights reach. Memory is kept
 * between calls.
 */
class LightAssigner
{
public:
  explicit LightAssigner(const AssignmentSettings& settings = {})
    : Settings(settings)
  {
  }

  /**
   * @param volumes  lights in view coordinates (VC)
   * @param used     nonzero for each cluster that contains something lit; the other clusters get empty lists. Null
   *                 means all.
   * @param marked   the lights to consider, such as those that a LightTree finds in the view. Null means all. It has no
   *                 effect for LightTest::Box.
   * @throws std::length_error  if the lists have 2^32 entries or more in total
   */
  void Assign(const ClusterGrid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
    const std::vector<std::uint8_t>* used = nullptr, const LightMarks* marked = nullptr);

  /** Assigns lights whose volumes are in world coordinates (WC). */
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

/** Assigns lights by a temporary LightAssigner. */
template <class Grid>
void Assign(const Grid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
  const std::vector<std::uint8_t>* used = nullptr, const AssignmentSettings& settings = {})
{
  LightAssigner(settings).Assign(grid, volumes, lists, used);
}

}

#endif
