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
 * A fixed grid of boxes in world coordinates (WC), for comparison with one that follows the view: it stays as it is while the camera moves, and its
 * cells are as large near the eye as far from it. The outermost cells go on to infinity.
 */
class WorldGrid
{
public:
  /**
   * @param bounds    what has no length on an axis, or no finite one, has one cell there
   * @param farthest  that places are from the origin of the coordinates in which a shader has them
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

  /** What a shader needs to find a point's cell: with its matrix on each axis int(clamp((p + 1) / 2 * cells, 0, cells - 1)). */
  glm::dmat4 ToUnit() const;

  int ClusterOf(const glm::dvec3& point) const;

  /** A cell, a little wider than a shader finds it. */
  Box BoundsOf(std::uint32_t cluster) const;

  /** Marks the cells that a box may touch; nothing if it is empty. */
  void AddBox(const Box& box, std::vector<std::uint8_t>& marks) const;

private:
  int CellAt(int axis, double coordinate) const;

  glm::ivec3 Cells;
  glm::vec3 Low;
  glm::vec3 PerLength;
  glm::vec3 Slack;
};

/** How many cells make about `count` of a box altogether, which are as good as cubes; where it is flatter than they are, there is one. */
glm::ivec3 CubesIn(const Box& box, std::uint32_t count);

}

#endif
