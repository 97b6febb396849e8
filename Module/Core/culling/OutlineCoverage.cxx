#include "Core/culling/OutlineCoverage.h"

#include "Core/culling/BeyondAll.h"
#include "Core/culling/LineExtent.h"
#include "Core/culling/PlaneBelow.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

std::size_t OutlineCoverage::Insert(SBuffer& buffer, const MeshProjection& projection,
  MeshProjection::Facing facing, std::uint32_t part)
{
  this->Projection = &projection;
  if (!this->FrameLines(buffer))
  {
    return 0;
  }
  if (!this->SkipCovered(buffer) || !this->FindFacets(facing))
  {
    return 1;
  }
  this->FindOutline(facing);
  for (int first = this->FirstLine; first <= this->LastLine; first += LaneCount)
  {
    if (const unsigned open = this->OpenLines(buffer, first))
    {
      this->InsertLines(buffer, first, open, part);
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

/** A bit for a line and each of the seven above it where something that is as near as the nearest point may not be covered. */
unsigned OutlineCoverage::OpenLines(const SBuffer& buffer, int line) const
{
  const ScreenRectangle& around = this->Projection->Rectangle();
  return buffer.OpenLines(line, this->LastLine, around.Left, around.Right, around.Nearest);
}

/** Begin with lines that are not all covered; returns whether there are any. */
bool OutlineCoverage::SkipCovered(const SBuffer& buffer)
{
  while (this->FirstLine <= this->LastLine && this->OpenLines(buffer, this->FirstLine) == 0)
  {
    this->FirstLine += LaneCount;
  }
  return this->FirstLine <= this->LastLine;
}

/** Which facets count, and a plane behind their corners. Returns whether there are any. */
bool OutlineCoverage::FindFacets(MeshProjection::Facing facing)
{
  const MeshFacets& facets = this->Projection->Mesh().Facets();
  const bool areAllBehindNear = this->Projection->IsBehindNear();
  const std::uint32_t* const corners = facets.Corners().data();
  this->IsCounted.resize(facets.Count() + 1);
  this->Corners.assign(this->Projection->Mesh().Coordinates(0).size(), 0);
  std::uint32_t begin = 0, some = MeshFacets::NoFace;
  for (std::size_t i = 0; i < facets.Count(); ++i)
  {
    const std::uint32_t end = facets.CornerEnds()[i];
    const bool counts = this->Projection->FacingOf(facets.LargestFaces()[i]) == facing &&
      (areAllBehindNear || this->IsBehindNear(begin, end));
    if (counts)
    {
      this->CountCorners(corners + begin, corners + end);
      some = corners[begin];
    }
    this->IsCounted[i] = counts;
    begin = end;
  }
  this->IsCounted[facets.Count()] = 0;
  if (some == MeshFacets::NoFace)
  {
    return false;
  }
  this->Bound = PlaneBelow(
    { this->Projection->ColumnsOfPoints().data(), this->Projection->LinesOfPoints().data(),
      this->Projection->DepthsOfPoints().data(), this->Corners.data(), this->Corners.size() },
    this->Projection->Point(some), this->Projection->Margin());
  return true;
}

void OutlineCoverage::CountCorners(const std::uint32_t* begin, const std::uint32_t* end)
{
  for (const std::uint32_t* corner = begin; corner != end; ++corner)
  {
    this->Corners[*corner] = -1;
  }
}

/** Whether all corners of a facet are. */
bool OutlineCoverage::IsBehindNear(std::uint32_t begin, std::uint32_t end) const
{
  const std::uint32_t* const corners = this->Projection->Mesh().Facets().Corners().data();
  return std::all_of(corners + begin, corners + end,
    [&](std::uint32_t corner) { return this->Projection->IsBehindNear(corner); });
}

void OutlineCoverage::FindOutline(MeshProjection::Facing facing)
{
  this->FindEnds(facing);
  this->Outline.resize((this->EdgeCount + LaneCount - 1) / LaneCount);
  for (std::size_t i = 0; i < this->Outline.size(); ++i)
  {
    this->FindEdges(&this->Ends[i * LaneCount], this->Outline[i]);
  }
}

/** Where the edges of the outline begin and end. What is chosen is chosen without branches, which could not be foreseen. */
void OutlineCoverage::FindEnds(MeshProjection::Facing facing)
{
  const std::vector<MeshEdge>& edges = this->Projection->Mesh().Facets().Edges();
  this->Ends.resize(edges.size() + LaneCount);
  // What counts lies left of an edge of the outline; of back faces, right of it.
  const std::uint8_t isBack = facing == MeshProjection::Facing::Front ? 0 : 1;
  const std::uint8_t* const isCounted = this->IsCounted.data();
  MeshEdge* const ends = this->Ends.data();
  std::size_t count = 0;
  for (const MeshEdge& edge : edges)
  {
    const std::uint8_t left = isCounted[edge.Left];
    const std::uint32_t isForward = left != isBack;
    const std::uint32_t swapped = (edge.From ^ edge.To) & (isForward - 1u);
    ends[count].From = edge.From ^ swapped;
    ends[count].To = edge.To ^ swapped;
    count += left ^ isCounted[edge.Right];
  }
  // Up to seven more are looked at, whatever they are.
  std::fill(ends + count, ends + count + LaneCount, MeshEdge{});
  this->EdgeCount = count;
}

VITRINE_FOR_EACH_PROCESSOR
void OutlineCoverage::FindEdges(const MeshEdge* ends, OutlineEdges& edges) const
{
  float fromColumns[LaneCount], fromLines[LaneCount], toColumns[LaneCount], toLines[LaneCount];
  for (int i = 0; i < LaneCount; ++i)
  {
    const ScreenPoint from = this->Projection->Point(ends[i].From);
    const ScreenPoint to = this->Projection->Point(ends[i].To);
    fromColumns[i] = from.Column;
    fromLines[i] = from.Line;
    toColumns[i] = to.Column;
    toLines[i] = to.Line;
  }
  const Lanes fromColumn = LoadLanes(fromColumns), fromLine = LoadLanes(fromLines);
  const Lanes toColumn = LoadLanes(toColumns), toLine = LoadLanes(toLines);
  const LaneMask isUp = toLine > fromLine;
  const Lanes bottom = LeastOf(fromLine, toLine), top = GreatestOf(fromLine, toLine);
  const Lanes left = LeastOf(fromColumn, toColumn), right = GreatestOf(fromColumn, toColumn);
  const LaneMask isHigh = top - bottom > AllLanes(LeastHeight);
  const Lanes slope = isHigh ? (toColumn - fromColumn) / (toLine - fromLine) : AllLanes(0.0f);
  const Lanes inside = isUp ? left : right;
  const LaneMask isRising = slope > AllLanes(0.0f), isFalling = slope < AllLanes(0.0f);
  StoreLanes(bottom, edges.Bottom);
  StoreLanes(top, edges.Top);
  StoreLanes(isHigh ? (isUp ? fromColumn : toColumn) : inside, edges.Column);
  StoreLanes(slope, edges.Slope);
  StoreLanes(left, edges.Left);
  StoreLanes(right, edges.Right);
  StoreMask(~isUp, edges.IsDown);
  StoreMask(isUp ? isFalling : isRising, edges.IsAtTop);
}

/** On a line that it crosses. */
float OutlineCoverage::OutlineEdges::At(int i, float line) const
{
  const float column = this->Column[i] + (line - this->Bottom[i]) * this->Slope[i];
  return std::min(std::max(column, this->Left[i]), this->Right[i]);
}

/** At the top or at the bottom of what it has of lines. */
VITRINE_INLINE Lanes OutlineCoverage::OutlineEdges::FarthestOn(int i, Lanes bottom, Lanes top) const
{
  const Lanes highest = LeastOf(top, AllLanes(this->Top[i]));
  const Lanes lowest = GreatestOf(bottom, AllLanes(this->Bottom[i]));
  const LaneMask isAtTop = LaneMask{} + this->IsAtTop[i];
  const Lanes line = isAtTop ? highest : lowest;
  const Lanes column = (line - this->Bottom[i]) * this->Slope[i] + this->Column[i];
  return LeastOf(GreatestOf(column, AllLanes(this->Left[i])), AllLanes(this->Right[i]));
}

/**
 * Of a line and the ones above it. An edge touches most of a line at the bottom or at the top of what it has of it, by the way it slants.
 */
VITRINE_FOR_EACH_PROCESSOR
void OutlineCoverage::FindSpans(int line, SpanLanes& spans) const
{
  const Lanes base = LanesFrom(static_cast<float>(line));
  const Lanes bottom = base - this->Above, middle = base + 0.5f, top = base + 1.0f + this->Above;
  Lanes left = AllLanes(-BeyondAll), right = AllLanes(BeyondAll), crossings = AllLanes(0.0f);
  for (std::size_t edge = 0; edge < this->EdgeCount; ++edge)
  {
    const OutlineEdges& edges = this->Outline[edge / LaneCount];
    const int i = static_cast<int>(edge % LaneCount);
    const LaneMask isTouched = (top >= edges.Bottom[i]) & (bottom <= edges.Top[i]);
    const LaneMask isCrossed = (middle >= edges.Bottom[i]) & (middle < edges.Top[i]);
    const LaneMask isDown = LaneMask{} + edges.IsDown[i];
    const Lanes column = edges.FarthestOn(i, bottom, top);
    left = GreatestOf(left, isTouched & isDown ? column : AllLanes(-BeyondAll));
    right = LeastOf(right, isTouched & ~isDown ? column : AllLanes(BeyondAll));
    crossings += isCrossed & isDown ? AllLanes(1.0f) : AllLanes(0.0f);
  }
  StoreLanes(crossings > 0.0f ? left + this->Aside : AllLanes(BeyondAll), spans.Left);
  StoreLanes(right - this->Aside, spans.Right);
  StoreLanes(crossings, spans.Crossings);
}

/** Insert what is covered of a line and those above it that are open. */
void OutlineCoverage::InsertLines(SBuffer& buffer, int first, unsigned open, std::uint32_t part)
{
  SpanLanes spans;
  this->FindSpans(first, spans);
  for (int lane = 0; open >> lane != 0; ++lane)
  {
    if ((open >> lane & 1u) == 0)
    {
      continue;
    }
    if (spans.Crossings[lane] > 1.0f)
    {
      this->InsertLine(buffer, first + lane, part);
    }
    else if (spans.Left[lane] < spans.Right[lane])
    {
      this->InsertSpan(buffer, first + lane, spans.Left[lane], spans.Right[lane], part);
    }
  }
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
  for (std::size_t edge = 0; edge < this->EdgeCount; ++edge)
  {
    const OutlineEdges& edges = this->Outline[edge / LaneCount];
    const int i = static_cast<int>(edge % LaneCount);
    if (edges.Bottom[i] <= top && edges.Top[i] >= bottom)
    {
      const bool isLevel = edges.Slope[i] == 0.0f;
      const float low = isLevel ? edges.Left[i] : edges.At(i, std::max(edges.Bottom[i], bottom));
      const float high = isLevel ? edges.Right[i] : edges.At(i, std::min(edges.Top[i], top));
      const bool isCrossed = edges.Bottom[i] <= middle && middle < edges.Top[i];
      this->Passages.push_back({ std::min(low, high) - this->Aside,
        std::max(low, high) + this->Aside, isCrossed ? (edges.IsDown[i] ? 1 : -1) : 0 });
    }
  }
  std::sort(this->Passages.begin(), this->Passages.end(),
    [](const Passage& a, const Passage& b) { return a.Left < b.Left; });
  int cover = 0;
  float reached = -BeyondAll;
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
