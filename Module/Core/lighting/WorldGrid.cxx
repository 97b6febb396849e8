#include "Core/lighting/WorldGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::infinity();

/** Widening of cells, as a share of the largest coordinate. It is ten times the error of a shader's floats. */
constexpr float WorldSlack = 1e-5f;
}

WorldGrid::WorldGrid(const Box& bounds, const glm::ivec3& cells, float farthest)
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
        WorldSlack * std::max({ std::abs(bounds.Min[axis]), std::abs(bounds.Max[axis]), farthest });
    }
  }
}

glm::dmat4 WorldGrid::ToUnit() const
{
  glm::dmat4 matrix(0.0);
  matrix[3].w = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double scale = 2.0 * this->PerLength[axis] / this->Cells[axis];
    matrix[axis][axis] = scale;
    matrix[3][axis] = scale > 0.0 ? -scale * this->Low[axis] - 1.0 : 0.0;
  }
  return matrix;
}

int WorldGrid::CellAt(int axis, double coordinate) const
{
  const double place = (coordinate - this->Low[axis]) * this->PerLength[axis];
  return static_cast<int>(std::min(std::max(0.0, place), this->Cells[axis] - 1.0));
}

int WorldGrid::ClusterOf(const glm::dvec3& point) const
{
  return static_cast<int>(
    this->ClusterAt(this->CellAt(0, point.x), this->CellAt(1, point.y), this->CellAt(2, point.z)));
}

void WorldGrid::AddBox(const Box& box, std::vector<std::uint8_t>& marks) const
{
  if (box.IsEmpty())
  {
    return;
  }
  glm::ivec3 first, last;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = this->CellAt(axis, box.Min[axis] - this->Slack[axis]);
    last[axis] = this->CellAt(axis, box.Max[axis] + this->Slack[axis]);
  }
  for (int slice = first.z; slice <= last.z; ++slice)
  {
    for (int row = first.y; row <= last.y; ++row)
    {
      const auto begin = marks.begin() + this->ClusterAt(0, row, slice);
      std::fill(begin + first.x, begin + last.x + 1, std::uint8_t{ 1 });
    }
  }
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

glm::ivec3 CubesIn(const Box& box, std::uint32_t count)
{
  const glm::dvec3 lengths = glm::dvec3(box.Max) - glm::dvec3(box.Min);
  glm::ivec3 cells(1);
  double edge = 0.0;
  // If an axis is shorter than an edge, the other axes share its cells and the edges get longer.
  for (int round = 0; round < 3; ++round)
  {
    double content = 1.0;
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isLong = lengths[axis] > edge && std::isfinite(lengths[axis]);
      content *= isLong ? lengths[axis] : 1.0;
      axes += isLong ? 1 : 0;
    }
    edge = axes > 0 ? std::pow(content / count, 1.0 / axes) : Endless;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (lengths[axis] > edge && std::isfinite(lengths[axis]))
    {
      cells[axis] = static_cast<int>(std::min<double>(std::round(lengths[axis] / edge), count));
    }
  }
  return cells;
}

}
