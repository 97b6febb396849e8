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

// Questions to an octree. Each has the answer that asking every item has, to the last bit: what is monotone in a box's
// sides, rounding included, holds for a node wherever it holds for an item below. `boxes` are those that the tree was
// built with. An item whose box is empty or has a NaN is never found; one with an infinite box is, where the box lies.
// All throw std::runtime_error where a page of the tree is on disk and cannot be read.

namespace vitrine
{

/** The points no farther from a centre than a radius. With a NaN, an infinite centre or a negative radius, none. */
struct Sphere
{
  glm::dvec3 Centre{ 0.0 };
  double Radius = 0.0;
};

/** How far a point is from a box that is not empty. */
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

/** Items whose boxes have a point in common with a box, in ascending order. */
std::vector<std::uint32_t> ItemsTouching(
  const Octree& tree, const ItemBoxes& boxes, const Box& box);

/** Items whose boxes lie in a box, in ascending order. */
std::vector<std::uint32_t> ItemsWithin(const Octree& tree, const ItemBoxes& boxes, const Box& box);

/** Items whose boxes have a point in common with a sphere, in ascending order. */
std::vector<std::uint32_t> ItemsTouching(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere);

/** Items whose boxes lie in a sphere, in ascending order. */
std::vector<std::uint32_t> ItemsWithin(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere);

/** Items whose boxes a ray meets, in ascending order. */
std::vector<std::uint32_t> ItemsAlong(const Octree& tree, const ItemBoxes& boxes, const Ray& ray);

/** What was found first or nearest. */
struct FoundItem
{
  std::uint32_t Item;
  double Distance; ///< of a hit, in lengths of the ray's direction
};

/**
 * The item that a ray hits first, of equally far ones the lowest number.
 *
 * @param hit  `std::optional<double> hit(std::uint32_t item)`: how far along the ray it is met. Asked only for items whose
 *             boxes the ray meets. A distance outside of the ray's range in the box, as by rounding, counts as the
 *             range's end; one that is NaN, infinite, negative or beyond the ray's end is no hit.
 */
template <class Hit>
std::optional<FoundItem> FirstHit(
  const Octree& tree, const ItemBoxes& boxes, const Ray& ray, Hit&& hit);

/**
 * The item nearest to a point, of equally near ones the lowest number. None for a point that is not finite.
 *
 * @param distance  `double distance(std::uint32_t item)`: from the point to the item. One smaller than that to the item's
 *                  box counts as that to the box; an item whose distance is NaN or infinite is left out.
 */
template <class Distance>
std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point, Distance&& distance);

/** As above, by the distances to the items' boxes. */
std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point);

namespace detail
{

// Finds the item with the smallest distance.
template <class Lowest, class Exact>
class NearestSearch
{
public:
  // `lowest` tells a box's distance, infinite or NaN where it is out of reach, and `exact` an item's from that and itself.
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
