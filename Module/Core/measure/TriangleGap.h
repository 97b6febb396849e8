#ifndef VITRINE_CORE_MEASURE_TRIANGLE_GAP_H
#define VITRINE_CORE_MEASURE_TRIANGLE_GAP_H

#include "Core/octree/Triangle.h"

#include <glm/vec3.hpp>

#include <optional>

namespace vitrine
{

/** The two points of two things that are nearest to each other. */
struct Gap
{
  double Distance;
  glm::dvec3 OnFirst;
  glm::dvec3 OnSecond;
};

/** Returns the point of a triangle that is nearest to a point. The triangle may be a segment or a point. */
glm::dvec3 NearestOnTriangle(const Triangle& triangle, const glm::dvec3& point);

/** Returns the least distance of two segments. */
Gap GapOfSegments(
  const glm::dvec3& a, const glm::dvec3& aEnd, const glm::dvec3& b, const glm::dvec3& bEnd);

/**
 * Returns the least distance of two triangles, or nothing if it is larger than `within`. It is 0 where they meet, or
 * are at most `rounding` apart, and both points are then the middle of what they have in common.
 *
 * Directions in which they may be apart are tried first: normals, cross products of edges, and those of normals and
 * edges. How far they are apart along one is at most their distance. (S. Gottschalk, M. C. Lin, D. Manocha: OBBTree,
 * SIGGRAPH 1996)
 *
 * @param apart  if it is given, and one of these directions tells that they are farther apart, it becomes that
 *               direction: from `a` to `b`, of length 1
 */
std::optional<Gap> GapWithin(const Triangle& a, const Triangle& b, double within, double rounding,
  glm::dvec3* apart = nullptr);

/** Returns the least distance of two triangles that do not meet. */
Gap GapOfApartTriangles(const Triangle& a, const Triangle& b);

/** Returns a point in the middle of what two triangles have in common, which must meet. */
glm::dvec3 MiddleOfMeeting(const Triangle& a, const Triangle& b);

/**
 * Returns how far two triangles that meet reach through one another: how far both have to move, along the normal of
 * one of them, until they are on one side of its plane. It is 0 for triangles in one plane.
 */
double ReachThrough(const Triangle& a, const Triangle& b);

}

#endif
