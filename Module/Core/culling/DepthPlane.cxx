#include "Core/culling/DepthPlane.h"

#include "Core/culling/FaceSlopes.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

DepthPlane::DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
  const ScreenMargin& margin, const ScreenMargin& snapping)
  : DepthPlane(
      { a, b, c }, { 1.0f, 1.0f, 1.0f }, ScreenRounding::Within(margin, snapping), margin, snapping)
{
}

DepthPlane::DepthPlane(const MeshProjection& projection, const MeshFace& face)
  : DepthPlane({ projection.Point(face[0]), projection.Point(face[1]), projection.Point(face[2]) },
      { projection.InverseW(face[0]), projection.InverseW(face[1]), projection.InverseW(face[2]) },
      projection.Rounding(), projection.MarginOf(face), projection.Snapping())
{
}

DepthPlane::DepthPlane(const ScreenPoint (&corners)[3], const float (&inversesOfW)[3],
  const ScreenRounding& rounding, const ScreenMargin& margin, const ScreenMargin& snapping)
{
  const ScreenPoint &a = corners[0], &b = corners[1], &c = corners[2];
  const FaceSlopes<float> slopes(
    { { a.Column, b.Column, c.Column }, { a.Line, b.Line, c.Line }, { a.Depth, b.Depth, c.Depth },
      { inversesOfW[0], inversesOfW[1], inversesOfW[2] } },
    rounding, snapping);
  const Estimate<float>&byColumn = slopes.ByColumn, &byLine = slopes.ByLine;
  this->Below.Origin = a;
  this->Below.ByColumn = byColumn.Value;
  this->Below.ByLine = byLine.Value;
  this->Below.Slack = margin.Depth + std::abs(byColumn.Value) * margin.Column +
    std::abs(byLine.Value) * margin.Line + slopes.Unsteady +
    byColumn.Own *
      (std::max(std::abs(b.Column - a.Column), std::abs(c.Column - a.Column)) +
        SBuffer::TileWidth) +
    byLine.Own * std::max(std::abs(b.Line - a.Line), std::abs(c.Line - a.Line));
  this->Below.Farthest = std::min({ a.Depth, b.Depth, c.Depth }) - margin.Depth - slopes.Beyond;
  this->Nearest = std::max({ a.Depth, b.Depth, c.Depth }) + margin.Depth + slopes.Beyond;
}

}
