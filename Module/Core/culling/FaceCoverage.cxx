#include "Core/culling/FaceCoverage.h"

#include "Core/culling/LineExtent.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// Edges that touch more columns have a depth of their own.
const float ThinEdge = 0.125f;

// Where so many edges touch each other, their faces have a depth for each tile.
const std::size_t FewEdges = 4;
}

std::size_t FaceCoverage::Insert(SBuffer& buffer, const MeshProjection& projection,
  MeshProjection::Facing facing, std::uint32_t part)
{
  this->Projection = &projection;
  this->Counted = facing;
  this->Buffer = &buffer;
  this->Part = part;
  this->Margin = projection.Margin();
  this->Inset = buffer.Samples().Inset();
  this->ColumnCount = static_cast<float>(buffer.Columns());
  this->Segments = 0;
  if (!this->FrameLines(buffer))
  {
    return 0;
  }
  this->FindFaces();
  this->FindSheets();
  this->FindEdgePieces();
  for (this->Line = this->FirstLine; this->Line <= this->LastLine; ++this->Line)
  {
    this->FindFacesOnLine();
    this->InsertEdges();
    this->InsertInsides();
  }
  return this->EdgePieces.size() + this->Segments;
}

/** Find the lines around all that counts; returns whether any may be covered. */
bool FaceCoverage::FrameLines(const SBuffer& buffer)
{
  const std::vector<OccluderMesh::Face>& faces = this->Projection->Faces();
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

/** Those that count. */
void FaceCoverage::FindFaces()
{
  const std::vector<OccluderMesh::Face>& faces = this->Projection->Faces();
  this->Numbers.assign(faces.size(), None);
  this->Faces.clear();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    const ScreenPoint a = this->Projection->Point(faces[i][0]);
    const ScreenPoint b = this->Projection->Point(faces[i][1]);
    const ScreenPoint c = this->Projection->Point(faces[i][2]);
    const float depths = a.Depth + b.Depth + c.Depth + this->Margin.Depth;
    if (this->Projection->FacingOf(i) != this->Counted || !std::isfinite(depths))
    {
      continue;
    }
    const float above = this->Margin.Line;
    this->Numbers[i] = static_cast<std::uint32_t>(this->Faces.size());
    this->Faces.push_back({ DepthPlane(a, b, c, this->Margin, this->Projection->Snapping()),
      std::min(std::min(a.Line, b.Line), c.Line) - above,
      std::max(std::max(a.Line, b.Line), c.Line) + above });
  }
  this->FacesOnLine.assign(this->Faces.size(), {});
  this->Visits = 0;
  this->Present.clear();
}

/** Join faces that have an edge in common. */
void FaceCoverage::FindSheets()
{
  this->Parents.resize(this->Faces.size());
  for (std::uint32_t i = 0; i < this->Parents.size(); ++i)
  {
    this->Parents[i] = i;
  }
  for (const OccluderMesh::Edge& edge : this->Projection->Edges())
  {
    const std::uint32_t left = this->Numbers[edge.Left];
    const std::uint32_t right =
      edge.Right == OccluderMesh::NoFace ? None : this->Numbers[edge.Right];
    if (left != None && right != None)
    {
      const std::uint32_t a = this->SheetOf(left);
      const std::uint32_t b = this->SheetOf(right);
      this->Parents[std::max(a, b)] = std::min(a, b);
    }
  }
}

/** The first face of the sheet that a face is of; shortens the way there (R. E. Tarjan, 1975). */
std::uint32_t FaceCoverage::SheetOf(std::uint32_t face)
{
  while (this->Parents[face] != face)
  {
    this->Parents[face] = this->Parents[this->Parents[face]];
    face = this->Parents[face];
  }
  return face;
}

void FaceCoverage::FindEdgePieces()
{
  this->EdgePieces.clear();
  this->EdgeHeads.assign(static_cast<std::size_t>(this->LastLine - this->FirstLine + 1), None);
  for (const OccluderMesh::Edge& edge : this->Projection->Edges())
  {
    const std::uint32_t left = this->Numbers[edge.Left];
    const std::uint32_t right =
      edge.Right == OccluderMesh::NoFace ? None : this->Numbers[edge.Right];
    if (left != None || right != None)
    {
      this->AddEdge(edge, left, right);
    }
  }
}

/** @param left, right  of the edge as it goes */
void FaceCoverage::AddEdge(const OccluderMesh::Edge& edge, std::uint32_t left, std::uint32_t right)
{
  const ScreenEdge onScreen(this->Projection->Point(edge.From), this->Projection->Point(edge.To));
  const float own = onScreen.OwnRounding();
  const float above = this->Above(own), aside = this->Aside(own);
  const bool isLeftSmaller = onScreen.GoesUp() == (this->Counted == MeshProjection::Facing::Front);
  const std::uint32_t sheet = this->SheetOf(left != None ? left : right);
  const LineRange lines = LinesBetween(onScreen.Bottom().Line - above, onScreen.Top().Line + above,
    { this->FirstLine, this->LastLine });
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    const float bottom = static_cast<float>(line);
    LineExtent touched;
    touched.Add(onScreen, bottom - above, bottom + 1.0f + above);
    if (!touched.IsEmpty())
    {
      const bool isCrossing = onScreen.Crosses(bottom + 0.5f);
      std::uint32_t& head = this->EdgeHeads[static_cast<std::size_t>(line - this->FirstLine)];
      this->EdgePieces.push_back({ { touched.Left - aside, touched.Right + aside },
        isCrossing ? onScreen.At(bottom + 0.5f) : 0.0f, isLeftSmaller ? left : right,
        isLeftSmaller ? right : left, sheet, isCrossing, head });
      head = static_cast<std::uint32_t>(this->EdgePieces.size() - 1);
    }
  }
}

void FaceCoverage::FindFacesOnLine()
{
  this->OnLine.clear();
  this->Present.clear();
  const std::size_t index = static_cast<std::size_t>(this->Line - this->FirstLine);
  for (std::uint32_t i = this->EdgeHeads[index]; i != None; i = this->EdgePieces[i].Next)
  {
    const EdgePiece& piece = this->EdgePieces[i];
    this->AddToFace(piece.Left, piece, true);
    this->AddToFace(piece.Right, piece, false);
    this->OnLine.push_back({ piece.Sheet, piece.Touched.Left, &piece });
  }
}

/** @param isOnItsRight  whether the edge is on the face's right side */
void FaceCoverage::AddToFace(std::uint32_t face, const EdgePiece& piece, bool isOnItsRight)
{
  if (face == None)
  {
    return;
  }
  FaceOnLine& onLine = this->FacesOnLine[face];
  if (onLine.Line != this->Line)
  {
    onLine = { this->Line, onLine.Visit };
    this->Present.push_back(face);
  }
  if (!piece.IsCrossing)
  {
    onLine.Touched = { std::min(onLine.Touched.Left, piece.Touched.Left),
      std::max(onLine.Touched.Right, piece.Touched.Right) };
  }
  else if (isOnItsRight)
  {
    onLine.Middle.Right = piece.Middle;
    onLine.Inside.Right = piece.Touched.Left;
  }
  else
  {
    onLine.Middle.Left = piece.Middle;
    onLine.Inside.Left = piece.Touched.Right;
  }
}

/** What lies between the edges of faces. */
void FaceCoverage::InsertInsides()
{
  for (const std::uint32_t face : this->Present)
  {
    const FaceOnLine& onLine = this->FacesOnLine[face];
    const Interval& inside = onLine.Inside;
    const Interval& touched = onLine.Touched;
    if (touched.IsEmpty())
    {
      this->InsertWithEdges(face, onLine);
    }
    else
    {
      this->InsertInside(face, { inside.Left, std::min(inside.Right, touched.Left) });
      this->InsertInside(face, { std::max(inside.Left, touched.Right), inside.Right });
    }
  }
}

/**
 * A face and half of what the edges beside it touch, where these are alone. The line of its depth is lowered there to what is known
 * of both faces; on its higher side from where it may be lower on, as it falls farther from there.
 */
void FaceCoverage::InsertWithEdges(std::uint32_t face, const FaceOnLine& onLine)
{
  const bool hasLeft = onLine.LeftDepth < 2.0f, hasRight = onLine.RightDepth < 2.0f;
  const Interval whole{ std::max(hasLeft ? onLine.Middle.Left : onLine.Inside.Left, 0.0f),
    std::min(hasRight ? onLine.Middle.Right : onLine.Inside.Right, this->ColumnCount) };
  const Interval inside{ std::max(onLine.Inside.Left, 0.0f),
    std::min(onLine.Inside.Right, this->ColumnCount) };
  if (inside.IsEmpty() || whole.IsEmpty())
  {
    return;
  }
  DepthBound bound = this->BoundFace(face, whole);
  bound = { std::min(bound.Left, onLine.LeftDepth), std::min(bound.Right, onLine.RightDepth) };
  const bool rises = bound.Left < bound.Right;
  const float left = rises ? inside.Left : whole.Left, right = rises ? whole.Right : inside.Right;
  const float slope = (bound.Right - bound.Left) / (right - left);
  this->InsertSegment(whole,
    { bound.Left + (whole.Left - left) * slope, bound.Right + (whole.Right - right) * slope });
}

void FaceCoverage::InsertInside(std::uint32_t face, const Interval& inside)
{
  const Interval shown{ std::max(inside.Left, 0.0f), std::min(inside.Right, this->ColumnCount) };
  if (!shown.IsEmpty())
  {
    this->InsertSegment(shown, this->BoundFace(face, shown));
  }
}

/** What edges touch: those of a sheet that touch each other together. */
void FaceCoverage::InsertEdges()
{
  std::sort(this->OnLine.begin(), this->OnLine.end());
  for (std::size_t first = 0; first < this->OnLine.size();)
  {
    Interval around = this->OnLine[first].Piece->Touched;
    std::size_t end = first + 1;
    while (end < this->OnLine.size() && this->OnLine[end].Sheet == this->OnLine[first].Sheet &&
      this->OnLine[end].Left <= around.Right)
    {
      around.Right = std::max(around.Right, this->OnLine[end].Piece->Touched.Right);
      ++end;
    }
    const Interval shown{ std::max(around.Left, 0.0f), std::min(around.Right, this->ColumnCount) };
    if (!shown.IsEmpty())
    {
      this->InsertCluster(first, end, shown);
    }
    first = end;
  }
}

void FaceCoverage::InsertCluster(std::size_t first, std::size_t end, const Interval& around)
{
  if (end - first == 1 && this->IsPassed(*this->OnLine[first].Piece))
  {
    return;
  }
  if (end - first <= FewEdges)
  {
    this->InsertPiece(first, end, around);
    return;
  }
  for (float left = around.Left; left < around.Right;)
  {
    const float side = (std::floor(left / SBuffer::TileWidth) + 1.0f) * SBuffer::TileWidth;
    const float right = std::min(side, around.Right);
    this->InsertPiece(first, end, { left, right });
    left = right;
  }
}

/** Whether an edge that is alone is left to the faces on both sides, which are told the farthest depth where it touches the line. */
bool FaceCoverage::IsPassed(const EdgePiece& edge)
{
  const bool isThin = edge.Touched.Right - edge.Touched.Left < ThinEdge;
  if (edge.IsOutline() || !isThin || !edge.IsCrossing || !this->IsWhole(edge.Left) ||
    !this->IsWhole(edge.Right))
  {
    return edge.IsOutline();
  }
  this->Beside = { edge.Left, edge.Right };
  const DepthBound bound = this->BoundPiece(edge.Touched);
  const float farthest = std::min(bound.Left, bound.Right);
  this->FacesOnLine[edge.Left].RightDepth = farthest;
  this->FacesOnLine[edge.Right].LeftDepth = farthest;
  return true;
}

/** Whether nothing but edges that cross the line's middle touches a face on it, and something lies between them on the screen. */
bool FaceCoverage::IsWhole(std::uint32_t face) const
{
  const FaceOnLine& onLine = this->FacesOnLine[face];
  const float left = std::max(onLine.Inside.Left, 0.0f);
  const float right = std::min(onLine.Inside.Right, this->ColumnCount);
  return onLine.Touched.IsEmpty() && right - left > ThinEdge;
}

/** The faces beside the edges from `first` to `end` that touch a piece of a line, and what of it is open. */
void FaceCoverage::FindBeside(std::size_t first, std::size_t end, const Interval& piece)
{
  this->Beside.clear();
  this->Open.clear();
  ++this->Visits;
  for (std::size_t i = first; i < end; ++i)
  {
    const EdgePiece& edge = *this->OnLine[i].Piece;
    if (!(edge.Touched.Left <= piece.Right && edge.Touched.Right >= piece.Left))
    {
      continue;
    }
    if (edge.IsOutline())
    {
      this->Open.push_back(edge.Touched);
    }
    for (const std::uint32_t face : { edge.Left, edge.Right })
    {
      if (face != None && this->FacesOnLine[face].Visit != this->Visits)
      {
        this->FacesOnLine[face].Visit = this->Visits;
        this->Beside.push_back(face);
      }
    }
  }
}

/** What they cover of its middle. */
void FaceCoverage::FindCovered(const Interval& piece)
{
  this->Covered.clear();
  for (const std::uint32_t face : this->Beside)
  {
    const Interval& middle = this->FacesOnLine[face].Middle;
    if (!middle.IsEmpty() && middle.Left < piece.Right && middle.Right > piece.Left)
    {
      this->Covered.push_back(middle);
    }
  }
}

void FaceCoverage::InsertPiece(std::size_t first, std::size_t end, const Interval& piece)
{
  this->FindBeside(first, end, piece);
  this->FindCovered(piece);
  if (this->Covered.empty())
  {
    return;
  }
  const auto byLeft = [](const Interval& a, const Interval& b) { return a.Left < b.Left; };
  std::sort(this->Covered.begin(), this->Covered.end(), byLeft);
  std::sort(this->Open.begin(), this->Open.end(), byLeft);
  const DepthBound bound = this->BoundPiece(piece);
  const float slope = (bound.Right - bound.Left) / (piece.Right - piece.Left);
  const auto insert = [&](float left, float right)
  {
    if (left < right)
    {
      this->InsertSegment({ left, right },
        { bound.Left + (left - piece.Left) * slope, bound.Left + (right - piece.Left) * slope });
    }
  };

  // What is covered and not open, from left to right.
  std::size_t open = 0;
  float reached = piece.Left;
  for (std::size_t i = 0; i < this->Covered.size();)
  {
    float left = std::max(this->Covered[i].Left, piece.Left);
    float right = this->Covered[i].Right;
    for (++i; i < this->Covered.size() && this->Covered[i].Left <= right; ++i)
    {
      right = std::max(right, this->Covered[i].Right);
    }
    right = std::min(right, piece.Right);
    left = std::max(left, reached);
    for (; open < this->Open.size() && this->Open[open].Left < right; ++open)
    {
      insert(left, std::min(right, this->Open[open].Left));
      left = std::max(left, this->Open[open].Right);
    }
    insert(left, right);
    reached = std::max(left, right);
  }
}

/** Of all faces beside the piece's edges. */
DepthBound FaceCoverage::BoundPiece(const Interval& piece) const
{
  DepthBound bound{ 2.0f, 2.0f };
  for (const std::uint32_t face : this->Beside)
  {
    const DepthBound own = this->BoundFace(face, piece);
    bound.Left = std::min(bound.Left, own.Left);
    bound.Right = std::min(bound.Right, own.Right);
  }
  return bound;
}

DepthBound FaceCoverage::BoundFace(std::uint32_t number, const Interval& columns) const
{
  const CountedFace& face = this->Faces[number];
  return face.Plane.Within(columns.Left, columns.Right,
    std::max(static_cast<float>(this->Line) + this->Inset, face.Bottom),
    std::min(static_cast<float>(this->Line + 1) - this->Inset, face.Top));
}

void FaceCoverage::InsertSegment(const Interval& columns, const DepthBound& bound)
{
  // A span's numbers are as coarse as its farther end.
  const float coarse = 0x1p-21f * std::abs(bound.Right - bound.Left);
  if (!this->IsCovered(columns, std::max(bound.Left, bound.Right)))
  {
    ++this->Segments;
    this->Buffer->Insert(this->Line,
      { columns.Left, columns.Right, bound.Left - coarse, bound.Right - coarse, this->Part });
  }
}

/** Whether all tiles are covered by what is at least as near. */
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
