#ifndef VITRINE_CORE_OCTREE_TRIANGLE_H
#define VITRINE_CORE_OCTREE_TRIANGLE_H

#include "Core/geometry/Box.h"
#include "Core/octree/Ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace vitrine
{

/** Three corners. */
using Triangle = std::array<glm::dvec3, 3>;

/** The smallest box of floats around it. A coordinate that is not finite makes all of the box NaN. */
Box BoxOf(const Triangle& triangle);

/**
 * How far along the ray the triangle is met, in lengths of the ray's direction; none if it is not, if the ray lies in its
 * plane, or if a number is not finite. Either side of the triangle counts. (T. Moeller, B. Trumbore: Fast, minimum
 * storage ray/triangle intersection, Journal of Graphics Tools 2(1), 1997)
 */
std::optional<double> RayMeets(const Ray& ray, const Triangle& triangle);

/**
 * Whether two triangles have a point in common, by the theorem of separating axes: of convex sets that have none, the
 * shadows on some axis have none, and for triangles that axis is a normal, a cross product of two edges, or one of a
 * normal and an edge. Rounding blurs it by a few units in the last place. False where a number is not finite.
 */
bool TrianglesMeet(const Triangle& a, const Triangle& b);

}

#endif
