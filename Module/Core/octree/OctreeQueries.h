#ifndef VITRINE_CORE_OCTREE_OCTREE_QUERIES_H
#define VITRINE_CORE_OCTREE_OCTREE_QUERIES_H

#include "Core/octree/OctreeWalk.h"
#include "Core/octree/Ray.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

// Queries of an octree. Each has the same result as a test of every item, to the last bit: tests are monotone in a
// box's sides, rounding included. So a test that holds for an item holds for all nodes above. `boxes` must be those
// that the tree was built with. An item with an empty box or NaN is never found. An item with an infinite box is found
// where the box lies. All throw std::runtime_error if a page of the tree is on disk and cannot be read.

namespace vitrine
{

/**
 * The points no farther from a centre than a radius. There are none for NaN, an infinite centre or a negative radius.
 */
struct Sphere
{
  glm::dvec3 Centre{ 0.0 };
  double Radius = 0.0;
};

/** Returns the distance between a point and a box, which must not be empty. */
inline double DistanceTo(const Box& box, const glm::dvec3& point)
{
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beside =
      std::max({ box.Min[axis] - point[axis], point[axis] - box.Max[axis], 0.0 });
    sum += beside * beside;
  }
  return std::sqrt(sum);
}

/** Returns the items whose boxes share a point with a box, in ascending order. */
std::vector<std::uint32_t> ItemsTouching(
  const Octree& tree, const ItemBoxes& boxes, const Box& box);

/** Returns the items whose boxes lie in a box, in ascending order. */
std::vector<std::uint32_t> ItemsWithin(const Octree& tree, const ItemBoxes& boxes, const Box& box);

/** Returns the items whose boxes share a point with a sphere, in ascending order. */
std::vector<std::uint32_t> ItemsTouching(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere);

/** Returns the items whose boxes lie in a sphere, in ascending order. */
std::vector<std::uint32_t> ItemsWithin(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere);

/** Returns the items whose boxes a ray meets, in ascending order. */
std::vector<std::uint32_t> ItemsAlong(const Octree& tree, const ItemBoxes& boxes, const Ray& ray);

/** The first or the nearest item. */
struct FoundItem
{
  std::uint32_t Item;
  double Distance; ///< Distance of the item. For a ray, it is in lengths of the ray's direction.
};

/**
 * Returns the item that a ray hits first. The lowest number wins among equal distances.
 *
 * @param hit  `std::optional<double> hit(std::uint32_t item)`: returns the distance along the ray to an item, whose box
 *             the ray meets. A distance outside of the ray's range in the box, as by rounding, is clamped to that
 *             range. NaN, infinite and negative distances and those beyond the ray's end are no hits.
 */
template <class Hit>
std::optional<FoundItem> FirstHit(
  const Octree& tree, const ItemBoxes& boxes, const Ray& ray, Hit&& hit);

/**
 * Returns the item nearest to a point. The lowest number wins among equal distances. Returns nothing if the point is
 * not finite.
 *
 * @param distance  `double distance(std::uint32_t item)`: returns the distance from the point to the item. A distance
 *                  smaller than that to the item's box counts as the latter. Items with a NaN or infinite distance are
 *                  ignored.
 */
template <class Distance>
std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point, Distance&& distance);

/** Returns the item whose box is nearest to a point. */
std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point);

namespace detail
{

// Finds the item with the smallest distance.
template <class Lowest, class Exact>
class NearestSearch
{
public:
  // `lowest` returns the distance of a box, infinite or NaN if out of reach. `exact` returns that of an item, given its
  // number, box and lowest distance.
  NearestSearch(const ItemBoxes& boxes, Lowest& lowest, Exact& exact)
    : Boxes(boxes)
    , LowestOf(lowest)
    , ExactOf(exact)
  {
  }

  bool Enter(const OctreeNode& node) const { return this->LowestOf(node.Bounds) <= this->Limit(); }

  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    this->Visit(items, count);
  }

  void Visit(const std::uint32_t* items, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const Box box = this->Boxes.At(items[i]);
      const double lowest = box.IsEmpty() ? Unreachable : this->LowestOf(box);
      if (lowest <= this->Limit())
      {
        this->Offer(items[i], this->ExactOf(items[i], box, lowest));
      }
    }
  }

  const std::optional<FoundItem>& Found() const { return this->Best; }

  static constexpr double Unreachable = std::numeric_limits<double>::infinity();

private:
  double Limit() const
  {
    return this->Best ? this->Best->Distance : std::numeric_limits<double>::max();
  }

  void Offer(std::uint32_t item, double distance)
  {
    const bool isBetter = distance < this->Limit() ||
      (distance == this->Limit() && (!this->Best || item < this->Best->Item));
    if (isBetter)
    {
      this->Best = FoundItem{ item, distance };
    }
  }

  const ItemBoxes& Boxes;
  Lowest& LowestOf;
  Exact& ExactOf;
  std::optional<FoundItem> Best;
};

}

template <class Hit>
std::optional<FoundItem> FirstHit(
  const Octree& tree, const ItemBoxes& boxes, const Ray& ray, Hit&& hit)
{
  if (!ray.IsFinite())
  {
    return std::nullopt;
  }
  constexpr double none = std::numeric_limits<double>::infinity();
  auto enter = [&](const Box& box)
  {
    const RayRange range = RangeInBox(ray, box);
    return range.IsEmpty() ? none : range.Enter;
  };
  auto exact = [&](std::uint32_t item, const Box& box, double)
  {
    const RayRange range = RangeInBox(ray, box);
    const std::optional<double> distance = hit(item);
    const bool isHit = distance && *distance >= 0 && *distance <= ray.Furthest && *distance < none;
    return isHit ? std::clamp(*distance, range.Enter, range.Leave) : none;
  };
  detail::NearestSearch search(boxes, enter, exact);
  search.Visit(tree.UnplacedItems().data(), tree.UnplacedItems().size());
  WalkFrontToBack(tree, OrderAlong(ray.Direction), search);
  return search.Found();
}

template <class Distance>
std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point, Distance&& distance)
{
  if (!Ray{ point }.IsFinite())
  {
    return std::nullopt;
  }
  auto toBox = [&](const Box& box) { return DistanceTo(box, point); };
  auto exact = [&](std::uint32_t item, const Box&, double lowest)
  {
    const double length = distance(item);
    return length < lowest ? lowest : length;
  };
  detail::NearestSearch search(boxes, toBox, exact);
  search.Visit(tree.UnplacedItems().data(), tree.UnplacedItems().size());
  WalkFrontToBack(tree, OrderFromEye(glm::vec3(point)), search);
  return search.Found();
}

}

#endif
