#ifndef VITRINE_CORE_CULLING_COVER_FACE_COVERAGE_H
#define VITRINE_CORE_CULLING_COVER_FACE_COVERAGE_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/cover/OpenLines.h"
#include "Core/culling/cover/PatchEdges.h"
#include "Core/culling/cover/ScreenPatches.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/BeyondAll.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Inserts what an occluder surely covers into an s-buffer, line by line and patch by patch (ScreenPatches.h).
 *
 * On a line, an edge between patches or an outline edge, with nothing on one side, touches an interval of columns. The
 * interval is widened by what a rasteriser may move points by. Consider how often a patch covers a column of the line,
 * at its full height. That number changes only where edges of the patch touch the line. (The degree of a map over a
 * point is constant while the image of its boundary does not pass the point.)
 *
 * Between the edges, a whole column is covered as often as the middle of the line is, at the depth of the plane of the
 * patch. Where edges touch a column, the patches on both sides of them are one sheet. Together they cover the column as
 * often as the columns beside it, at the depth of the farthest of them. That does not hold where an outline edge
 * touches the column.
 *
 * So a line may be much thicker than faces are, without gaps at their edges. The inside of a far wall belongs to other
 * patches, so it does not spoil the depth of the near wall.
 * (after W. J. Bouknight: A procedure for generation of three-dimensional half-toned computer graphics presentations,
 * CACM 1970)
 */
class FaceCoverage
{
public:
  /**
   * Inserts the faces of one facing.
   * @param buffer      gets what is covered
   * @param projection  the projected occluder, with its facings
   * @param facing      the faces that count, Front or Back
   * @param part        the number of the part, which spans keep
   * @returns  the number of pieces of patches and edges on lines, as a cost
   */
  std::size_t Insert(SBuffer& buffer, const MeshProjection& projection,
    MeshProjection::Facing facing, std::uint32_t part);

private:
  static constexpr std::uint32_t None = ScreenPatches::None;

  using Interval = PatchEdges::Interval;
  using EdgePiece = PatchEdges::Piece;

  /** The state of a patch on the current line, left of the current edges. */
  struct PatchOnLine
  {
    int Line = -1;           ///< the last line that the patch was on
    int Cover = 0;           ///< how often the patch covers what follows its last edge
    int CoverOfPiece = 0;    ///< the same at the current piece of a cluster
    std::uint32_t Visit = 0; ///< the last piece that the patch was beside
    /**
     * Where the patch goes on behind its last edge. Left lies within the edge if the edge was left to the patches.
     * Right lies behind all columns that the edge touches.
     */
    Interval Begins{ -BeyondAll, -BeyondAll };
    /**
     * The depth of the half of that edge that is left to the patch. It is above all depths if the edge is inserted by
     * itself.
     */
    float BeginDepth = 2.0f;
  };

  /** An edge piece with its sort key. */
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

  /** Edges of one sheet on the line that touch each other, as a range of Sorted. */
  struct Cluster
  {
    std::size_t First;
    std::size_t End;
    Interval Around;
    float NextLeft; ///< the left end of the next edge of the sheet, or the right end of the cluster
  };

  bool FrameLines(const SBuffer& buffer);
  void InsertLine();
  void SortPieces();
  Cluster ClusterFrom(std::size_t first) const;
  PatchOnLine& OnLineOf(std::uint32_t patch);
  void InsertCluster(const Cluster& cluster);
  bool HasSamples(const Interval& columns) const;
  bool IsLeftToPatches(const Cluster& cluster);
  void LeaveToPatches(const EdgePiece& edge);
  void InsertEdges(const Cluster& cluster);
  void SortCrossings(const Cluster& cluster);
  void CrossUpTo(float column);
  void FindBeside(const Cluster& cluster, const Interval& piece);
  void InsertPiece(const Interval& piece);
  void PassEdges(const Cluster& cluster);
  void PassEdge(std::uint32_t patch, const EdgePiece& edge);
  void InsertInside(
    std::uint32_t patch, const PatchOnLine& begin, const Interval& end, float depth);
  DepthBound BoundBeside(const Interval& piece) const;
  DepthBound BoundOf(std::uint32_t patch, const Interval& columns) const;
  void InsertSegment(const Interval& columns, const DepthBound& bound);
  bool IsCovered(const Interval& columns, float nearest) const;

  const MeshProjection* Projection = nullptr;
  MeshProjection::Facing Counted = MeshProjection::Facing::Front;
  SBuffer* Buffer = nullptr;
  std::uint32_t Part = 0;
  float Inset = 0.0f; ///< samples are at least this far from the sides of a line
  float ColumnCount = 0.0f;
  int FirstLine = 0, LastLine = 0;
  int Line = 0; ///< the current line
  ScreenPatches Patches;
  OpenLines Open;
  PatchEdges Edges;
  std::vector<SortedPiece> Sorted;         ///< edge pieces of the current line
  std::vector<PatchOnLine> OnLine;         ///< for each patch
  std::uint32_t Visits = 0;                ///< number of pieces so far
  std::vector<const EdgePiece*> Crossings; ///< edges of the current cluster, sorted by Middle
  std::size_t Crossed = 0;                 ///< the number of these edges left of the current piece
  std::vector<std::uint32_t> Beside;       ///< patches beside edges that touch the current piece
  std::vector<const EdgePiece*> Outlines;  ///< outline edges that touch the current piece
  std::size_t Segments = 0;
};

}

#endif
