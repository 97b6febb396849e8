#ifndef VITRINE_CORE_LIGHTING_WORLD_GRID_H
#define VITRINE_CORE_LIGHTING_WORLD_GRID_H

#include "Core/geometry/Box.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * A fixed grid of boxes in world coordinates (WC), for comparison with a grid that follows the view. It does not change
 * while the camera moves, and its cells have one size near and far. The outermost cells extend to infinity.
 */
class WorldGrid
{
public:
  /**
   * @param bounds    the box to divide. An axis whose length is 0 or not finite gets one cell.
   * @param farthest  the largest distance of points from the origin of the shader's coordinates. It bounds rounding
   *                  errors.
   */
  WorldGrid(const Box& bounds, const glm::ivec3& cells, float farthest = 0.0f);

  int Columns() const { return this->Cells.x; }
  int Rows() const { return this->Cells.y; }
  int Slices() const { return this->Cells.z; }
  std::uint32_t Count() const
  {
    return static_cast<std::uint32_t>(this->Cells.x * this->Cells.y * this->Cells.z);
  }
  std::uint32_t ClusterAt(int column, int row, int slice) const
  {
    return static_cast<std::uint32_t>((slice * this->Cells.y + row) * this->Cells.x + column);
  }

  /**
   * Returns the matrix from which a shader computes the cell of a point (WC). With p the transformed coordinate, the
   * cell on each axis is int(clamp((p + 1) / 2 * cells, 0, cells - 1)).
   */
  glm::dmat4 ToUnit() const;

  int ClusterOf(const glm::dvec3& point) const;

  /** Returns the box of a cell, slightly wider than the cell that a shader computes. */
  Box BoundsOf(std::uint32_t cluster) const;

  /** Marks the cells that a box may touch. An empty box marks nothing. */
  void AddBox(const Box& box, std::vector<std::uint8_t>& marks) const;

private:
  int CellAt(int axis, double coordinate) const;

  glm::ivec3 Cells;
  glm::vec3 Low;
  glm::vec3 PerLength;
  glm::vec3 Slack;
};

/**
 * Returns the numbers of cells on each axis that divide a box into about `count` nearly cubic cells. An axis shorter
 * than a cell gets one cell.
 */
glm::ivec3 CubesIn(const Box& box, std::uint32_t count);

}

#endif
