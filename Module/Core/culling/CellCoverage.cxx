#include "Core/culling/CellCoverage.h"

#include "Core/culling/LineExtent.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

std::size_t CellCoverage::Insert(
  SBuffer& buffer, MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part)
{
  projection.FindFacings();
  this->Projection = &projection;
  this->Counted = facing;
  this->Margin = projection.Margin();
  this->Inset = buffer.Samples().Inset();
  this->ColumnCount = static_cast<float>(buffer.Columns());
  if (!this->FrameCells(buffer))
  {
    return 0;
  }
  this->FindFacePieces();
  this->FindEdgePieces();
  this->Parents.resize(this->FacePieces.size());
  for (int line = this->FirstLine; line <= this->LastLine; ++line)
  {
    this->InsertLine(buffer, line, part);
  }
  return this->FacePieces.size() + this->EdgePieces.size();
}

/** Find the lines and tiles around all that counts; returns whether any line may be covered. */
bool CellCoverage::FrameCells(const SBuffer& buffer)
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
  if (!(columns.Left < static_cast<float>(buffer.Columns()) && columns.Right > 0.0f &&
        lines.Left < static_cast<float>(buffer.Lines()) && lines.Right > 0.0f &&
        lines.Right - lines.Left >= 1.0f - 2.0f * this->Inset))
  {
    return false;
  }
  const int lastTile = (buffer.Columns() - 1) / SBuffer::TileWidth;
  this->FirstLine = FloorWithin(std::ceil(lines.Left - this->Inset), 0, buffer.Lines() - 1);
  this->LastLine = FloorWithin(lines.Right - 1.0f + this->Inset, 0, buffer.Lines() - 1);
  this->FirstTile = FloorWithin(columns.Left / SBuffer::TileWidth, 0, lastTile);
  this->LastTile = FloorWithin(columns.Right / SBuffer::TileWidth, 0, lastTile);
  return this->FirstLine <= this->LastLine;
}

void CellCoverage::FindFacePieces()
{
  this->FacePieces.clear();
  this->FaceHeads.assign(static_cast<std::size_t>(this->LastLine - this->FirstLine + 1), None);
  this->PieceOfFace.assign(this->Projection->Faces().size(), None);
  for (std::uint32_t i = 0; i < this->PieceOfFace.size(); ++i)
  {
    if (this->Projection->FacingOf(i) == this->Counted)
    {
      this->AddFace(i);
    }
  }
}

void CellCoverage::AddFace(std::uint32_t face)
{
  const OccluderMesh::Face& corners = this->Projection->Faces()[face];
  const ScreenEdge edges[3] = { { this->Projection->Point(corners[0]),
                                  this->Projection->Point(corners[1]) },
    { this->Projection->Point(corners[1]), this->Projection->Point(corners[2]) },
    { this->Projection->Point(corners[2]), this->Projection->Point(corners[0]) } };
  LineExtent width, height;
  float own = 0.0f;
  for (const ScreenEdge& edge : edges)
  {
    width.Add(edge.Bottom().Column);
    width.Add(edge.Top().Column);
    height.Add(edge.Bottom().Line);
    height.Add(edge.Top().Line);
    own = std::max(own, edge.OwnRounding());
  }
  const float above = this->Above(own);
  const float aside = this->Aside(own);
  if (!(width.Left - aside <= this->ColumnCount && width.Right + aside >= 0.0f))
  {
    return;
  }
  const LineRange lines =
    LinesBetween(height.Left - above, height.Right + above, { this->FirstLine, this->LastLine });
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    const float bottom = static_cast<float>(line);
    LineExtent touched, middle;
    for (const ScreenEdge& edge : edges)
    {
      touched.Add(edge, bottom - above, bottom + 1.0f + above);
      if (edge.Crosses(bottom + 0.5f))
      {
        middle.Add(edge.At(bottom + 0.5f));
      }
    }
    if (!touched.IsEmpty())
    {
      std::uint32_t& head = this->FaceHeads[static_cast<std::size_t>(line - this->FirstLine)];
      this->FacePieces.push_back({ face, { touched.Left - aside, touched.Right + aside },
        { middle.Left, middle.Right }, head });
      head = static_cast<std::uint32_t>(this->FacePieces.size() - 1);
    }
  }
}

void CellCoverage::FindEdgePieces()
{
  this->EdgePieces.clear();
  this->EdgeHeads.assign(static_cast<std::size_t>(this->LastLine - this->FirstLine + 1), None);
  for (const OccluderMesh::Edge& edge : this->Projection->Edges())
  {
    const bool left = this->Projection->FacingOf(edge.Left) == this->Counted;
    const bool right =
      edge.Right != OccluderMesh::NoFace && this->Projection->FacingOf(edge.Right) == this->Counted;
    if (left || right)
    {
      this->AddEdge(edge, left ? edge.Left : edge.Right, left && right ? edge.Right : None);
    }
  }
}

void CellCoverage::AddEdge(const OccluderMesh::Edge& edge, std::uint32_t left, std::uint32_t right)
{
  const ScreenEdge onScreen(this->Projection->Point(edge.From), this->Projection->Point(edge.To));
  const float above = this->Above(onScreen.OwnRounding());
  const float aside = this->Aside(onScreen.OwnRounding());
  const LineRange lines = LinesBetween(onScreen.Bottom().Line - above, onScreen.Top().Line + above,
    { this->FirstLine, this->LastLine });
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    const float bottom = static_cast<float>(line);
    LineExtent touched;
    touched.Add(onScreen, bottom - above, bottom + 1.0f + above);
    if (!touched.IsEmpty())
    {
      std::uint32_t& head = this->EdgeHeads[static_cast<std::size_t>(line - this->FirstLine)];
      this->EdgePieces.push_back(
        { left, right, { touched.Left - aside, touched.Right + aside }, head });
      head = static_cast<std::uint32_t>(this->EdgePieces.size() - 1);
    }
  }
}

void CellCoverage::InsertLine(SBuffer& buffer, int line, std::uint32_t part)
{
  const std::size_t tiles = static_cast<std::size_t>(this->LastTile - this->FirstTile + 1);
  this->Entries.clear();
  this->TileFaces.assign(tiles, None);
  this->TileEdges.assign(tiles, None);
  const std::size_t index = static_cast<std::size_t>(line - this->FirstLine);
  for (std::uint32_t i = this->FaceHeads[index]; i != None; i = this->FacePieces[i].Next)
  {
    this->PieceOfFace[this->FacePieces[i].Face] = i;
    this->Parents[i] = i;
    this->Deal(this->FacePieces[i].Touched, i, this->TileFaces);
  }
  for (std::uint32_t i = this->EdgeHeads[index]; i != None; i = this->EdgePieces[i].Next)
  {
    this->Deal(this->EdgePieces[i].Touched, i, this->TileEdges);
  }
  for (int tile = this->FirstTile; tile <= this->LastTile;)
  {
    const TileRange alike{ tile, this->LastLike(tile) };
    this->InsertCells(buffer, line, alike, part);
    tile = alike.Last + 1;
  }
  for (std::uint32_t i = this->FaceHeads[index]; i != None; i = this->FacePieces[i].Next)
  {
    this->PieceOfFace[this->FacePieces[i].Face] = None;
  }
}

/** Put a piece into the tiles that it touches. */
void CellCoverage::Deal(
  const Interval& touched, std::uint32_t piece, std::vector<std::uint32_t>& heads)
{
  const float first = static_cast<float>(this->FirstTile * SBuffer::TileWidth);
  const float end = static_cast<float>((this->LastTile + 1) * SBuffer::TileWidth);
  if (!(touched.Left <= end && touched.Right >= first))
  {
    return;
  }
  const int last = FloorWithin(touched.Right / SBuffer::TileWidth, this->FirstTile, this->LastTile);
  for (int tile = FloorWithin(touched.Left / SBuffer::TileWidth, this->FirstTile, this->LastTile);
       tile <= last; ++tile)
  {
    std::uint32_t& head = heads[static_cast<std::size_t>(tile - this->FirstTile)];
    this->Entries.push_back({ piece, head });
    head = static_cast<std::uint32_t>(this->Entries.size() - 1);
  }
}

/** The last of the tiles from one on that have nothing but the same face, as those in the midst of a large one: they are one cell. */
int CellCoverage::LastLike(int tile) const
{
  const auto onlyFaceOf = [&](int other)
  {
    const std::size_t index = static_cast<std::size_t>(other - this->FirstTile);
    const std::uint32_t first = this->TileFaces[index];
    const bool isAlone =
      first != None && this->Entries[first].Next == None && this->TileEdges[index] == None;
    return isAlone ? this->Entries[first].Piece : None;
  };
  const std::uint32_t face = onlyFaceOf(tile);
  while (face != None && tile < this->LastTile && onlyFaceOf(tile + 1) == face)
  {
    ++tile;
  }
  return tile;
}

void CellCoverage::InsertCells(
  SBuffer& buffer, int line, const TileRange& tiles, std::uint32_t part)
{
  const std::size_t index = static_cast<std::size_t>(tiles.First - this->FirstTile);
  int open = tiles.First;
  while (
    open <= tiles.Last && buffer.IsCoveredBefore(line, open, this->Projection->Rectangle().Nearest))
  {
    ++open;
  }
  if (this->TileFaces[index] == None || open > tiles.Last)
  {
    return;
  }
  this->FindSheets(index);
  std::sort(this->Shares.begin(), this->Shares.end(),
    [](const Share& a, const Share& b) { return a.Sheet < b.Sheet; });
  for (std::size_t first = 0; first < this->Shares.size();)
  {
    std::size_t end = first + 1;
    while (end < this->Shares.size() && this->Shares[end].Sheet == this->Shares[first].Sheet)
    {
      ++end;
    }
    this->InsertSheet(buffer, line, tiles, first, end, part);
    first = end;
  }
}

/** Join the faces of a tile, and tell its shares and cuts by sheet. */
void CellCoverage::FindSheets(std::size_t index)
{
  this->Shares.clear();
  this->Cuts.clear();
  for (std::uint32_t i = this->TileFaces[index]; i != None; i = this->Entries[i].Next)
  {
    this->Parents[this->Entries[i].Piece] = this->Entries[i].Piece;
    this->Shares.push_back({ None, this->Entries[i].Piece });
  }
  for (std::uint32_t i = this->TileEdges[index]; i != None; i = this->Entries[i].Next)
  {
    const EdgePiece& edge = this->EdgePieces[this->Entries[i].Piece];
    const std::uint32_t left = this->PieceOfFace[edge.Left];
    const std::uint32_t right = edge.Right == None ? None : this->PieceOfFace[edge.Right];
    if (left != None && right != None)
    {
      const std::uint32_t a = this->SheetOf(left);
      const std::uint32_t b = this->SheetOf(right);
      this->Parents[std::max(a, b)] = std::min(a, b);
    }
    else if (left != None || right != None)
    {
      this->Cuts.push_back({ left != None ? left : right, edge.Touched });
    }
  }
  for (Share& share : this->Shares)
  {
    share.Sheet = this->SheetOf(share.Piece);
  }
  for (Cut& cut : this->Cuts)
  {
    cut.Sheet = this->SheetOf(cut.Sheet);
  }
}

/** The first piece of the sheet that a piece is of; shortens the way there (R. E. Tarjan, 1975). */
std::uint32_t CellCoverage::SheetOf(std::uint32_t piece)
{
  while (this->Parents[piece] != piece)
  {
    this->Parents[piece] = this->Parents[this->Parents[piece]];
    piece = this->Parents[piece];
  }
  return piece;
}

void CellCoverage::InsertSheet(SBuffer& buffer, int line, const TileRange& tiles, std::size_t first,
  std::size_t end, std::uint32_t part)
{
  const float tileLeft = static_cast<float>(tiles.First * SBuffer::TileWidth);
  const float tileRight = static_cast<float>((tiles.Last + 1) * SBuffer::TileWidth);
  this->Covered.clear();
  for (std::size_t i = first; i < end; ++i)
  {
    const Interval& middle = this->FacePieces[this->Shares[i].Piece].Middle;
    if (middle.Left < middle.Right && middle.Left < tileRight && middle.Right > tileLeft)
    {
      this->Covered.push_back(middle);
    }
  }
  if (this->Covered.empty())
  {
    return;
  }
  this->Open.clear();
  for (const Cut& cut : this->Cuts)
  {
    if (cut.Sheet == this->Shares[first].Sheet)
    {
      this->Open.push_back(cut.Touched);
    }
  }
  const auto byLeft = [](const Interval& a, const Interval& b) { return a.Left < b.Left; };
  std::sort(this->Covered.begin(), this->Covered.end(), byLeft);
  std::sort(this->Open.begin(), this->Open.end(), byLeft);
  const DepthBound bound = this->BoundSheet(line, tiles, first, end);
  const float slope = (bound.Right - bound.Left) / (tileRight - tileLeft);
  const auto insert = [&](float left, float right)
  {
    if (left < right)
    {
      buffer.Insert(line,
        { left, right, bound.Left + (left - tileLeft) * slope,
          bound.Left + (right - tileLeft) * slope, part });
    }
  };

  // What is covered and not open, from left to right.
  std::size_t open = 0;
  float reached = tileLeft;
  for (std::size_t i = 0; i < this->Covered.size();)
  {
    float left = std::max(this->Covered[i].Left, tileLeft);
    float right = this->Covered[i].Right;
    for (++i; i < this->Covered.size() && this->Covered[i].Left <= right; ++i)
    {
      right = std::max(right, this->Covered[i].Right);
    }
    right = std::min(right, tileRight);
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

DepthBound CellCoverage::BoundSheet(
  int line, const TileRange& tiles, std::size_t first, std::size_t end) const
{
  const float left = static_cast<float>(tiles.First * SBuffer::TileWidth);
  const float right = static_cast<float>((tiles.Last + 1) * SBuffer::TileWidth);
  DepthBound bound{ 2.0f, 2.0f };
  for (std::size_t i = first; i < end; ++i)
  {
    const FacePiece& piece = this->FacePieces[this->Shares[i].Piece];
    const OccluderMesh::Face& face = this->Projection->Faces()[piece.Face];
    const ScreenPoint a = this->Projection->Point(face[0]);
    const ScreenPoint b = this->Projection->Point(face[1]);
    const ScreenPoint c = this->Projection->Point(face[2]);
    const float above = this->Margin.Line;
    const float lowest = std::min(std::min(a.Line, b.Line), c.Line) - above;
    const float highest = std::max(std::max(a.Line, b.Line), c.Line) + above;
    const DepthPlane plane(a, b, c, this->Margin, this->Margin.Column, above);
    const DepthBound own =
      plane.Within(left, right, std::max(static_cast<float>(line) + this->Inset, lowest),
        std::min(static_cast<float>(line + 1) - this->Inset, highest));
    bound.Left = std::min(bound.Left, own.Left);
    bound.Right = std::min(bound.Right, own.Right);
  }
  // A span's numbers are as coarse as its farther end.
  const float coarse = 0x1p-21f * std::abs(bound.Right - bound.Left);
  return { bound.Left - coarse, bound.Right - coarse };
}

}
