#ifndef VITRINE_CORE_LIGHTING_WORLD_GRID_H
#define VITRINE_CORE_LIGHTING_WORLD_GRID_H

#include "Core/culling/Box.h"

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
  /** @param bounds  finite; what has no length on an axis has one cell there */
  WorldGrid(const Box& bounds, const glm::ivec3& cells);

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

  /** What a shader needs to find a point's cell: on each axis int(clamp((p - Origin) * Scale, 0, cells - 1)). */
  glm::vec3 Origin() const { return this->Low; }
  glm::vec3 Scale() const { return this->PerLength; }

  int ClusterOf(const glm::dvec3& point) const;

  /** A cell, a little wider than a shader finds it. */
  Box BoundsOf(std::uint32_t cluster) const;

private:
  glm::ivec3 Cells;
  glm::vec3 Low;
  glm::vec3 PerLength;
  glm::vec3 Slack;
};

}

#endif
