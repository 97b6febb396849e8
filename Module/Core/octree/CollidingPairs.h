#ifndef VITRINE_CORE_OCTREE_COLLIDING_PAIRS_H
#define VITRINE_CORE_OCTREE_COLLIDING_PAIRS_H

#include "Core/octree/Octree.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace vitrine
{

/** An item of one tree and an item of another or of the same tree. */
using ItemPair = std::pair<std::uint32_t, std::uint32_t>;

/**
 * Returns true if a pair of items with touching boxes counts. An example is TrianglesMeet() for triangles of different
 * parts.
 */
using PairTest = std::function<bool(std::uint32_t, std::uint32_t)>;

/**
 * Returns the pairs of an item of one tree and an item of another whose boxes share a point and that `test` confirms.
 * The result is what a test of all pairs would find, in ascending order. Each pair is tested once. To collide two
 * parts, build a tree of the triangles of each.
 * @throws  std::runtime_error if a page of a tree is on disk and cannot be read
 */
std::vector<ItemPair> CollidingPairs(const Octree& first, const ItemBoxes& firstBoxes,
  const Octree& second, const ItemBoxes& secondBoxes, const PairTest& test);

/** Returns the pairs of items of one tree, with the lower number first. */
std::vector<ItemPair> CollidingPairs(
  const Octree& tree, const ItemBoxes& boxes, const PairTest& test);

/** Returns true if CollidingPairs() finds a pair. It stops at the first one. */
bool Collide(const Octree& first, const ItemBoxes& firstBoxes, const Octree& second,
  const ItemBoxes& secondBoxes, const PairTest& test);

}

#endif
