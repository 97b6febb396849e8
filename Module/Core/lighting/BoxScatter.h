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

/** What of a light is tested against clusters. */
enum class LightTest
{
  Volume, ///< its ball, or its cone
  Box     ///< the box around it, as the paper does
};

/** Finds which cells a light reaches that are boxes: slices by their boxes, in them rows, in them cells. */
class BoxScatter
{
public:
  /** Of a ClusterGrid, by its clusters' boxes, or of a WorldGrid. */
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

  /** Appends what lights `first` to `last` - 1 reach. */
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
  std::vector<Box> RowBoxes;   ///< around the cells of each row of each slice
  std::vector<Box> SliceBoxes; ///< around the rows of each slice
};

}

#endif
