#include "Core/lighting/BoxScatter.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace vitrine
{

void BoxScatter::JoinCells()
{
  this->RowBoxes.resize(static_cast<std::size_t>(this->Rows * this->Slices));
  this->SliceBoxes.resize(static_cast<std::size_t>(this->Slices));
  for (std::size_t cell = 0; cell < this->Cells.size(); ++cell)
  {
    this->RowBoxes[cell / this->Columns].Add(this->Cells[cell]);
    this->SliceBoxes[cell / this->Columns / this->Rows].Add(this->Cells[cell]);
  }
}

void BoxScatter::Append(const std::vector<LightVolume>& volumes, std::size_t first,
  std::size_t last, ClusterRuns& runs) const
{
  for (std::size_t light = first; light < last; ++light)
  {
    const LightShape shape(volumes[light]);
    const std::uint32_t number = static_cast<std::uint32_t>(light);
    if (shape.Kind == LightShape::Kinds::Everywhere)
    {
      runs.Add(number, 0, this->Count());
    }
    else if (shape.Kind != LightShape::Kinds::Nowhere)
    {
      this->AppendLight(number, shape, runs);
    }
  }
}

void BoxScatter::AppendLight(std::uint32_t light, const LightShape& shape, ClusterRuns& runs) const
{
  const Box box = shape.Bounds();
  for (int slice = 0; slice < this->Slices; ++slice)
  {
    for (int row = slice * this->Rows;
         Touches(this->SliceBoxes[slice], box) && row < (slice + 1) * this->Rows; ++row)
    {
      for (int cell = row * this->Columns;
           Touches(this->RowBoxes[row], box) && cell < (row + 1) * this->Columns; ++cell)
      {
        if (Touches(this->Cells[cell], box) && this->MayTouch(shape, this->Cells[cell]))
        {
          runs.Add(light, static_cast<std::uint32_t>(cell), 1);
        }
      }
    }
  }
}

/** Returns true if a light may touch a cell that its bounding box touches. */
bool BoxScatter::MayTouch(const LightShape& shape, const Box& cell) const
{
  if (this->Test == LightTest::Box)
  {
    return true;
  }
  const glm::vec3 away = glm::clamp(shape.Position, cell.Min, cell.Max) - shape.Position;
  const Box part = cell.ClippedTo(shape.Bounds());
  const glm::vec3 centre = 0.5f * (part.Min + part.Max);
  return glm::dot(away, away) <= shape.Range * shape.Range &&
    (shape.Kind == LightShape::Kinds::Ball ||
      shape.MayTouch(centre, glm::length(part.Max - centre)));
}

}
