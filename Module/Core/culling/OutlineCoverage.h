#ifndef VITRINE_CORE_CULLING_OUTLINE_COVERAGE_H
#define VITRINE_CORE_CULLING_OUTLINE_COVERAGE_H

#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Puts into an s-buffer what an occluder surely covers.
 *
 * Faces of one mesh are not inserted one by one: at lines that are thicker than a pixel each would leave a gap along every
 * slanted edge. What counts is the outline, the edges with a face that goes around counter-clockwise on one side only. On a
 * line's middle, how often a point is covered changes at the outline alone, by one at each edge that crosses it. And where a
 * column of the line is met by no edge of the outline, all of the column is covered as often as its middle is: a point of
 * it could only stop to be covered at the outline. That holds for whatever mesh, convex or not, and whatever a
 * rasteriser moves points by, as long as the outline is taken that much wider (the degree of a map over a point stays as it
 * is while the image of its boundary does not pass the point).
 *
 * Depth is bounded from below in cells of a line and SBuffer::TileWidth columns: by the planes of all faces in a cell, and
 * never below their farthest points.
 */
class OutlineCoverage
{
public:
  /**
   * @param buffer      takes what is covered
   * @param projection  of the occluder; its facings are found
   * @param facing      of the faces that count, Front or Back
   * @param face        what spans say whose they are
   */
  void Insert(SBuffer& buffer, const MeshProjection& projection, MeshProjection::Facing facing,
    std::uint32_t face);

private:
  /** Where an edge of the outline passes a line. */
  struct Passage
  {
    float Left; ///< of what it may touch of the line
    float Right;
    std::int32_t Winding; ///< by what the cover of the line's middle changes from left to right
    std::uint32_t Next;   ///< on the same line, or None
  };

  /** A lower bound of the depth in a cell, linear between its sides. */
  struct Bound
  {
    float Left;
    float Right;
  };

  static constexpr std::uint32_t None = 0xffffffffu;

  bool FrameCells(const SBuffer& buffer);
  void FindOutline(MeshProjection::Facing facing);
  void AddEdge(const ScreenPoint& from, const ScreenPoint& to);
  void AddPassage(int line, float left, float right, int winding);
  void BoundDepths(MeshProjection::Facing facing);
  void BoundByFarthest(MeshProjection::Facing facing);
  void BoundByFace(const OccluderMesh::Face& face);
  void InsertLine(SBuffer& buffer, int line, std::uint32_t face);
  void InsertInterval(SBuffer& buffer, int line, float left, float right, std::uint32_t face) const;

  const MeshProjection* Projection = nullptr;
  int FirstLine = 0, LastLine = 0; ///< of the cells
  int FirstTile = 0, LastTile = 0;
  float ColumnCount = 0.0f;
  std::vector<std::uint32_t> Heads; ///< of each line's passages
  std::vector<Passage> Passages;
  std::vector<Passage> Sorted;
  std::vector<Bound> Bounds;
  bool HasOneBound = false; ///< Bounds[0] is every cell's
};

}

#endif
