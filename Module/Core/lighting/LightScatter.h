#ifndef VITRINE_CORE_LIGHTING_LIGHT_SCATTER_H
#define VITRINE_CORE_LIGHTING_LIGHT_SCATTER_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/ClusterRuns.h"
#include "Core/lighting/LightFilter.h"
#include "Core/lighting/LightTree.h"
#include "Core/lighting/LightVolume.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace vitrine
{

/**
 * Finds the clusters that a light reaches: slices, in each of them rows, in each of them columns, where each time only that part of the ball is left
 * which may be there (E. Persson: Practical clustered shading, SIGGRAPH 2013). What that costs grows with what is found.
 */
class LightScatter
{
public:
  /** @param marks  the lights to be looked at; none are left out where there are no marks */
  explicit LightScatter(const ClusterGrid& grid, const LightMarks* marks = nullptr)
    : Grid(grid)
    , Filter(grid)
    , Marks(marks)
  {
  }

  std::uint32_t Count() const { return this->Grid.Count(); }

  /** Appends what lights `first`, a multiple of 64, to `last` - 1 reach. */
  void Append(const std::vector<LightVolume>& volumes, std::size_t first, std::size_t last,
    ClusterRuns& runs) const;

private:
  struct Range
  {
    int First;
    int Last; ///< one less than the first where there are none
  };

  void AppendLight(std::uint32_t light, const LightVolume& volume, ClusterRuns& runs) const;
  void AppendSlices(std::uint32_t light, const LightShape& shape, ClusterRuns& runs) const;
  void AppendRows(std::uint32_t light, const LightShape& shape, int slice, const BallPart& part,
    ClusterRuns& runs) const;
  void AppendColumns(std::uint32_t light, const LightShape& shape, int slice, int row,
    const BallPart& part, ClusterRuns& runs) const;
  void AppendCone(std::uint32_t light, const LightShape& shape, int slice, int row, Range columns,
    ClusterRuns& runs) const;
  Range RowsOf(const BallPart& part) const;
  Range ColumnsOf(const BallPart& part) const;

  /** Around a cluster's corners: centre and radius. */
  const glm::vec4& BallAround(std::uint32_t cluster) const;

  const ClusterGrid& Grid;
  const LightFilter Filter;
  const LightMarks* const Marks;
  mutable std::once_flag HasBalls;
  mutable std::vector<glm::vec4> Balls; ///< of all clusters, once a cone asks for one
};

}

#endif
