#ifndef VITRINE_CORE_CULLING_FACE_COVERAGE_H
#define VITRINE_CORE_CULLING_FACE_COVERAGE_H

#include "Core/culling/DepthPlane.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Puts into an s-buffer what an occluder surely covers, line by line and face by face.
 *
 * Faces that are joined by edges are one sheet. Along a line, each edge touches an interval of columns, which what a rasteriser may move
 * points by widens. Between the edges of a face all of a column is covered by it, at the depth of its plane. Where edges touch, which
 * overlap mostly a little, a column is covered if its middle is covered by a face, and no edge touches it that has nothing of the sheet on its other side:
 * on the way up or down a face can be left only for its neighbour. The depth is nowhere farther there than the farthest of the planes of the
 * faces beside those edges.
 *
 * So a line may be much thicker than faces are, without gaps at their edges; and the inside of a far wall, which belongs to
 * another sheet, does not spoil the depth of the near one.
 * (after W. J. Bouknight: A procedure for generation of three-dimensional half-toned computer graphics presentations, CACM 1970)
 */
class FaceCoverage
{
public:
  /**
   * @param buffer      takes what is covered
   * @param projection  of the occluder, with its facings
   * @param facing      of the faces that count, Front or Back
   * @param part        what spans say whose they are
   * @returns how many pieces of faces and edges on lines that took
   */
  std::size_t Insert(SBuffer& buffer, const MeshProjection& projection,
    MeshProjection::Facing facing, std::uint32_t part);

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  /** An interval of columns. */
  struct Interval
  {
    float Left;
    float Right;

    bool IsEmpty() const { return !(this->Left < this->Right); }
  };

  static constexpr Interval Empty{ 3e38f, -3e38f };

  /** A face that counts. */
  struct CountedFace
  {
    DepthPlane Plane;
    float Bottom; ///< lines that it may be drawn on
    float Top;
  };

  /** An edge on a line: between two faces that count, or at the border of one. */
  struct EdgePiece
  {
    Interval Touched;
    float Middle;       ///< where it crosses the line's middle
    std::uint32_t Left; ///< the face on that side, or None
    std::uint32_t Right;
    std::uint32_t Sheet;
    bool IsCrossing; ///< the line's middle
    std::uint32_t Next;

    bool IsOutline() const { return this->Left == None || this->Right == None; }
  };

  /** A face on the line that is being inserted. */
  struct FaceOnLine
  {
    int Line = -1;            ///< the line that it was last on
    std::uint32_t Visit = 0;  ///< the last piece that it was beside
    Interval Middle = Empty;  ///< what it covers of the line's middle
    Interval Inside = Empty;  ///< between the edges that cross the middle
    Interval Touched = Empty; ///< by an edge that does not cross the middle
    float LeftDepth =
      2.0f; ///< what stands in for the edge on that side; above all depths if that is inserted by itself
    float RightDepth = 2.0f;
  };

  /** An edge piece, where it is sorted. */
  struct SortedPiece
  {
    std::uint32_t Sheet;
    float Left;
    const EdgePiece* Piece;

    bool operator<(const SortedPiece& other) const
    {
      return this->Sheet != other.Sheet ? this->Sheet < other.Sheet : this->Left < other.Left;
    }
  };

  bool FrameLines(const SBuffer& buffer);
  void FindFaces();
  void FindSheets();
  std::uint32_t SheetOf(std::uint32_t face);
  void FindEdgePieces();
  void AddEdge(const OccluderMesh::Edge& edge, std::uint32_t left, std::uint32_t right);
  void FindFacesOnLine();
  void AddToFace(std::uint32_t face, const EdgePiece& piece, bool isOnItsRight);
  void InsertInsides();
  void InsertInside(std::uint32_t face, const Interval& inside);
  void InsertWithEdges(std::uint32_t face, const FaceOnLine& onLine);
  bool IsPassed(const EdgePiece& edge);
  bool IsWhole(std::uint32_t face) const;
  void InsertEdges();
  void InsertCluster(std::size_t first, std::size_t end, const Interval& around);
  void FindBeside(std::size_t first, std::size_t end, const Interval& piece);
  void FindCovered(const Interval& piece);
  void InsertPiece(std::size_t first, std::size_t end, const Interval& piece);
  DepthBound BoundPiece(const Interval& piece) const;
  DepthBound BoundFace(std::uint32_t face, const Interval& columns) const;
  void InsertSegment(const Interval& columns, const DepthBound& bound);
  bool IsCovered(const Interval& columns, float nearest) const;
  float Aside(float own) const { return this->Margin.Column + own; }
  float Above(float own) const { return this->Margin.Line + own - this->Inset; }

  const MeshProjection* Projection = nullptr;
  MeshProjection::Facing Counted = MeshProjection::Facing::Front;
  SBuffer* Buffer = nullptr;
  std::uint32_t Part = 0;
  ScreenMargin Margin;
  float Inset = 0.0f; ///< how far from their sides lines have no samples
  float ColumnCount = 0.0f;
  int FirstLine = 0, LastLine = 0;
  int Line = 0;                       ///< that is being inserted
  std::vector<std::uint32_t> Numbers; ///< of each face among those that count
  std::vector<CountedFace> Faces;     ///< those that count and are on the screen
  std::vector<std::uint32_t> Parents; ///< of those
  std::vector<EdgePiece> EdgePieces;
  std::vector<std::uint32_t> EdgeHeads; ///< of each line's pieces
  std::vector<SortedPiece> OnLine;
  std::vector<FaceOnLine> FacesOnLine; ///< each that counts
  std::vector<std::uint32_t> Present;  ///< on the line
  std::uint32_t Visits = 0;            ///< of pieces
  std::vector<std::uint32_t> Beside;   ///< the edges of the piece at hand
  std::vector<Interval> Covered;
  std::vector<Interval> Open;
  std::size_t Segments = 0;
};

}

#endif
