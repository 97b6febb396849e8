#include "Core/culling/hidden/FaceOnLines.h"

#include "Core/geometry/BeyondAll.h"

#include <algorithm>

namespace vitrine
{

FaceOnLines::FaceOnLines(const MeshProjection& projection, const FaceBlock& block, int lane)
  : FaceOnLines(projection, block.Face(lane), block.RectangleOf(lane))
{
  this->Plane.Unsettle(block.Unsteady(lane));
  this->Plane.LimitNearest(this->Around.Nearest);
}

FaceOnLines::FaceOnLines(
  const MeshProjection& projection, const MeshFace& face, const ScreenRectangle& around)
  : Around(around)
  , Edges{ { projection.Point(face[0]), projection.Point(face[1]) },
    { projection.Point(face[1]), projection.Point(face[2]) },
    { projection.Point(face[2]), projection.Point(face[0]) } }
  , Own(std::max({ Edges[0].OwnRounding(), Edges[1].OwnRounding(), Edges[2].OwnRounding() }))
  , Plane(projection, face)
{
  const ScreenMargin margin = projection.MarginOf(face);
  this->Aside = margin.Column + this->Own;
  this->Above = margin.Line + this->Own;
}

LineRange FaceOnLines::Lines(int count) const
{
  return LinesBetween(
    this->Around.Bottom - this->Own, this->Around.Top + this->Own, { 0, count - 1 });
}

ScreenRectangle FaceOnLines::RectangleBetween(float bottom, float top, const SBuffer& buffer) const
{
  LineExtent touched;
  for (const ScreenEdge& edge : this->Edges)
  {
    touched.Add(edge, bottom - this->Above, top + this->Above);
  }
  const SampleGrid& samples = buffer.Samples();
  const float left = samples.From(std::max(touched.Left - this->Aside, 0.0f));
  const float right =
    samples.UpTo(std::min(touched.Right + this->Aside, static_cast<float>(buffer.Columns())));
  return { left, right, bottom, top,
    this->Plane.NearestIn(
      left, right, std::max(bottom, this->Around.Bottom), std::min(top, this->Around.Top)) };
}

VITRINE_FOR_EACH_PROCESSOR
FaceOnLines::ExtentLanes FaceOnLines::Extents(int line, float inset) const
{
  const Lanes base = LanesFrom(static_cast<float>(line));
  const Lanes bottom = base + (inset - this->Above), top = base + (1.0f - inset + this->Above);
  Lanes left = AllLanes(BeyondAll), right = AllLanes(-BeyondAll);
  for (const ScreenEdge& edge : this->Edges)
  {
    const ScreenPoint &low = edge.Bottom(), &high = edge.Top();
    const bool isHigh = high.Line - low.Line > LeastHeight;
    const float slope = isHigh ? edge.ColumnsPerLine() : 0.0f;
    const Lanes least = AllLanes(std::min(low.Column, high.Column));
    const Lanes greatest = AllLanes(std::max(low.Column, high.Column));
    const Lanes lowest = (GreatestOf(bottom, AllLanes(low.Line)) - low.Line) * slope + low.Column;
    const Lanes highest = (LeastOf(top, AllLanes(high.Line)) - low.Line) * slope + low.Column;
    const LaneMask isTouched = (top >= low.Line) & (bottom <= high.Line);
    const Lanes first = isHigh ? GreatestOf(LeastOf(lowest, highest), least) : least;
    const Lanes last = isHigh ? LeastOf(GreatestOf(lowest, highest), greatest) : greatest;
    left = LeastOf(left, Chosen(isTouched, first, AllLanes(BeyondAll)));
    right = GreatestOf(right, Chosen(isTouched, last, AllLanes(-BeyondAll)));
  }
  ExtentLanes extents;
  StoreLanes(left - this->Aside, extents.Left);
  StoreLanes(right + this->Aside, extents.Right);
  return extents;
}

VITRINE_FOR_EACH_PROCESSOR
HideableSegmentLanes FaceOnLines::Pieces(int line, float inset) const
{
  const Lanes base = LanesFrom(static_cast<float>(line));
  const Lanes bottom = GreatestOf(base + inset, AllLanes(this->Around.Bottom));
  const Lanes top = LeastOf(base + (1.0f - inset), AllLanes(this->Around.Top));
  const HideableSegment first = this->Piece(0.0f, 0.0f, this->Around.Bottom, this->Around.Top);
  HideableSegmentLanes pieces;
  StoreLanes(this->Plane.NearDepthsAtOrigin(bottom, top), pieces.Depths);
  pieces.Column = first.Column;
  pieces.Slope = first.Slope;
  pieces.Nearest = first.Nearest;
  return pieces;
}

}
