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
 * Finds the clusters that a light reaches: slices, then rows of each slice, then columns of each row. At each step the
 * ball is reduced to the part that can lie there (E. Persson: Practical clustered shading, SIGGRAPH 2013). The cost
 * grows with the number of clusters found.
 */
class LightScatter
{
public:
  /** @param marks  the lights to consider; null means all */
  explicit LightScatter(const ClusterGrid& grid, const LightMarks* marks = nullptr)
    : Grid(grid)
    , Filter(grid)
    , Marks(marks)
  {
  }

  std::uint32_t Count() const { return this->Grid.Count(); }

  /** Appends the clusters that lights `first` to `last` - 1 reach to `runs`. `first` is a multiple of 64. */
  void Append(const std::vector<LightVolume>& volumes, std::size_t first, std::size_t last,
    ClusterRuns& runs) const;

private:
  struct Range
  {
    int First;
    int Last; ///< First - 1 if the range is empty
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

  /** Returns the bounding ball of a cluster: centre (VC) and radius. */
  const glm::vec4& BallAround(std::uint32_t cluster) const;

  const ClusterGrid& Grid;
  const LightFilter Filter;
  const LightMarks* const Marks;
  mutable std::once_flag HasBalls;
  mutable std::vector<glm::vec4> Balls; ///< by cluster; computed when the first cone is tested
};

}

#endif
