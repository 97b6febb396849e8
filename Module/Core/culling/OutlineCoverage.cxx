#include "Core/culling/OutlineCoverage.h"

#include "Core/culling/LineExtent.h"

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
  this->FindOutline(facing);
  const float depth = this->FarthestOf(facing) - projection.Margin().Depth;
  for (int line = this->FirstLine; line <= this->LastLine; ++line)
  {
    this->InsertLine(buffer, line, depth, part);
  }
  return this->Passages.size();
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
  const ScreenEdge edge(from, to);
  const float aside = this->Projection->Margin().Column + edge.OwnRounding();
  const float above = this->Projection->Margin().Line + edge.OwnRounding() - this->Inset;
  const LineRange lines = LinesBetween(
    edge.Bottom().Line - above, edge.Top().Line + above, { this->FirstLine, this->LastLine });
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    const float bottom = static_cast<float>(line);
    LineExtent extent;
    extent.Add(edge, bottom - above, bottom + 1.0f + above);
    if (!extent.IsEmpty())
    {
      const int winding = edge.Crosses(bottom + 0.5f) ? (edge.GoesUp() ? -1 : 1) : 0;
      std::uint32_t& head = this->Heads[static_cast<std::size_t>(line - this->FirstLine)];
      this->Passages.push_back({ extent.Left - aside, extent.Right + aside, winding, head });
      head = static_cast<std::uint32_t>(this->Passages.size() - 1);
    }
  }
}

float OutlineCoverage::FarthestOf(MeshProjection::Facing facing) const
{
  const std::vector<OccluderMesh::Face>& faces = this->Projection->Mesh().Faces();
  const std::vector<ScreenPoint>& points = this->Projection->Points();
  float farthest = 1.0f;
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
  return farthest;
}

void OutlineCoverage::InsertLine(SBuffer& buffer, int line, float depth, std::uint32_t part)
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
      buffer.Insert(line, { reached, passage.Left, depth, depth, part });
    }
    cover += passage.Winding;
    reached = std::max(reached, passage.Right);
  }
}

}
