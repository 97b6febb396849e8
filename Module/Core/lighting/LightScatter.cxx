// The refinement of the ball is from E. Persson: Practical clustered shading, SIGGRAPH 2013.

#include "Core/lighting/LightScatter.h"

#include "Core/geometry/Bits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

float DistanceFrom(const glm::vec4& plane, const glm::vec3& point)
{
  return ClusterGrid::Dot(plane, glm::vec4(point, 1.0f));
}

/** Returns the tile of 0 to `count` - 1 that is nearest to a position. NaN becomes 0. */
int NearestTile(float place, int count)
{
  return static_cast<int>(std::min(std::max(0.0f, place), static_cast<float>(count - 1)));
}

}

void LightScatter::Append(const std::vector<LightVolume>& volumes, std::size_t first,
  std::size_t last, ClusterRuns& runs) const
{
  for (std::size_t block = first; block < last; block += LightFilter::BlockSize)
  {
    const std::size_t count = std::min(LightFilter::BlockSize, last - block);
    const std::uint64_t marked = this->Marks != nullptr
      ? this->Marks->Block(block / LightFilter::BlockSize)
      : ~std::uint64_t{ 0 };
    std::uint64_t bits =
      marked != 0 ? marked & this->Filter.MayReach(volumes.data() + block, count) : 0;
    for (; bits != 0; bits &= bits - 1)
    {
      const std::size_t light = block + static_cast<std::size_t>(LowestBit(bits));
      this->AppendLight(static_cast<std::uint32_t>(light), volumes[light], runs);
    }
  }
}

void LightScatter::AppendLight(
  std::uint32_t light, const LightVolume& volume, ClusterRuns& runs) const
{
  const LightShape shape(volume);
  if (shape.Kind == LightShape::Kinds::Everywhere)
  {
    runs.Add(light, 0, this->Grid.Count());
  }
  else if (shape.Kind != LightShape::Kinds::Nowhere)
  {
    this->AppendSlices(light, shape, runs);
  }
}

void LightScatter::AppendSlices(
  std::uint32_t light, const LightShape& shape, ClusterRuns& runs) const
{
  const BallPart ball = shape.Enclosing();
  const float distance = -ball.Centre.z;
  for (int slice = 0; slice < this->Grid.Slices(); ++slice)
  {
    const glm::vec2 depths = this->Grid.DepthsOf(slice);
    const float before = depths.x - distance, behind = distance - depths.y;
    if (before > ball.Radius)
    {
      return; // all further slices are beyond the ball, too
    }
    const float away = std::max(0.0f, std::max(before, behind));
    if (away > ball.Radius)
    {
      continue;
    }
    BallPart part = ball;
    if (away > 0.0f)
    {
      part.Centre.z = before > 0.0f ? -depths.x : -depths.y;
      part.Square = std::max(0.0f, part.Square - away * away);
      part.Radius = std::sqrt(part.Square);
    }
    this->AppendRows(light, shape, slice, part, runs);
  }
}

void LightScatter::AppendRows(std::uint32_t light, const LightShape& shape, int slice,
  const BallPart& part, ClusterRuns& runs) const
{
  const Range rows = this->RowsOf(part);
  for (int row = rows.First; row <= rows.Last; ++row)
  {
    BallPart inRow = part;
    if (!inRow.CutBy(this->Grid.BottomOf(row)) || !inRow.CutBy(this->Grid.TopOf(row)))
    {
      continue;
    }
    // The nearest point may lie behind the eye if the sides enclose more than 90 degrees. There, columns are mirrored.
    const bool isInSlice = -inRow.Centre.z >= this->Grid.DepthsOf(slice).x;
    this->AppendColumns(light, shape, slice, row, isInSlice ? inRow : part, runs);
  }
}

void LightScatter::AppendColumns(std::uint32_t light, const LightShape& shape, int slice, int row,
  const BallPart& part, ClusterRuns& runs) const
{
  const Range columns = this->ColumnsOf(part);
  if (shape.Kind == LightShape::Kinds::Cone)
  {
    this->AppendCone(light, shape, slice, row, columns, runs);
  }
  else if (columns.First <= columns.Last)
  {
    runs.Add(light, this->Grid.ClusterAt(columns.First, row, slice),
      static_cast<std::uint32_t>(columns.Last - columns.First + 1));
  }
}

void LightScatter::AppendCone(std::uint32_t light, const LightShape& shape, int slice, int row,
  Range columns, ClusterRuns& runs) const
{
  for (int column = columns.First; column <= columns.Last; ++column)
  {
    const std::uint32_t cluster = this->Grid.ClusterAt(column, row, slice);
    const glm::vec4& ball = this->BallAround(cluster);
    if (shape.MayTouch(glm::vec3(ball), ball.w))
    {
      runs.Add(light, cluster, 1);
    }
  }
}

const glm::vec4& LightScatter::BallAround(std::uint32_t cluster) const
{
  std::call_once(this->HasBalls, [this] { this->Balls = this->Grid.BallsAround(); });
  return this->Balls[cluster];
}

/**
 * Returns the rows that a part of a ball in front of the eye may touch. It searches up and down from the centre's row.
 */
LightScatter::Range LightScatter::RowsOf(const BallPart& part) const
{
  const int count = this->Grid.Rows();
  const int start = NearestTile(this->Grid.RowAt(part.Centre), count);
  if (DistanceFrom(this->Grid.BottomOf(start), part.Centre) < -part.Radius ||
    DistanceFrom(this->Grid.TopOf(start), part.Centre) < -part.Radius)
  {
    return { 0, -1 };
  }
  Range rows{ start, start };
  while (
    rows.First > 0 && DistanceFrom(this->Grid.TopOf(rows.First - 1), part.Centre) >= -part.Radius)
  {
    --rows.First;
  }
  while (rows.Last + 1 < count &&
    DistanceFrom(this->Grid.BottomOf(rows.Last + 1), part.Centre) >= -part.Radius)
  {
    ++rows.Last;
  }
  return rows;
}

LightScatter::Range LightScatter::ColumnsOf(const BallPart& part) const
{
  const int count = this->Grid.Columns();
  const int start = NearestTile(this->Grid.ColumnAt(part.Centre), count);
  if (DistanceFrom(this->Grid.LeftOf(start), part.Centre) < -part.Radius ||
    DistanceFrom(this->Grid.RightOf(start), part.Centre) < -part.Radius)
  {
    return { 0, -1 };
  }
  Range columns{ start, start };
  while (columns.First > 0 &&
    DistanceFrom(this->Grid.RightOf(columns.First - 1), part.Centre) >= -part.Radius)
  {
    --columns.First;
  }
  while (columns.Last + 1 < count &&
    DistanceFrom(this->Grid.LeftOf(columns.Last + 1), part.Centre) >= -part.Radius)
  {
    ++columns.Last;
  }
  return columns;
}

}
