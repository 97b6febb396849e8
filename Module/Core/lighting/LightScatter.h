#ifndef VITRINE_CORE_LIGHTING_LIGHT_SCATTER_H
#define VITRINE_CORE_LIGHTING_LIGHT_SCATTER_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/ClusterRuns.h"
#include "Core/lighting/LightVolume.h"

namespace vitrine
{

/** What is left of a ball within some planes: it lies in this ball. */
struct BallPart
{
  glm::vec3 Centre;
  float Radius;
  float Square; ///< of the radius

  /** Leaves what is within one more plane; whether there is any. */
  bool CutBy(const glm::vec4& plane);
};

/**
 * Finds the clusters that a light reaches: slices, in each of them rows, in each of them columns, where each time only that part of the ball is left
 * which may be there (E. Persson: Practical clustered shading, SIGGRAPH 2013). What that costs grows with what is found.
 */
class LightScatter
{
public:
  explicit LightScatter(const ClusterGrid& grid)
    : Grid(grid)
  {
  }

  void Append(std::uint32_t light, const LightVolume& volume, ClusterRuns& runs) const;

private:
  struct Range
  {
    int First;
    int Last; ///< one less than the first where there are none
  };

  void AppendSlices(std::uint32_t light, const LightShape& shape, ClusterRuns& runs) const;
  void AppendRows(std::uint32_t light, const LightShape& shape, int slice, const BallPart& part,
    ClusterRuns& runs) const;
  void AppendColumns(std::uint32_t light, const LightShape& shape, int slice, int row,
    const BallPart& part, ClusterRuns& runs) const;
  void AppendCone(std::uint32_t light, const LightShape& shape, int slice, int row, Range columns,
    ClusterRuns& runs) const;
  Range RowsOf(const BallPart& part) const;
  Range ColumnsOf(const BallPart& part) const;

  const ClusterGrid& Grid;
};

}

#endif
