#ifndef VITRINE_CORE_CULLING_CELL_COVERAGE_H
#define VITRINE_CORE_CULLING_CELL_COVERAGE_H

#include "Core/culling/DepthPlane.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Puts into an s-buffer what an occluder surely covers, cell by cell: a cell is a line and SBuffer::TileWidth columns.
 *
 * In a cell, faces that are joined by edges which pass the cell are one sheet. Where the middle of a column of the cell is
 * covered by a face of a sheet, and no edge of the sheet that has nothing on its other side passes the column, all of the
 * column is covered by the sheet: on the way up or down a face can be left only for its neighbour. What a rasteriser may move
 * points by widens those edges. The depth is nowhere farther than the farthest of the sheet's planes there.
 *
 * So a line may be much thicker than faces are, without gaps at their edges; and the inside of a far wall, which belongs to
 * another sheet, does not spoil the near one.
 */
class CellCoverage
{
public:
  /**
   * @param projection  of the occluder, of which this finds the facings
   * @param facing      of the faces that count, Front or Back
   * @param part        what spans say whose they are
   * @returns how many pieces of faces and edges on lines that took
   */
  std::size_t Insert(
    SBuffer& buffer, MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part);

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  /** An interval of columns. */
  struct Interval
  {
    float Left;
    float Right;
  };

  struct TileRange
  {
    int First;
    int Last;
  };

  /** A face on a line. */
  struct FacePiece
  {
    std::uint32_t Face;
    Interval Touched;
    Interval Middle; ///< what it covers of the line's middle; empty if Left exceeds Right
    std::uint32_t Next;
  };

  /** An edge on a line: between two faces that count, or at the border of one. */
  struct EdgePiece
  {
    std::uint32_t Left;
    std::uint32_t Right; ///< or None
    Interval Touched;
    std::uint32_t Next;
  };

  /** One of a line's pieces in a tile. */
  struct Entry
  {
    std::uint32_t Piece;
    std::uint32_t Next;
  };

  /** A face's share in a cell. */
  struct Share
  {
    std::uint32_t Sheet;
    std::uint32_t Piece;
  };

  /** A border in a cell. */
  struct Cut
  {
    std::uint32_t Sheet;
    Interval Touched;
  };

  bool FrameCells(const SBuffer& buffer);
  void FindFacePieces();
  void AddFace(std::uint32_t face);
  void FindEdgePieces();
  void AddEdge(const OccluderMesh::Edge& edge, std::uint32_t left, std::uint32_t right);
  void InsertLine(SBuffer& buffer, int line, std::uint32_t part);
  void Deal(const Interval& touched, std::uint32_t piece, std::vector<std::uint32_t>& heads);
  int LastLike(int tile) const;
  void InsertCells(SBuffer& buffer, int line, const TileRange& tiles, std::uint32_t part);
  void FindSheets(std::size_t index);
  std::uint32_t SheetOf(std::uint32_t piece);
  void InsertSheet(SBuffer& buffer, int line, const TileRange& tiles, std::size_t first,
    std::size_t end, std::uint32_t part);
  DepthBound BoundSheet(int line, const TileRange& tiles, std::size_t first, std::size_t end) const;
  float Aside(float own) const { return this->Margin.Column + own; }
  float Above(float own) const { return this->Margin.Line + own - this->Inset; }

  const MeshProjection* Projection = nullptr;
  MeshProjection::Facing Counted = MeshProjection::Facing::Front;
  ScreenMargin Margin;
  float Inset = 0.0f; ///< how far from their sides lines have no samples
  float ColumnCount = 0.0f;
  int FirstLine = 0, LastLine = 0;
  int FirstTile = 0, LastTile = 0;
  std::vector<FacePiece> FacePieces;
  std::vector<EdgePiece> EdgePieces;
  std::vector<std::uint32_t> FaceHeads; ///< of each line's pieces
  std::vector<std::uint32_t> EdgeHeads;
  std::vector<std::uint32_t> PieceOfFace; ///< on the line that is being inserted
  std::vector<Entry> Entries;
  std::vector<std::uint32_t> TileFaces; ///< of each tile's entries
  std::vector<std::uint32_t> TileEdges;
  std::vector<std::uint32_t> Parents; ///< of pieces of faces, in the tile at hand
  std::vector<Share> Shares;
  std::vector<Cut> Cuts;
  std::vector<Interval> Covered;
  std::vector<Interval> Open;
};

}

#endif
