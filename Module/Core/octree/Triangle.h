#ifndef VITRINE_CORE_OCTREE_TRIANGLE_H
#define VITRINE_CORE_OCTREE_TRIANGLE_H

#include "Core/geometry/Box.h"
#include "Core/octree/Ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace vitrine
{

/** The three corners of a triangle. */
using Triangle = std::array<glm::dvec3, 3>;

/** Returns the smallest box of floats around a triangle. All of the box is NaN if a coordinate is not finite. */
Box BoxOf(const Triangle& triangle);

/**
 * Returns the distance along the ray to the triangle, in lengths of the ray's direction. Returns nothing if the ray
 * misses it or lies in its plane, or if a number is not finite. Both sides of the triangle count. (T. Moeller, B.
 * Trumbore: Fast, minimum storage ray/triangle intersection, Journal of Graphics Tools 2(1), 1997)
 */
std::optional<double> RayMeets(const Ray& ray, const Triangle& triangle);

/**
 * Returns true if two triangles share a point. It uses the separating axis theorem: disjoint convex sets have disjoint
 * projections onto some axis. For triangles that axis is a normal, a cross product of two edges, or one of a normal and
 * an edge. Rounding blurs the result by a few ulps. The result is false if a number is not finite.
 */
bool TrianglesMeet(const Triangle& a, const Triangle& b);

}

#endif
