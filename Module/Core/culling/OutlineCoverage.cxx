#include "Core/culling/OutlineCoverage.h"

#include "Core/culling/LineExtent.h"
#include "Core/culling/PlaneBelow.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
const float Nowhere = 3e38f;

// Edges that are less high, in lines, may be anywhere between their ends on what they touch.
const float LeastHeight = 1e-6f;
}

std::size_t OutlineCoverage::Insert(SBuffer& buffer, const MeshProjection& projection,
  MeshProjection::Facing facing, std::uint32_t part)
{
  this->Projection = &projection;
  if (!this->FrameLines(buffer))
  {
    return 0;
  }
  this->FindFacets(facing);
  this->FindOutline(facing);
  for (int first = this->FirstLine; first <= this->LastLine; first += LaneCount)
  {
    SpanLanes spans;
    this->FindSpans(first, spans);
    for (int line = first; line <= std::min(first + LaneCount - 1, this->LastLine); ++line)
    {
      const int lane = line - first;
      if (spans.Crossings[lane] > 1.0f)
      {
        this->InsertLine(buffer, line, part);
      }
      else if (spans.Left[lane] < spans.Right[lane])
      {
        this->InsertSpan(buffer, line, spans.Left[lane], spans.Right[lane], part);
      }
    }
  }
  return this->EdgeCount + static_cast<std::size_t>(this->LastLine - this->FirstLine + 1);
}

/** Find the lines that all points lie in; returns whether any may be covered. */
bool OutlineCoverage::FrameLines(const SBuffer& buffer)
{
  const ScreenRectangle& around = this->Projection->Rectangle();
  const bool isOnScreen = around.Left < static_cast<float>(buffer.Columns()) &&
    around.Right > 0.0f && around.Bottom < static_cast<float>(buffer.Lines()) && around.Top > 0.0f;
  this->Inset = buffer.Samples().Inset();
  if (!isOnScreen || !(around.Top - around.Bottom >= 1.0f - 2.0f * this->Inset))
  {
    return false;
  }
  this->FirstLine = FloorWithin(std::ceil(around.Bottom - this->Inset), 0, buffer.Lines() - 1);
  this->LastLine = FloorWithin(around.Top - 1.0f + this->Inset, 0, buffer.Lines() - 1);
  const float own = OwnRoundingOf(std::max(std::abs(around.Left), std::abs(around.Right)),
    std::max(std::abs(around.Bottom), std::abs(around.Top)));
  this->Aside = this->Projection->Margin().Column + own;
  this->Above = this->Projection->Margin().Line + own - this->Inset;
  return this->FirstLine <= this->LastLine;
}

/** Which facets count, and where their corners are. */
void OutlineCoverage::FindFacets(MeshProjection::Facing facing)
{
  const MeshFacets& facets = this->Projection->Mesh().Facets();
  const bool areAllBehindNear = this->Projection->IsBehindNear();
  this->IsCounted.resize(facets.Count() + 1);
  this->Corners.clear();
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < facets.Count(); ++i)
  {
    const std::uint32_t end = facets.CornerEnds()[i];
    const bool counts = this->Projection->FacingOf(facets.LargestFaces()[i]) == facing &&
      (areAllBehindNear || this->IsBehindNear(begin, end));
    for (std::uint32_t corner = counts ? begin : end; corner < end; ++corner)
    {
      this->Corners.push_back(this->Projection->Point(facets.Corners()[corner]));
    }
    this->IsCounted[i] = counts;
    begin = end;
  }
  this->IsCounted[facets.Count()] = 0;
  this->Bound = PlaneBelow(this->Corners, this->Projection->Margin());
}

/** Whether all corners of a facet are. */
bool OutlineCoverage::IsBehindNear(std::uint32_t begin, std::uint32_t end) const
{
  const std::uint32_t* const corners = this->Projection->Mesh().Facets().Corners().data();
  return std::all_of(corners + begin, corners + end,
    [&](std::uint32_t corner) { return this->Projection->IsBehindNear(corner); });
}

/** Those that go down come first, those that go up behind them. What is chosen is chosen without branches, which could not be foreseen. */
void OutlineCoverage::FindOutline(MeshProjection::Facing facing)
{
  const std::vector<MeshEdge>& edges = this->Projection->Mesh().Facets().Edges();
  this->Ends.resize(edges.size() + 1);
  this->Outline.resize(std::max(this->Outline.size(), edges.size() + 1));
  // What counts lies left of an edge of the outline; of back faces, right of it.
  const std::uint8_t isBack = facing == MeshProjection::Facing::Front ? 0 : 1;
  const std::uint8_t* const isCounted = this->IsCounted.data();
  MeshEdge* const ends = this->Ends.data();
  std::size_t count = 0;
  for (const MeshEdge& edge : edges)
  {
    const std::uint8_t left = isCounted[edge.Left];
    const bool isForward = left != isBack;
    ends[count].From = isForward ? edge.From : edge.To;
    ends[count].To = isForward ? edge.To : edge.From;
    count += left ^ isCounted[edge.Right];
  }
  OutlineEdge* const outline = this->Outline.data();
  std::size_t down = 0, up = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    const OutlineEdge edge = EdgeFrom(
      this->Projection->Point(this->Ends[i].From), this->Projection->Point(this->Ends[i].To));
    outline[edge.Winding > 0.0f ? down : up - 1] = edge;
    down += edge.Winding > 0.0f;
    up -= edge.Winding < 0.0f;
  }
  this->DownCount = down;
  this->EdgeCount = count;
}

OutlineCoverage::OutlineEdge OutlineCoverage::EdgeFrom(
  const ScreenPoint& from, const ScreenPoint& to)
{
  const float isUp = to.Line > from.Line ? 1.0f : 0.0f;
  const float bottom = std::min(from.Line, to.Line), top = std::max(from.Line, to.Line);
  const float left = std::min(from.Column, to.Column), right = std::max(from.Column, to.Column);
  const bool isHigh = top - bottom > LeastHeight;
  const float slope = (to.Column - from.Column) / (to.Line - from.Line);
  const float inside = isUp > 0.0f ? left : right;
  const float low = isUp > 0.0f ? from.Column : to.Column;
  return { bottom, top, isHigh ? low : inside, isHigh ? slope : 0.0f, left, right,
    1.0f - 2.0f * isUp };
}

/** On a line that it crosses. */
float OutlineCoverage::OutlineEdge::At(float line) const
{
  return std::min(
    std::max(this->Column + (line - this->Bottom) * this->Slope, this->Left), this->Right);
}

/** At the top or at the bottom of what it has of lines. */
VITRINE_INLINE Lanes OutlineCoverage::OutlineEdge::FarthestOn(
  Lanes bottom, Lanes top, bool isAtTop) const
{
  const Lanes highest = LeastOf(top, AllLanes(this->Top));
  const Lanes lowest = GreatestOf(bottom, AllLanes(this->Bottom));
  const LaneMask mask = LaneMask{} - (isAtTop ? 1 : 0);
  const Lanes column = ((mask ? highest : lowest) - this->Bottom) * this->Slope + this->Column;
  return LeastOf(GreatestOf(column, AllLanes(this->Left)), AllLanes(this->Right));
}

/**
 * Of a line and the ones above it. An edge touches most of a line at the bottom or at the top of what it has of it, by the way it slants.
 */
VITRINE_FOR_EACH_PROCESSOR
void OutlineCoverage::FindSpans(int line, SpanLanes& spans) const
{
  const Lanes base = LanesFrom(static_cast<float>(line));
  const Lanes bottom = base - this->Above, middle = base + 0.5f, top = base + 1.0f + this->Above;
  Lanes left = AllLanes(-Nowhere), right = AllLanes(Nowhere), crossings = AllLanes(0.0f);
  const OutlineEdge* const edges = this->Outline.data();
  for (std::size_t i = 0; i < this->DownCount; ++i)
  {
    const OutlineEdge& edge = edges[i];
    const LaneMask isTouched = (top >= edge.Bottom) & (bottom <= edge.Top);
    const Lanes column = edge.FarthestOn(bottom, top, edge.Slope > 0.0f);
    left = GreatestOf(left, isTouched ? column : AllLanes(-Nowhere));
    const LaneMask isCrossed = (middle >= edge.Bottom) & (middle < edge.Top);
    crossings += isCrossed ? AllLanes(1.0f) : AllLanes(0.0f);
  }
  for (std::size_t i = this->DownCount; i < this->EdgeCount; ++i)
  {
    const OutlineEdge& edge = edges[i];
    const LaneMask isTouched = (top >= edge.Bottom) & (bottom <= edge.Top);
    const Lanes column = edge.FarthestOn(bottom, top, edge.Slope < 0.0f);
    right = LeastOf(right, isTouched ? column : AllLanes(Nowhere));
  }
  StoreLanes(crossings > 0.0f ? left + this->Aside : AllLanes(Nowhere), spans.Left);
  StoreLanes(right - this->Aside, spans.Right);
  StoreLanes(crossings, spans.Crossings);
}

void OutlineCoverage::InsertSpan(
  SBuffer& buffer, int line, float left, float right, std::uint32_t part)
{
  const ScreenRectangle& around = this->Projection->Rectangle();
  const float bottom = std::max(static_cast<float>(line) + this->Inset, around.Bottom);
  const float top = std::min(static_cast<float>(line + 1) - this->Inset, around.Top);
  const DepthBound depth = this->Bound.Within(left, right, bottom, top);
  buffer.Insert(line, { left, right, depth.Left, depth.Right, part });
}

/** Of a line that the outline passes several times. */
void OutlineCoverage::InsertLine(SBuffer& buffer, int line, std::uint32_t part)
{
  const float bottom = static_cast<float>(line) - this->Above;
  const float middle = static_cast<float>(line) + 0.5f;
  const float top = static_cast<float>(line) + 1.0f + this->Above;
  this->Passages.clear();
  for (std::size_t i = 0; i < this->EdgeCount; ++i)
  {
    const OutlineEdge& edge = this->Outline[i];
    if (edge.Bottom <= top && edge.Top >= bottom)
    {
      const bool isLevel = edge.Slope == 0.0f;
      const float low = isLevel ? edge.Left : edge.At(std::max(edge.Bottom, bottom));
      const float high = isLevel ? edge.Right : edge.At(std::min(edge.Top, top));
      const bool isCrossed = edge.Bottom <= middle && middle < edge.Top;
      this->Passages.push_back({ std::min(low, high) - this->Aside,
        std::max(low, high) + this->Aside, isCrossed ? (edge.Winding > 0.0f ? 1 : -1) : 0 });
    }
  }
  std::sort(this->Passages.begin(), this->Passages.end(),
    [](const Passage& a, const Passage& b) { return a.Left < b.Left; });
  int cover = 0;
  float reached = -Nowhere;
  for (const Passage& passage : this->Passages)
  {
    if (cover > 0 && passage.Left > reached)
    {
      this->InsertSpan(buffer, line, reached, passage.Left, part);
    }
    cover += passage.Winding;
    reached = std::max(reached, passage.Right);
  }
}

}
