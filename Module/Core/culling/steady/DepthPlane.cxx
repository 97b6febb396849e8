#include "Core/culling/steady/DepthPlane.h"

#include "Core/culling/steady/FaceSlopes.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
FacePlaces<float> PlacesOf(const MeshProjection& projection, const MeshFace& face)
{
  FacePlaces<float> places;
  for (int i = 0; i < 3; ++i)
  {
    const ScreenPoint point = projection.Point(face[i]);
    places.Columns[i] = point.Column;
    places.Lines[i] = point.Line;
    places.Depths[i] = point.Depth;
    places.InversesOfW[i] = projection.InverseW(face[i]);
  }
  return places;
}
}

DepthPlane::DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
  const ScreenMargin& margin, const ScreenMargin& snapping)
  : DepthPlane({ { a.Column, b.Column, c.Column }, { a.Line, b.Line, c.Line },
                 { a.Depth, b.Depth, c.Depth }, { 1.0f, 1.0f, 1.0f } },
      UniformScreenRounding(margin, snapping), margin, snapping)
{
}

DepthPlane::DepthPlane(const MeshProjection& projection, const MeshFace& face)
  : DepthPlane(PlacesOf(projection, face), projection.Rounding(), projection.MarginOf(face),
      projection.Snapping())
{
}

template <class Rounding>
DepthPlane::DepthPlane(const FacePlaces<float>& places, const Rounding& rounding,
  const ScreenMargin& margin, const ScreenMargin& snapping)
{
  const FaceSlopes<float> slopes(places, rounding, snapping);
  const Estimate<float>&byColumn = slopes.ByColumn, &byLine = slopes.ByLine;
  const float(&columns)[3] = places.Columns, (&lines)[3] = places.Lines,
        (&depths)[3] = places.Depths;
  this->Below.Origin = { columns[0], lines[0], depths[0] };
  this->Below.ByColumn = byColumn.Value;
  this->Below.ByLine = byLine.Value;
  this->Below.Slack = margin.Depth + std::abs(byColumn.Value) * margin.Column +
    std::abs(byLine.Value) * margin.Line + slopes.Unsteady +
    byColumn.Own *
      (std::max(std::abs(columns[1] - columns[0]), std::abs(columns[2] - columns[0])) +
        SBuffer::TileWidth) +
    byLine.Own * std::max(std::abs(lines[1] - lines[0]), std::abs(lines[2] - lines[0]));
  this->Below.Farthest =
    std::min({ depths[0], depths[1], depths[2] }) - margin.Depth - slopes.Beyond;
  this->Nearest = std::max({ depths[0], depths[1], depths[2] }) + margin.Depth + slopes.Beyond;
}

}
