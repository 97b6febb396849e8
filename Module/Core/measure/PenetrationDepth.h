#ifndef VITRINE_CORE_MEASURE_PENETRATION_DEPTH_H
#define VITRINE_CORE_MEASURE_PENETRATION_DEPTH_H

#include "Core/measure/PlacedPart.h"
#include "Core/measure/SurfaceGap.h"

#include <optional>
#include <vector>

namespace vitrine
{

/** Which pieces of a part's surface (PartMesh::Pieces()) are in the solid of another part that it does not meet. */
struct PiecesInside
{
  std::vector<bool> Inside;
  bool Any = false;
  bool All = false;
};

PiecesInside FindPiecesInside(const PlacedPart& part, const PlacedPart& solid);

/** A point that is in both parts, and how deep. */
struct DeepPoint
{
  double Depth;
  glm::dvec3 Place;
};

/**
 * Returns how deep two parts are in one another, if deeper than `above`. The depth is the largest of these:
 *
 * - for each witness point of one part's surface in the other's solid, its distance from the other's surface. Witness
 *   points are the corners of all triangles, and of triangles that meet the other part also their centre, the middles
 *   of their edges, the middles of the meetings, and the points half-way between two meetings (NextMeetings());
 * - for each inner point of one part (PartMesh::InnerPoints()) in the other's solid, the lesser one of its distances
 *   from both surfaces. Two equal parts at one place have no other;
 * - if neither part is closed, so that there is no solid: how far two triangles that meet reach through one another.
 *
 * Each depth is measured at a point, so the parts are at least as deep in one another. They may be deeper between
 * witness points.
 *
 * @param meetings  all of the two surfaces
 */
std::optional<DeepPoint> FindDepthOfMeeting(const PlacedPart& first, const PlacedPart& second,
  const std::vector<Meeting>& meetings, double above);

/** The same for two parts whose surfaces do not meet. Then each piece is inside or outside as a whole. */
std::optional<DeepPoint> FindDepthOfApart(const PlacedPart& first, const PlacedPart& second,
  const PiecesInside& firstInside, const PiecesInside& secondInside, double above);

/** Returns the meetings to take the middle between meeting `i` of `count` and them. */
std::vector<std::size_t> NextMeetings(std::size_t i, std::size_t count);

}

#endif
