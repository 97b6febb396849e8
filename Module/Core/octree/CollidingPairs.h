#ifndef VITRINE_CORE_OCTREE_COLLIDING_PAIRS_H
#define VITRINE_CORE_OCTREE_COLLIDING_PAIRS_H

#include "Core/octree/Octree.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace vitrine
{

/** An item of one tree and one of another, or of the same. */
using ItemPair = std::pair<std::uint32_t, std::uint32_t>;

/** Whether a pair, whose boxes touch, counts: say, of triangles of different parts those that meet (TrianglesMeet()). */
using PairTest = std::function<bool(std::uint32_t, std::uint32_t)>;

/**
 * The pairs of an item of one tree and an item of another whose boxes have a point in common and which `test` confirms,
 * in ascending order: those, and only those, that trying all pairs would find. Each pair is tested once. To collide two
 * parts, build a tree of the triangles of each.
 * @throws std::runtime_error if a page of a tree is on disk and cannot be read
 */
std::vector<ItemPair> CollidingPairs(const Octree& first, const ItemBoxes& firstBoxes,
  const Octree& second, const ItemBoxes& secondBoxes, const PairTest& test);

/** As above, for the pairs of items of one tree, the lower number first. */
std::vector<ItemPair> CollidingPairs(
  const Octree& tree, const ItemBoxes& boxes, const PairTest& test);

/** Whether CollidingPairs() finds any; it stops at the first. */
bool Collide(const Octree& first, const ItemBoxes& firstBoxes, const Octree& second,
  const ItemBoxes& secondBoxes, const PairTest& test);

}

#endif
