#ifndef VITRINE_CORE_CULLING_OUTLINE_COVERAGE_H
#define VITRINE_CORE_CULLING_OUTLINE_COVERAGE_H

#include "Core/culling/Lanes.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"
#include "Core/culling/SlantedDepth.h"

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
 * it could only stop to be covered at the outline. That holds for whatever mesh, convex or not, for the outline of whichever of its faces, and whatever a
 * rasteriser moves points by, as long as the outline is taken that much wider (the degree of a map over a point stays as it
 * is while the image of its boundary does not pass the point).
 *
 * Most outlines cross a line twice, once on its way down and once up: then what lies right of all edges that go down and left of all that
 * go up is covered, and that is found for eight lines at a time.
 *
 * One plane of depth stands for all of it, behind all points of faces that count (PlaneBelow): this is for occluders of few cells whose faces tell no more, and
 * FaceCoverage for larger ones.
 */
class OutlineCoverage
{
public:
  /**
   * @param buffer      takes what is covered
   * @param projection  of the occluder
   * @param facing      of the facets that count, Front or Back
   * @param part        what spans say whose they are
   * @returns how many pieces of faces and edges on lines that took
   */
  std::size_t Insert(SBuffer& buffer, const MeshProjection& projection,
    MeshProjection::Facing facing, std::uint32_t part);

private:
  /** Eight edges of the outline, each from its lower end to its upper one, with what is covered on the right of those that go down. */
  struct OutlineEdges
  {
    float Bottom[LaneCount], Top[LaneCount]; ///< lines
    float Column[LaneCount];                 ///< at the bottom
    float Slope[LaneCount];                  ///< columns a line
    float Left[LaneCount], Right[LaneCount]; ///< columns
    std::int32_t IsDown[LaneCount]; ///< -1 for those that go down, or are level, 0 for others
    std::int32_t IsAtTop
      [LaneCount]; ///< -1 for those that reach farthest into what is covered at their top, 0 at their bottom

    float At(int i, float line) const;
    Lanes FarthestOn(int i, Lanes bottom, Lanes top) const;
  };

  /** What one outline edge down and one up leave between them, and how many go down through the middles. */
  struct SpanLanes
  {
    float Left[LaneCount];
    float Right[LaneCount];
    float Crossings[LaneCount];
  };

  /** Where an edge of the outline passes a line. */
  struct Passage
  {
    float Left; ///< of what it may touch of the line
    float Right;
    std::int32_t Winding; ///< by what the cover of the line's middle changes from left to right
  };

  bool FrameLines(const SBuffer& buffer);
  unsigned OpenLines(const SBuffer& buffer, int line) const;
  bool SkipCovered(const SBuffer& buffer);
  bool FindFacets(MeshProjection::Facing facing);
  void CountCorners(const std::uint32_t* begin, const std::uint32_t* end);
  bool IsBehindNear(std::uint32_t begin, std::uint32_t end) const;
  void FindOutline(MeshProjection::Facing facing);
  void FindEnds(MeshProjection::Facing facing);
  void FindEdges(const MeshEdge* ends, OutlineEdges& edges) const;
  void FindSpans(int line, SpanLanes& spans) const;
  void InsertLines(SBuffer& buffer, int first, unsigned open, std::uint32_t part);
  void InsertSpan(SBuffer& buffer, int line, float left, float right, std::uint32_t part);
  void InsertLine(SBuffer& buffer, int line, std::uint32_t part);

  const MeshProjection* Projection = nullptr;
  float Inset = 0.0f;               ///< how far from their sides lines have no samples
  float Aside = 0.0f, Above = 0.0f; ///< by what edges are taken wider
  int FirstLine = 0, LastLine = 0;
  SlantedDepth Bound;
  std::vector<std::int32_t> Corners;   ///< each point: -1 for those of facets that count, else 0
  std::vector<std::uint8_t> IsCounted; ///< each facet, and 0 for none
  std::vector<MeshEdge> Ends;          ///< of the outline
  std::vector<OutlineEdges> Outline;
  std::size_t EdgeCount = 0; ///< of this one
  std::vector<Passage> Passages;
};

}

#endif
