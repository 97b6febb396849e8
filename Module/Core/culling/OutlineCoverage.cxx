#include "Core/culling/OutlineCoverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine
{

namespace
{

// Of what our own sums in floats may be off, as a share of the largest coordinate in them.
const float OwnRounding = 0x1p-21f;

// Of a cell that no face is known to be in; farther than that nothing is nearer.
const float NoDepth = 2.0f;
const float GreatestDepth = 1.0f;

// Outlines of so few cells get one bound: finding one for each costs more than the better bounds hide.
const int FewLines = 8;
const int FewTiles = 2;

/** The part of a segment between two lines, from left to right. */
struct Extent
{
  float Left = 3e38f;
  float Right = -3e38f;

  /** @param low  the lower end of the segment, @param high  the upper one */
  void AddBetween(const ScreenPoint& low, const ScreenPoint& high, float bottom, float top)
  {
    if (low.Line > top || high.Line < bottom)
    {
      return;
    }
    const float height = high.Line - low.Line;
    const float slope = height > 0.0f ? (high.Column - low.Column) / height : 0.0f;
    this->Add(low.Line >= bottom ? low.Column : Between(low, high, slope, bottom));
    this->Add(high.Line <= top ? high.Column : Between(low, high, slope, top));
  }

private:
  static float Between(const ScreenPoint& low, const ScreenPoint& high, float slope, float line)
  {
    const float column = low.Column + (line - low.Line) * slope;
    return std::min(
      std::max(column, std::min(low.Column, high.Column)), std::max(low.Column, high.Column));
  }

  void Add(float column)
  {
    this->Left = std::min(this->Left, column);
    this->Right = std::max(this->Right, column);
  }
};

int Clamped(float value, int least, int greatest)
{
  return static_cast<int>(
    std::min(std::max(std::floor(value), static_cast<float>(least)), static_cast<float>(greatest)));
}
}

void OutlineCoverage::Insert(SBuffer& buffer, const MeshProjection& projection,
  MeshProjection::Facing facing, std::uint32_t face)
{
  this->Projection = &projection;
  if (!this->FrameCells(buffer))
  {
    return;
  }
  this->FindOutline(facing);
  this->BoundDepths(facing);
  for (int line = this->FirstLine; line <= this->LastLine; ++line)
  {
    this->InsertLine(buffer, line, face);
  }
}

/** Find the cells around all points; returns whether any line may be covered. */
bool OutlineCoverage::FrameCells(const SBuffer& buffer)
{
  const ScreenRectangle& around = this->Projection->Rectangle();
  this->ColumnCount = static_cast<float>(buffer.Columns());
  const float top = static_cast<float>(buffer.Lines());
  const bool isOnScreen = around.Left < this->ColumnCount && around.Right > 0.0f &&
    around.Bottom < top && around.Top > 0.0f;
  if (!isOnScreen || !(around.Top - around.Bottom >= 1.0f))
  {
    return false;
  }
  this->FirstLine = Clamped(std::ceil(around.Bottom), 0, buffer.Lines() - 1);
  this->LastLine = Clamped(around.Top - 1.0f, 0, buffer.Lines() - 1);
  const int lastTile = (buffer.Columns() - 1) / SBuffer::TileWidth;
  this->FirstTile = Clamped(around.Left / SBuffer::TileWidth, 0, lastTile);
  this->LastTile = Clamped(around.Right / SBuffer::TileWidth, 0, lastTile);
  return this->FirstLine <= this->LastLine;
}

void OutlineCoverage::FindOutline(MeshProjection::Facing facing)
{
  this->Passages.clear();
  this->Heads.assign(static_cast<std::size_t>(this->LastLine - this->FirstLine + 1), None);
  const std::vector<ScreenPoint>& points = this->Projection->Points();
  for (const OccluderMesh::Edge& edge : this->Projection->Mesh().Edges())
  {
    const bool left = this->Projection->FacingOf(edge.Left) == facing;
    const bool right =
      edge.Right != OccluderMesh::NoFace && this->Projection->FacingOf(edge.Right) == facing;
    if (left != right)
    {
      // What counts lies left of an edge of the outline; of back faces, right of it.
      const bool isForward = left == (facing == MeshProjection::Facing::Front);
      this->AddEdge(
        points[isForward ? edge.From : edge.To], points[isForward ? edge.To : edge.From]);
    }
  }
}

/** An edge with what is covered on its left. */
void OutlineCoverage::AddEdge(const ScreenPoint& from, const ScreenPoint& to)
{
  const bool isUp = from.Line < to.Line;
  const ScreenPoint& low = isUp ? from : to;
  const ScreenPoint& high = isUp ? to : from;
  const ScreenMargin& margin = this->Projection->Margin();
  const float own = OwnRounding *
    (std::abs(low.Column) + std::abs(high.Column) + std::abs(low.Line) + std::abs(high.Line));
  const float aside = margin.Column + own;
  const float above = margin.Line + own;
  if (!(low.Line - above <= static_cast<float>(this->LastLine + 1) &&
        high.Line + above >= static_cast<float>(this->FirstLine)))
  {
    return;
  }
  const int first = Clamped(low.Line - above, this->FirstLine, this->LastLine);
  const int last = Clamped(high.Line + above, this->FirstLine, this->LastLine);
  for (int line = first; line <= last; ++line)
  {
    const float bottom = static_cast<float>(line);
    Extent extent;
    extent.AddBetween(low, high, bottom - above, bottom + 1.0f + above);
    const float middle = bottom + 0.5f;
    const bool isCrossed = low.Line <= middle && middle < high.Line;
    if (extent.Left <= extent.Right)
    {
      this->AddPassage(
        line, extent.Left - aside, extent.Right + aside, isCrossed ? (isUp ? -1 : 1) : 0);
    }
  }
}

void OutlineCoverage::AddPassage(int line, float left, float right, int winding)
{
  std::uint32_t& head = this->Heads[static_cast<std::size_t>(line - this->FirstLine)];
  this->Passages.push_back({ left, right, winding, head });
  head = static_cast<std::uint32_t>(this->Passages.size() - 1);
}

void OutlineCoverage::BoundDepths(MeshProjection::Facing facing)
{
  const int lines = this->LastLine - this->FirstLine + 1;
  const int tiles = this->LastTile - this->FirstTile + 1;
  this->HasOneBound = lines <= FewLines && tiles <= FewTiles;
  if (this->HasOneBound)
  {
    this->BoundByFarthest(facing);
    return;
  }
  this->Bounds.assign(static_cast<std::size_t>(lines) * tiles, { NoDepth, NoDepth });
  const std::vector<OccluderMesh::Face>& faces = this->Projection->Mesh().Faces();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (this->Projection->FacingOf(i) == facing)
    {
      this->BoundByFace(faces[i]);
    }
  }
}

void OutlineCoverage::BoundByFarthest(MeshProjection::Facing facing)
{
  const std::vector<OccluderMesh::Face>& faces = this->Projection->Mesh().Faces();
  const std::vector<ScreenPoint>& points = this->Projection->Points();
  float farthest = NoDepth;
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (this->Projection->FacingOf(i) == facing)
    {
      for (const std::uint32_t corner : faces[i])
      {
        farthest = std::min(farthest, points[corner].Depth);
      }
    }
  }
  farthest -= this->Projection->Margin().Depth;
  this->Bounds.assign(1, { farthest, farthest });
}

void OutlineCoverage::BoundByFace(const OccluderMesh::Face& face)
{
  const std::vector<ScreenPoint>& points = this->Projection->Points();
  const ScreenPoint* corners[3] = { &points[face[0]], &points[face[1]], &points[face[2]] };
  std::sort(corners, corners + 3,
    [](const ScreenPoint* a, const ScreenPoint* b) { return a->Line < b->Line; });
  const ScreenPoint& low = *corners[0];
  const ScreenPoint& middle = *corners[1];
  const ScreenPoint& high = *corners[2];

  // The plane through the corners; where it is too steep to be known, the farthest corner is the better bound.
  const float column1 = middle.Column - low.Column, line1 = middle.Line - low.Line;
  const float column2 = high.Column - low.Column, line2 = high.Line - low.Line;
  const float area = column1 * line2 - column2 * line1;
  const float depth1 = middle.Depth - low.Depth, depth2 = high.Depth - low.Depth;
  const float byColumn = (depth1 * line2 - depth2 * line1) / area;
  const float byLine = (depth2 * column1 - depth1 * column2) / area;
  const ScreenMargin& margin = this->Projection->Margin();
  const float own = OwnRounding *
    (std::abs(low.Column) + std::abs(high.Column) + std::abs(middle.Column) + std::abs(low.Line) +
      std::abs(high.Line) + SBuffer::TileWidth);
  const float aside = margin.Column + own;
  const float above = margin.Line + own;
  const float least = std::min(std::min(low.Depth, middle.Depth), high.Depth);
  const float greatest = std::max(std::max(low.Depth, middle.Depth), high.Depth);
  // The slimmer a face, the less is known of how it is inclined.
  const float slimness =
    (std::abs(column1) + std::abs(column2)) * (std::abs(line1) + std::abs(line2)) / std::abs(area);
  const float slack = margin.Depth + std::abs(byColumn) * aside + std::abs(byLine) * above +
    (greatest - least) * slimness * OwnRounding;
  const float farthest = least - margin.Depth;

  if (!(low.Line - above <= static_cast<float>(this->LastLine + 1) &&
        high.Line + above >= static_cast<float>(this->FirstLine)))
  {
    return;
  }
  const int first = Clamped(low.Line - above, this->FirstLine, this->LastLine);
  const int last = Clamped(high.Line + above, this->FirstLine, this->LastLine);
  const int tiles = this->LastTile - this->FirstTile + 1;
  for (int line = first; line <= last; ++line)
  {
    const float bottom = std::max(static_cast<float>(line) - above, low.Line);
    const float top = std::min(static_cast<float>(line) + 1.0f + above, high.Line);
    Extent extent;
    extent.AddBetween(low, middle, bottom, top);
    extent.AddBetween(middle, high, bottom, top);
    extent.AddBetween(low, high, bottom, top);
    const int firstTile =
      Clamped((extent.Left - aside) / SBuffer::TileWidth, this->FirstTile, this->LastTile);
    const int lastTile =
      Clamped((extent.Right + aside) / SBuffer::TileWidth, this->FirstTile, this->LastTile);
    const float farLine = byLine > 0.0f ? bottom : top;
    const float atZero = low.Depth - low.Column * byColumn + (farLine - low.Line) * byLine - slack;
    Bound* bounds = &this->Bounds[static_cast<std::size_t>(line - this->FirstLine) * tiles];
    for (int tile = firstTile; tile <= lastTile; ++tile)
    {
      const float column = static_cast<float>(tile * SBuffer::TileWidth);
      Bound bound{ atZero + column * byColumn, atZero + (column + SBuffer::TileWidth) * byColumn };
      if (!(bound.Left + bound.Right > 2.0f * farthest))
      {
        bound = { farthest, farthest };
      }
      Bound& known = bounds[tile - this->FirstTile];
      known.Left = std::min(known.Left, bound.Left);
      known.Right = std::min(known.Right, bound.Right);
    }
  }
}

void OutlineCoverage::InsertLine(SBuffer& buffer, int line, std::uint32_t face)
{
  this->Sorted.clear();
  for (std::uint32_t i = this->Heads[static_cast<std::size_t>(line - this->FirstLine)]; i != None;
       i = this->Passages[i].Next)
  {
    this->Sorted.push_back(this->Passages[i]);
  }
  std::sort(this->Sorted.begin(), this->Sorted.end(),
    [](const Passage& a, const Passage& b) { return a.Left < b.Left; });
  int cover = 0;
  float reached = -3e38f;
  for (const Passage& passage : this->Sorted)
  {
    if (cover > 0 && passage.Left > reached)
    {
      this->InsertInterval(
        buffer, line, std::max(reached, 0.0f), std::min(passage.Left, this->ColumnCount), face);
    }
    cover += passage.Winding;
    reached = std::max(reached, passage.Right);
  }
}

void OutlineCoverage::InsertInterval(
  SBuffer& buffer, int line, float left, float right, std::uint32_t face) const
{
  if (!(left < right))
  {
    return;
  }
  if (this->HasOneBound)
  {
    buffer.Insert(line, { left, right, this->Bounds[0].Left, this->Bounds[0].Left, face });
    return;
  }
  const int tiles = this->LastTile - this->FirstTile + 1;
  const Bound* bounds = &this->Bounds[static_cast<std::size_t>(line - this->FirstLine) * tiles];
  const int first = Clamped(left / SBuffer::TileWidth, this->FirstTile, this->LastTile);
  const int last = Clamped(right / SBuffer::TileWidth, this->FirstTile, this->LastTile);
  for (int tile = first; tile <= last; ++tile)
  {
    const float tileLeft = static_cast<float>(tile * SBuffer::TileWidth);
    const float from = std::max(left, tileLeft);
    const float to = std::min(right, tileLeft + SBuffer::TileWidth);
    const Bound& bound = bounds[tile - this->FirstTile];
    if (!(std::min(bound.Left, bound.Right) <= GreatestDepth))
    {
      continue;
    }
    const float slope = (bound.Right - bound.Left) / SBuffer::TileWidth;
    buffer.Insert(line,
      { from, to, bound.Left + (from - tileLeft) * slope, bound.Left + (to - tileLeft) * slope,
        face });
  }
}

}
