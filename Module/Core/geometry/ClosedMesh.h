/** Is a mesh the surface of a solid? */
#ifndef VITRINE_CORE_GEOMETRY_CLOSED_MESH_H
#define VITRINE_CORE_GEOMETRY_CLOSED_MESH_H

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Returns for each point the first one of its place. A point with a coordinate that is not finite is its own. */
std::vector<std::uint32_t> FirstOfEqualPoints(const std::vector<glm::dvec3>& points);

/**
 * Returns true if there are triangles, and each edge has an even number of them.
 * @param corners  three numbers of points for each triangle. They differ. Points of one place have one number.
 */
bool HasEvenEdges(const std::vector<std::uint32_t>& corners);

/**
 * Returns true if every edge has an even number of triangles. Equal points count as one, and triangles with two equal
 * points do not count. A ray then crosses the mesh an even number of times, unless it starts inside. A mesh without
 * triangles, or with points that are no finite numbers, is not closed.
 * @param corners  three indices of points for each triangle
 */
bool IsClosed(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

}

#endif
