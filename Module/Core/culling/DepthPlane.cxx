#include "Core/culling/DepthPlane.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

const float AnyDepth = 2.0f; // more than all depths differ

/** A number, and by how much it may be off. */
struct Estimate
{
  float Value;
  float Own; ///< by our sums in floats
  float Off; ///< by a device's other corners, too
};

/** Of a face's two sides that begin at its first corner: what they have of a coordinate, and how far off a device may be in that. */
struct Sides
{
  float First;
  float Second;
  float Off;

  float Sum() const { return std::abs(this->First) + std::abs(this->Second); }
};

Estimate Cross(const Sides& a, const Sides& b)
{
  const float first = a.First * b.Second, second = a.Second * b.First;
  const float own = RoundingOfFloats * (std::abs(first) + std::abs(second));
  return { first - second, own, own + a.Off * b.Sum() + b.Off * a.Sum() + 2.0f * a.Off * b.Off };
}

/** Off is negative, infinite or no number if nothing is known. */
Estimate Quotient(const Estimate& a, const Estimate& b)
{
  const float value = a.Value / b.Value, size = std::abs(b.Value);
  return { value, (a.Own + std::abs(value) * b.Own) / size,
    (a.Off + std::abs(value) * b.Off) / (size - b.Off) };
}
}

DepthPlane::DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
  const ScreenMargin& margin, const ScreenMargin& snapping)
{
  const Sides columns{ b.Column - a.Column, c.Column - a.Column,
    2.0f * (margin.Column - snapping.Column) };
  const Sides lines{ b.Line - a.Line, c.Line - a.Line, 2.0f * (margin.Line - snapping.Line) };
  const Sides depths{ b.Depth - a.Depth, c.Depth - a.Depth,
    2.0f * (margin.Depth - snapping.Depth) };
  const Estimate area = Cross(columns, lines);
  const Estimate byColumn = Quotient(Cross(depths, lines), area);
  const Estimate byLine = Quotient(Cross(columns, depths), area);
  const bool isKnown = std::abs(area.Value) > area.Off;

  const auto snapped = [&](float columnOff, float lineOff)
  { return columnOff * snapping.Column + lineOff * snapping.Line; };
  const float unsteady = isKnown ? snapped(byColumn.Off, byLine.Off) : AnyDepth;
  const float beside = unsteady + snapped(std::abs(byColumn.Value), std::abs(byLine.Value));
  const float beyond = beside < AnyDepth ? beside : AnyDepth; // as where it is no number
  this->Below.Origin = a;
  this->Below.ByColumn = byColumn.Value;
  this->Below.ByLine = byLine.Value;
  this->Below.Slack = margin.Depth + std::abs(byColumn.Value) * margin.Column +
    std::abs(byLine.Value) * margin.Line + unsteady +
    byColumn.Own *
      (std::max(std::abs(columns.First), std::abs(columns.Second)) + SBuffer::TileWidth) +
    byLine.Own * std::max(std::abs(lines.First), std::abs(lines.Second));
  this->Below.Farthest = std::min({ a.Depth, b.Depth, c.Depth }) - margin.Depth - beyond;
  this->Nearest = std::max({ a.Depth, b.Depth, c.Depth }) + margin.Depth + beyond;
}

}
