#include "Core/lighting/WorldGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::infinity();

/** By how much cells are wider, as a share of the largest coordinate. */
constexpr float WorldSlack = 1e-5f;
}

WorldGrid::WorldGrid(const Box& bounds, const glm::ivec3& cells)
  : Cells(1)
  , Low(bounds.Min)
  , PerLength(0.0f)
  , Slack(0.0f)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const float length = bounds.Max[axis] - bounds.Min[axis];
    const int count = std::max(cells[axis], 1);
    if (length > 0.0f && std::isfinite(length) && std::isfinite(count / length))
    {
      this->Cells[axis] = count;
      this->PerLength[axis] = count / length;
      this->Slack[axis] =
        WorldSlack * std::max(std::abs(bounds.Min[axis]), std::abs(bounds.Max[axis]));
    }
  }
}

int WorldGrid::ClusterOf(const glm::dvec3& point) const
{
  glm::ivec3 cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = (point[axis] - this->Low[axis]) * this->PerLength[axis];
    cell[axis] = static_cast<int>(std::min(std::max(0.0, place), this->Cells[axis] - 1.0));
  }
  return static_cast<int>(this->ClusterAt(cell.x, cell.y, cell.z));
}

Box WorldGrid::BoundsOf(std::uint32_t cluster) const
{
  const int number = static_cast<int>(cluster);
  const glm::ivec3 cell(number % this->Cells.x, number / this->Cells.x % this->Cells.y,
    number / this->Cells.x / this->Cells.y);
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isFirst = cell[axis] == 0, isLast = cell[axis] == this->Cells[axis] - 1;
    const float at = static_cast<float>(cell[axis]) / this->PerLength[axis];
    const float end = static_cast<float>(cell[axis] + 1) / this->PerLength[axis];
    box.Min[axis] = isFirst ? -Endless : this->Low[axis] + at - this->Slack[axis];
    box.Max[axis] = isLast ? Endless : this->Low[axis] + end + this->Slack[axis];
  }
  return box;
}

}
