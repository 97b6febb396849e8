#include "Core/culling/DepthPlane.h"

#include "Core/culling/FaceSlopes.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

DepthPlane::DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
  const ScreenMargin& margin, const ScreenMargin& snapping)
{
  const ScreenMargin off = OffOf(margin, snapping);
  const FaceSides<float> columns{ b.Column - a.Column, c.Column - a.Column, off.Column };
  const FaceSides<float> lines{ b.Line - a.Line, c.Line - a.Line, off.Line };
  const FaceSides<float> depths{ b.Depth - a.Depth, c.Depth - a.Depth, off.Depth };
  const FaceSlopes<float> slopes(columns, lines, depths, snapping);
  const Estimate<float>&byColumn = slopes.ByColumn, &byLine = slopes.ByLine;
  this->Below.Origin = a;
  this->Below.ByColumn = byColumn.Value;
  this->Below.ByLine = byLine.Value;
  this->Below.Slack = margin.Depth + std::abs(byColumn.Value) * margin.Column +
    std::abs(byLine.Value) * margin.Line + slopes.Unsteady +
    byColumn.Own *
      (std::max(std::abs(columns.First), std::abs(columns.Second)) + SBuffer::TileWidth) +
    byLine.Own * std::max(std::abs(lines.First), std::abs(lines.Second));
  this->Below.Farthest = std::min({ a.Depth, b.Depth, c.Depth }) - margin.Depth - slopes.Beyond;
  this->Nearest = std::max({ a.Depth, b.Depth, c.Depth }) + margin.Depth + slopes.Beyond;
}

}
