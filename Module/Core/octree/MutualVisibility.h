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

/** Tells the triangle of an item; none if it blocks no view, as a translucent one. Either side of a triangle blocks. */
using BlockerOf = std::function<std::optional<Triangle>(std::uint32_t)>;

/**
 * Whether two boxes may see each other: false only if every segment from a point of one to a point of the other meets a
 * triangle. Touching boxes, and boxes that are empty or not finite, may see each other.
 *
 * The answer is false where a surface closes off the space between the boxes. Triangles belong to one surface where
 * they share edges, corner by corner of equal coordinates. A surface which, as far as it lies in that space, has no edge
 * of an odd number of triangles, and which stays clear of both boxes, is crossed by all segments an even number of times
 * or by all an odd number of times: it takes a passage over an edge or an end to change that. So a segment that crosses it
 * an odd number of times stands for all. (P. Alexandroff, H. Hopf: Topologie, 1935, on the intersection number modulo 2)
 *
 * So a wall of thousands of triangles blocks as one of two does, bent or plane. Not noticed, and answered by true: what
 * is blocked only by several surfaces together, by one that runs through a box, or by one with cracks.
 *
 * @param mostTriangles  that are looked at; where there are more between the boxes, they may see each other
 * @throws std::runtime_error if a page of the tree is on disk and cannot be read
 */
bool MaySeeEachOther(const Octree& tree, const BlockerOf& blocker, const Box& a, const Box& b,
  std::size_t mostTriangles = 100000);

}

#endif
