#ifndef VITRINE_CORE_OCTREE_MUTUAL_VISIBILITY_H
#define VITRINE_CORE_OCTREE_MUTUAL_VISIBILITY_H

#include "Core/octree/Octree.h"
#include "Core/octree/Triangle.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace vitrine
{

/**
 * Returns the triangle of an item, or nothing if the item blocks no view, such as a translucent one. Both sides of a
 * triangle block.
 */
using BlockerOf = std::function<std::optional<Triangle>(std::uint32_t)>;

/**
 * Returns false only if every segment from a point of one box to a point of the other meets a triangle. Boxes that
 * touch, are empty or are not finite may see each other.
 *
 * The result is false if a surface separates the boxes in the space between them. Triangles that share edges, with
 * equal coordinates of corners, form a surface. The surface must have no edge of an odd number of triangles in that
 * space, and must stay clear of both boxes. Then all segments cross it an even number of times, or all an odd number of
 * times: a change would take a passage over an edge or an end. So a segment that crosses it an odd number of times
 * represents all. (P. Alexandroff, H. Hopf: Topologie, 1935, on the intersection number modulo 2)
 *
 * So a wall of thousands of triangles, bent or plane, blocks like one of two triangles. The result is true if only
 * several surfaces together block the view, or one that runs through a box or has cracks.
 *
 * @param mostTriangles  largest number of triangles to test; if there are more between the boxes, the result is true
 * @throws               std::runtime_error if a page of the tree is on disk and cannot be read
 */
bool MaySeeEachOther(const Octree& tree, const BlockerOf& blocker, const Box& a, const Box& b,
  std::size_t mostTriangles = 100000);

}

#endif
