#include "Core/culling/cover/FaceCoverage.h"

#include "Core/culling/screen/LineExtent.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// An edge that touches more columns has a depth of its own.
const float ThinEdge = 0.125f;

// If more edges than this touch each other, their patches have a depth for each tile.
const std::size_t FewEdges = 4;

const float NoEdgeDepth = 2.0f; // above all depths
}

std::size_t FaceCoverage::Insert(SBuffer& buffer, const MeshProjection& projection,
  MeshProjection::Facing facing, std::uint32_t part)
{
  this->Projection = &projection;
  this->Counted = facing;
  this->Buffer = &buffer;
  this->Part = part;
  this->Inset = buffer.Samples().Inset();
  this->ColumnCount = static_cast<float>(buffer.Columns());
  this->Segments = 0;
  if (!this->FrameLines(buffer))
  {
    return 0;
  }
  this->Patches.Find(projection, facing, buffer.Samples());
  const LineRange lines{ this->FirstLine, this->LastLine };
  this->Open.Find(buffer, this->Patches, lines);
  if (!this->Open.HasAny())
  {
    return 1;
  }
  this->OnLine.assign(this->Patches.Count(), {});
  this->Visits = 0;
  this->Edges.Find({ &projection, facing, &this->Patches, &this->Open, lines, this->Inset });
  for (this->Line = this->FirstLine; this->Line <= this->LastLine; ++this->Line)
  {
    if (this->Open.IsOpen(this->Line))
    {
      this->InsertLine();
    }
  }
  return this->Edges.Count() + this->Segments;
}

/** Finds the lines around all faces that count. Returns true if any line may be covered. */
bool FaceCoverage::FrameLines(const SBuffer& buffer)
{
  const std::vector<MeshFace>& faces = this->Projection->Faces();
  LineExtent columns, lines;
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (this->Projection->FacingOf(i) == this->Counted)
    {
      for (const std::uint32_t corner : faces[i])
      {
        columns.Add(this->Projection->Point(corner).Column);
        lines.Add(this->Projection->Point(corner).Line);
      }
    }
  }
  if (!(columns.Left < this->ColumnCount && columns.Right > 0.0f &&
        lines.Left < static_cast<float>(buffer.Lines()) && lines.Right > 0.0f &&
        lines.Right - lines.Left >= 1.0f - 2.0f * this->Inset))
  {
    return false;
  }
  this->FirstLine = FloorWithin(std::ceil(lines.Left - this->Inset), 0, buffer.Lines() - 1);
  this->LastLine = FloorWithin(lines.Right - 1.0f + this->Inset, 0, buffer.Lines() - 1);
  return this->FirstLine <= this->LastLine;
}

/** Inserts the current line, sheet by sheet, each from left to right. */
void FaceCoverage::InsertLine()
{
  this->SortPieces();
  for (std::size_t first = 0; first < this->Sorted.size();)
  {
    const Cluster cluster = this->ClusterFrom(first);
    this->InsertCluster(cluster);
    first = cluster.End;
  }
}

void FaceCoverage::SortPieces()
{
  this->Sorted.clear();
  this->Edges.ForEachOn(this->Line,
    [this](const EdgePiece& piece) {
      this->Sorted.push_back({ piece.Sheet, piece.Touched.Left, &piece });
    });
  std::sort(this->Sorted.begin(), this->Sorted.end());
}

FaceCoverage::Cluster FaceCoverage::ClusterFrom(std::size_t first) const
{
  Interval around = this->Sorted[first].Piece->Touched;
  const auto isInSheet = [&](std::size_t i)
  { return i < this->Sorted.size() && this->Sorted[i].Sheet == this->Sorted[first].Sheet; };
  std::size_t end = first + 1;
  for (; isInSheet(end) && this->Sorted[end].Left <= around.Right; ++end)
  {
    around.Right = std::max(around.Right, this->Sorted[end].Piece->Touched.Right);
  }
  return { first, end, around, isInSheet(end) ? this->Sorted[end].Left : around.Right };
}

FaceCoverage::PatchOnLine& FaceCoverage::OnLineOf(std::uint32_t patch)
{
  PatchOnLine& onLine = this->OnLine[patch];
  if (onLine.Line != this->Line)
  {
    onLine = PatchOnLine{};
    onLine.Line = this->Line;
  }
  return onLine;
}

void FaceCoverage::InsertCluster(const Cluster& cluster)
{
  if (this->IsLeftToPatches(cluster))
  {
    this->LeaveToPatches(*this->Sorted[cluster.First].Piece);
    return;
  }
  this->InsertEdges(cluster);
  this->PassEdges(cluster);
}

bool FaceCoverage::HasSamples(const Interval& columns) const
{
  return this->Buffer->Samples().HasAny(columns.Left, columns.Right);
}

/** Returns true if the cluster is a single edge that is left to the patches on both sides. */
bool FaceCoverage::IsLeftToPatches(const Cluster& cluster)
{
  const EdgePiece& edge = *this->Sorted[cluster.First].Piece;
  const bool isThin = edge.Touched.Right - edge.Touched.Left < ThinEdge;
  if (cluster.End - cluster.First > 1 || edge.IsOutline() || !isThin || !edge.IsCrossing)
  {
    return false;
  }
  const PatchOnLine& left = this->OnLineOf(edge.Left);
  const PatchOnLine& right = this->OnLineOf(edge.Right);
  return left.Cover == 1 && right.Cover == 0 &&
    edge.Touched.Left - std::max(left.Begins.Right, 0.0f) > ThinEdge &&
    std::min(cluster.NextLeft, this->ColumnCount) - edge.Touched.Right > ThinEdge;
}

/** Lets both patches reach up to the edge. Where the edge touches the line, both get the depth of the farther one. */
void FaceCoverage::LeaveToPatches(const EdgePiece& edge)
{
  this->Beside = { edge.Left, edge.Right };
  const DepthBound bound = this->BoundBeside(edge.Touched);
  const float farthest = std::min(bound.Left, bound.Right);
  PatchOnLine& left = this->OnLine[edge.Left];
  this->InsertInside(edge.Left, left, { edge.Touched.Left, edge.Middle }, farthest);
  left.Cover = 0;
  left.Begins = { edge.Touched.Right, edge.Touched.Right };
  left.BeginDepth = NoEdgeDepth;
  PatchOnLine& right = this->OnLine[edge.Right];
  right.Cover = 1;
  right.Begins = { edge.Middle, edge.Touched.Right };
  right.BeginDepth = farthest;
}

/** Inserts the columns that edges touch and that are covered all the same. */
void FaceCoverage::InsertEdges(const Cluster& cluster)
{
  const Interval shown{ std::max(cluster.Around.Left, 0.0f),
    std::min(cluster.Around.Right, this->ColumnCount) };
  if (shown.IsEmpty() || !this->HasSamples(shown) ||
    (cluster.End - cluster.First == 1 && this->Sorted[cluster.First].Piece->IsOutline()))
  {
    return;
  }
  this->SortCrossings(cluster);
  for (float left = shown.Left; left < shown.Right;)
  {
    const float side = (std::floor(left / SBuffer::TileWidth) + 1.0f) * SBuffer::TileWidth;
    const bool isWhole = cluster.End - cluster.First <= FewEdges;
    const float right = isWhole ? shown.Right : std::min(side, shown.Right);
    this->CrossUpTo(left);
    if (this->HasSamples({ left, right }))
    {
      this->FindBeside(cluster, { left, right });
      this->InsertPiece({ left, right });
    }
    left = right;
  }
}

void FaceCoverage::SortCrossings(const Cluster& cluster)
{
  this->Crossings.clear();
  this->Crossed = 0;
  for (std::size_t i = cluster.First; i < cluster.End; ++i)
  {
    const EdgePiece& edge = *this->Sorted[i].Piece;
    for (const std::uint32_t patch : { edge.Left, edge.Right })
    {
      if (patch != None)
      {
        PatchOnLine& onLine = this->OnLineOf(patch);
        onLine.CoverOfPiece = onLine.Cover;
      }
    }
    if (edge.IsCrossing)
    {
      this->Crossings.push_back(&edge);
    }
  }
  std::sort(this->Crossings.begin(), this->Crossings.end(),
    [](const EdgePiece* a, const EdgePiece* b) { return a->Middle < b->Middle; });
}

/** Finds how often patches of the cluster cover a column. */
void FaceCoverage::CrossUpTo(float column)
{
  for (; this->Crossed < this->Crossings.size() && this->Crossings[this->Crossed]->Middle <= column;
       ++this->Crossed)
  {
    const EdgePiece& edge = *this->Crossings[this->Crossed];
    if (edge.Left != None)
    {
      --this->OnLine[edge.Left].CoverOfPiece;
    }
    if (edge.Right != None)
    {
      ++this->OnLine[edge.Right].CoverOfPiece;
    }
  }
}

/** Finds the patches on both sides of the edges that touch a piece of a line, and which of the edges are outlines. */
void FaceCoverage::FindBeside(const Cluster& cluster, const Interval& piece)
{
  this->Beside.clear();
  this->Outlines.clear();
  ++this->Visits;
  for (std::size_t i = cluster.First; i < cluster.End; ++i)
  {
    const EdgePiece& edge = *this->Sorted[i].Piece;
    if (!(edge.Touched.Left <= piece.Right && edge.Touched.Right >= piece.Left))
    {
      continue;
    }
    if (edge.IsOutline())
    {
      this->Outlines.push_back(&edge);
    }
    for (const std::uint32_t patch : { edge.Left, edge.Right })
    {
      if (patch != None && this->OnLine[patch].Visit != this->Visits)
      {
        this->OnLine[patch].Visit = this->Visits;
        this->Beside.push_back(patch);
      }
    }
  }
}

/**
 * Inserts a piece. Patches beside its edges together cover it equally often everywhere, but for outlines, which come
 * from left to right.
 */
void FaceCoverage::InsertPiece(const Interval& piece)
{
  int cover = 0;
  for (const std::uint32_t patch : this->Beside)
  {
    cover += this->OnLine[patch].CoverOfPiece;
  }
  if (this->Beside.empty() || (cover <= 0 && this->Outlines.empty()))
  {
    return;
  }
  const DepthBound bound = this->BoundBeside(piece);
  const float slope = (bound.Right - bound.Left) / (piece.Right - piece.Left);
  const auto insert = [&](float left, float right)
  {
    if (cover > 0 && left < right)
    {
      this->InsertSegment({ left, right },
        { bound.Left + (left - piece.Left) * slope, bound.Left + (right - piece.Left) * slope });
    }
  };
  float reached = piece.Left;
  for (const EdgePiece* outline : this->Outlines)
  {
    insert(reached, outline->Touched.Left);
    cover += outline->Middle > piece.Left ? outline->Turn() : 0;
    reached = std::max(reached, outline->Touched.Right);
  }
  insert(reached, piece.Right);
}

/** Inserts what patches cover up to a cluster, and starts what follows behind it. */
void FaceCoverage::PassEdges(const Cluster& cluster)
{
  for (std::size_t i = cluster.First; i < cluster.End; ++i)
  {
    const EdgePiece& edge = *this->Sorted[i].Piece;
    for (const std::uint32_t patch : { edge.Left, edge.Right })
    {
      if (patch != None)
      {
        this->PassEdge(patch, edge);
      }
    }
  }
}

void FaceCoverage::PassEdge(std::uint32_t patch, const EdgePiece& edge)
{
  PatchOnLine& onLine = this->OnLineOf(patch);
  if (onLine.Cover > 0)
  {
    this->InsertInside(patch, onLine, { edge.Touched.Left, edge.Touched.Left }, NoEdgeDepth);
  }
  const float behind = std::max(onLine.Begins.Right, edge.Touched.Right);
  onLine.Begins = { behind, behind };
  onLine.BeginDepth = NoEdgeDepth;
  onLine.Cover += edge.TurnOf(patch);
}

/**
 * Inserts what a patch covers between two of its edges, with the halves of edges that are left to it. The line of its
 * depth is lowered at both ends to what is known of the patches on both sides. The lower depth counts at the inner end
 * of its edge, since the line falls farther beyond. The higher depth counts at the outer end.
 */
void FaceCoverage::InsertInside(
  std::uint32_t patch, const PatchOnLine& begin, const Interval& end, float endDepth)
{
  const Interval whole{ std::max(begin.Begins.Left, 0.0f), std::min(end.Right, this->ColumnCount) };
  const Interval inside{ std::max(begin.Begins.Right, 0.0f),
    std::min(end.Left, this->ColumnCount) };
  if (inside.IsEmpty() || whole.IsEmpty() || !this->HasSamples(whole))
  {
    return;
  }
  DepthBound bound = this->BoundOf(patch, whole);
  bound = { std::min(bound.Left, begin.BeginDepth), std::min(bound.Right, endDepth) };
  const bool rises = bound.Left < bound.Right;
  const float left = rises ? inside.Left : whole.Left, right = rises ? whole.Right : inside.Right;
  const float slope = (bound.Right - bound.Left) / (right - left);
  this->InsertSegment(whole,
    { bound.Left + (whole.Left - left) * slope, bound.Right + (whole.Right - right) * slope });
}

/** Returns the bound of all patches beside the edges of the piece. */
DepthBound FaceCoverage::BoundBeside(const Interval& piece) const
{
  DepthBound bound{ NoEdgeDepth, NoEdgeDepth };
  for (const std::uint32_t patch : this->Beside)
  {
    const DepthBound own = this->BoundOf(patch, piece);
    bound.Left = std::min(bound.Left, own.Left);
    bound.Right = std::min(bound.Right, own.Right);
  }
  return bound;
}

DepthBound FaceCoverage::BoundOf(std::uint32_t number, const Interval& columns) const
{
  const ScreenPatches::Patch& patch = this->Patches[number];
  return patch.Bound.BoundIn(columns.Left, columns.Right,
    std::max(static_cast<float>(this->Line) + this->Inset, patch.Bottom),
    std::min(static_cast<float>(this->Line + 1) - this->Inset, patch.Top));
}

void FaceCoverage::InsertSegment(const Interval& columns, const DepthBound& bound)
{
  // The floats of a span are as coarse as its farther end.
  const float coarse = RoundingOfFloats * std::abs(bound.Right - bound.Left);
  if (!this->IsCovered(columns, std::max(bound.Left, bound.Right)))
  {
    ++this->Segments;
    this->Buffer->Insert(this->Line,
      { columns.Left, columns.Right, bound.Left - coarse, bound.Right - coarse, this->Part });
  }
}

/** Returns true if all tiles are covered by depths that are at least as near. */
bool FaceCoverage::IsCovered(const Interval& columns, float nearest) const
{
  const int lastTile = (this->Buffer->Columns() - 1) / SBuffer::TileWidth;
  const int last = std::min(static_cast<int>(columns.Right) / SBuffer::TileWidth, lastTile);
  int tile = static_cast<int>(columns.Left) / SBuffer::TileWidth;
  while (tile <= last && this->Buffer->IsCoveredBefore(this->Line, tile, nearest))
  {
    ++tile;
  }
  return tile > last;
}

}
