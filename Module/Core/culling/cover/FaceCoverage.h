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
 * Puts into an s-buffer what an occluder surely covers, line by line and patch by patch (ScreenPatches.h).
 *
 * Edges between patches, and those with nothing on one side, touch an interval of columns on a line, which what a rasteriser may move points
 * by widens. How often a patch covers a place, whole columns of the line included, changes at its own edges alone (the degree of a map over a
 * point stays as it is while the image of its boundary does not pass the point). So between those all of a column is covered as often as
 * the line's middle is, at the depth of the patch's plane. Where edges touch a column, the patches that they are between are one sheet: together they
 * cover it as often as beside it, unless an edge touches it that has nothing on one side, at the depth of the farthest of them.
 *
 * So a line may be much thicker than faces are, without gaps at their edges; and the inside of a far wall, which belongs to
 * other patches, does not spoil the depth of the near one.
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
   * @returns how many pieces of patches and edges on lines that took
   */
  std::size_t Insert(SBuffer& buffer, const MeshProjection& projection,
    MeshProjection::Facing facing, std::uint32_t part);

private:
  static constexpr std::uint32_t None = ScreenPatches::None;

  using Interval = PatchEdges::Interval;
  using EdgePiece = PatchEdges::Piece;

  /** What a patch has of the line that is being inserted, left of the edges at hand. */
  struct PatchOnLine
  {
    int Line = -1;           ///< the line that it was last on
    int Cover = 0;           ///< how often it covers what lies behind its last edge
    int CoverOfPiece = 0;    ///< the same up to the piece of a cluster that is at hand
    std::uint32_t Visit = 0; ///< the last piece that it was beside
    Interval Begins{
      -BeyondAll, -BeyondAll
    }; ///< behind its last edge: in it, where that was left to patches, and behind all it touches
    float BeginDepth =
      2.0f; ///< what stands in for that edge; above all depths if that is inserted by itself
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

  /** Edges of a sheet on the line that touch each other. */
  struct Cluster
  {
    std::size_t First;
    std::size_t End;
    Interval Around;
    float NextLeft; ///< of what comes behind it in the sheet
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
  float Inset = 0.0f; ///< how far from their sides lines have no samples
  float ColumnCount = 0.0f;
  int FirstLine = 0, LastLine = 0;
  int Line = 0; ///< that is being inserted
  ScreenPatches Patches;
  OpenLines Open;
  PatchEdges Edges;
  std::vector<SortedPiece> Sorted;         ///< the line's
  std::vector<PatchOnLine> OnLine;         ///< each patch
  std::uint32_t Visits = 0;                ///< of pieces
  std::vector<const EdgePiece*> Crossings; ///< of a cluster, by where they cross the middle
  std::size_t Crossed = 0;                 ///< of those
  std::vector<std::uint32_t> Beside;       ///< patches of the piece at hand
  std::vector<const EdgePiece*> Outlines;  ///< that touch it
  std::size_t Segments = 0;
};

}

#endif
