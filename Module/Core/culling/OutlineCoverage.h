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
 * One depth stands for all of it, that of the farthest point of a face that counts: this is for occluders of few cells, and
 * CellCoverage for larger ones.
 */
class OutlineCoverage
{
public:
  /**
   * @param buffer      takes what is covered
   * @param projection  of the occluder; its facings are found
   * @param facing      of the faces that count, Front or Back
   * @param part        what spans say whose they are
   * @returns how many pieces of faces and edges on lines that took
   */
  std::size_t Insert(SBuffer& buffer, const MeshProjection& projection,
    MeshProjection::Facing facing, std::uint32_t part);

private:
  /** Where an edge of the outline passes a line. */
  struct Passage
  {
    float Left; ///< of what it may touch of the line
    float Right;
    std::int32_t Winding; ///< by what the cover of the line's middle changes from left to right
    std::uint32_t Next;   ///< on the same line, or None
  };

  static constexpr std::uint32_t None = 0xffffffffu;

  bool FrameLines(const SBuffer& buffer);
  void FindOutline(MeshProjection::Facing facing);
  void AddEdge(const ScreenPoint& from, const ScreenPoint& to);
  float FarthestOf(MeshProjection::Facing facing) const;
  void InsertLine(SBuffer& buffer, int line, float depth, std::uint32_t part);

  const MeshProjection* Projection = nullptr;
  float Inset = 0.0f; ///< how far from their sides lines have no samples
  int FirstLine = 0, LastLine = 0;
  std::vector<std::uint32_t> Heads; ///< of each line's passages
  std::vector<Passage> Passages;
  std::vector<Passage> Sorted;
};

}

#endif
