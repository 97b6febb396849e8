/**
 * Finds the clusters of lights by boxes, for comparison with LightScatter.h and for world grids.
 */
#ifndef VITRINE_CORE_LIGHTING_BOX_SCATTER_H
#define VITRINE_CORE_LIGHTING_BOX_SCATTER_H

#include "Core/geometry/Box.h"
#include "Core/lighting/ClusterRuns.h"
#include "Core/lighting/LightVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** The shape of a light that is tested against clusters. */
enum class LightTest
{
  Volume, ///< the light's ball or cone
  Box     ///< the bounding box of the light, as in the clustered shading paper (Olsson et al. 2012)
};

/**
 * Finds the box-shaped cells that a light reaches. It descends from slices to rows to cells by their bounding boxes.
 */
class BoxScatter
{
public:
  /** @param grid  a ClusterGrid, whose clusters are replaced by their bounding boxes, or a WorldGrid */
  template <class Grid>
  BoxScatter(const Grid& grid, LightTest test)
    : Test(test)
    , Columns(grid.Columns())
    , Rows(grid.Rows())
    , Slices(grid.Slices())
  {
    for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
    {
      this->Cells.push_back(grid.BoundsOf(cluster));
    }
    this->JoinCells();
  }

  std::uint32_t Count() const { return static_cast<std::uint32_t>(this->Cells.size()); }

  /** Appends the cells that lights `first` to `last` - 1 reach to `runs`. */
  void Append(const std::vector<LightVolume>& volumes, std::size_t first, std::size_t last,
    ClusterRuns& runs) const;

private:
  void JoinCells();
  void AppendLight(std::uint32_t light, const LightShape& shape, ClusterRuns& runs) const;
  bool MayTouch(const LightShape& shape, const Box& cell) const;

  LightTest Test;
  int Columns;
  int Rows;
  int Slices;
  std::vector<Box> Cells;
  std::vector<Box> RowBoxes;   ///< bounds of each row of each slice
  std::vector<Box> SliceBoxes; ///< bounds of each slice
};

}

#endif
