#include "Core/culling/OutlineCoverage.h"

#include "Core/culling/LineExtent.h"

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
        buffer.Insert(
          line, { spans.Left[lane], spans.Right[lane], this->Depth, this->Depth, part });
      }
    }
  }
  return this->Outline.size() + static_cast<std::size_t>(this->LastLine - this->FirstLine + 1);
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

/** Which facets count, and how far they reach. */
void OutlineCoverage::FindFacets(MeshProjection::Facing facing)
{
  const MeshFacets& facets = this->Projection->Mesh().Facets();
  this->IsCounted.resize(facets.Count() + 1);
  float farthest = 1.0f;
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < facets.Count(); ++i)
  {
    const std::uint32_t end = facets.CornerEnds()[i];
    bool counts = this->Projection->FacingOf(facets.LargestFaces()[i]) == facing;
    if (counts)
    {
      float least = 1.0f;
      for (std::uint32_t corner = begin; corner < end; ++corner)
      {
        const std::uint32_t point = facets.Corners()[corner];
        counts = counts && this->Projection->IsBehindNear(point);
        least = std::min(least, this->Projection->Point(point).Depth);
      }
      farthest = counts ? std::min(farthest, least) : farthest;
    }
    this->IsCounted[i] = counts;
    begin = end;
  }
  this->IsCounted[facets.Count()] = 0;
  this->Depth = farthest - this->Projection->Margin().Depth;
}

void OutlineCoverage::FindOutline(MeshProjection::Facing facing)
{
  const std::vector<MeshEdge>& edges = this->Projection->Mesh().Facets().Edges();
  this->Ends.resize(edges.size() + 1);
  std::size_t count = 0;
  for (const MeshEdge& edge : edges)
  {
    const bool left = this->IsCounted[edge.Left] != 0;
    const bool right = this->IsCounted[edge.Right] != 0;
    // What counts lies left of an edge of the outline; of back faces, right of it.
    const bool isForward = left == (facing == MeshProjection::Facing::Front);
    this->Ends[count].From = isForward ? edge.From : edge.To;
    this->Ends[count].To = isForward ? edge.To : edge.From;
    count += left != right; // without a branch, which could not be foreseen
  }
  this->Outline.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Outline[i] = EdgeFrom(
      this->Projection->Point(this->Ends[i].From), this->Projection->Point(this->Ends[i].To));
  }
}

OutlineCoverage::OutlineEdge OutlineCoverage::EdgeFrom(
  const ScreenPoint& from, const ScreenPoint& to)
{
  const bool isUp = to.Line > from.Line;
  const ScreenPoint& low = isUp ? from : to;
  const ScreenPoint& high = isUp ? to : from;
  const float left = std::min(from.Column, to.Column), right = std::max(from.Column, to.Column);
  const float height = high.Line - low.Line;
  if (!(height > LeastHeight))
  {
    return { low.Line, high.Line, isUp ? left : right, 0.0f, left, right, !isUp };
  }
  return { low.Line, high.Line, low.Column, (high.Column - low.Column) / height, left, right,
    !isUp };
}

/** On a line that it crosses. */
float OutlineCoverage::OutlineEdge::At(float line) const
{
  return std::min(
    std::max(this->Column + (line - this->Bottom) * this->Slope, this->Left), this->Right);
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
  for (const OutlineEdge& edge : this->Outline)
  {
    const LaneMask isTouched = (top >= edge.Bottom) & (bottom <= edge.Top);
    const bool isAtTop = (edge.Slope > 0.0f) == edge.GoesDown;
    const Lanes at =
      isAtTop ? LeastOf(top, AllLanes(edge.Top)) : GreatestOf(bottom, AllLanes(edge.Bottom));
    const Lanes column =
      LeastOf(GreatestOf((at - edge.Bottom) * edge.Slope + edge.Column, AllLanes(edge.Left)),
        AllLanes(edge.Right));
    if (edge.GoesDown)
    {
      left = GreatestOf(left, isTouched ? column : AllLanes(-Nowhere));
      const LaneMask isCrossed = (middle >= edge.Bottom) & (middle < edge.Top);
      crossings += isCrossed ? AllLanes(1.0f) : AllLanes(0.0f);
    }
    else
    {
      right = LeastOf(right, isTouched ? column : AllLanes(Nowhere));
    }
  }
  StoreLanes(crossings > 0.0f ? left + this->Aside : AllLanes(Nowhere), spans.Left);
  StoreLanes(right - this->Aside, spans.Right);
  StoreLanes(crossings, spans.Crossings);
}

/** Of a line that the outline passes several times. */
void OutlineCoverage::InsertLine(SBuffer& buffer, int line, std::uint32_t part)
{
  const float bottom = static_cast<float>(line) - this->Above;
  const float middle = static_cast<float>(line) + 0.5f;
  const float top = static_cast<float>(line) + 1.0f + this->Above;
  this->Passages.clear();
  for (const OutlineEdge& edge : this->Outline)
  {
    if (edge.Bottom <= top && edge.Top >= bottom)
    {
      const bool isLevel = edge.Slope == 0.0f;
      const float low = isLevel ? edge.Left : edge.At(std::max(edge.Bottom, bottom));
      const float high = isLevel ? edge.Right : edge.At(std::min(edge.Top, top));
      const bool isCrossed = edge.Bottom <= middle && middle < edge.Top;
      this->Passages.push_back({ std::min(low, high) - this->Aside,
        std::max(low, high) + this->Aside, isCrossed ? (edge.GoesDown ? 1 : -1) : 0 });
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
      buffer.Insert(line, { reached, passage.Left, this->Depth, this->Depth, part });
    }
    cover += passage.Winding;
    reached = std::max(reached, passage.Right);
  }
}

}
