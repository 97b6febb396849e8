#include "Core/octree/OctreeQueries.h"

#include <algorithm>

namespace vitrine
{

namespace
{

// Collects the items whose boxes satisfy `isFound`, below nodes whose boxes satisfy `mayHold`.
template <class MayHold, class IsFound>
class Collector
{
public:
  Collector(const ItemBoxes& boxes, const MayHold& mayHold, const IsFound& isFound)
    : Boxes(boxes)
    , NodeMayHold(mayHold)
    , ItemIsFound(isFound)
  {
  }

  bool Enter(const OctreeNode& node) const { return this->NodeMayHold(node.Bounds); }

  void Visit(const OctreeNode&, const std::uint32_t* items, std::uint32_t count)
  {
    this->Visit(items, count);
  }

  void Visit(const std::uint32_t* items, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->ItemIsFound(this->Boxes.At(items[i])))
      {
        this->Found.push_back(items[i]);
      }
    }
  }

  std::vector<std::uint32_t> Sorted()
  {
    std::sort(this->Found.begin(), this->Found.end());
    this->Found.erase(std::unique(this->Found.begin(), this->Found.end()), this->Found.end());
    return std::move(this->Found);
  }

private:
  const ItemBoxes& Boxes;
  const MayHold& NodeMayHold;
  const IsFound& ItemIsFound;
  std::vector<std::uint32_t> Found;
};

template <class MayHold, class IsFound>
std::vector<std::uint32_t> Collect(
  const Octree& tree, const ItemBoxes& boxes, const MayHold& mayHold, const IsFound& isFound)
{
  Collector<MayHold, IsFound> collector(boxes, mayHold, isFound);
  collector.Visit(tree.UnplacedItems().data(), tree.UnplacedItems().size());
  WalkFrontToBack(tree, OrderAlong(glm::vec3(0.0f)), collector);
  return collector.Sorted();
}

bool IsSphere(const Sphere& sphere)
{
  return IsFinite(sphere.Centre) && sphere.Radius >= 0;
}

double FarthestDistance(const Box& box, const glm::dvec3& point)
{
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beside = std::max(point[axis] - box.Min[axis], box.Max[axis] - point[axis]);
    sum += beside * beside;
  }
  return std::sqrt(sum);
}

}

std::vector<std::uint32_t> ItemsTouching(const Octree& tree, const ItemBoxes& boxes, const Box& box)
{
  const auto touches = [&](const Box& other) { return Touches(box, other); };
  return Collect(tree, boxes, touches, touches);
}

std::vector<std::uint32_t> ItemsWithin(const Octree& tree, const ItemBoxes& boxes, const Box& box)
{
  return Collect(
    tree, boxes, [&](const Box& node) { return Touches(box, node); },
    [&](const Box& item) { return Contains(box, item); });
}

std::vector<std::uint32_t> ItemsTouching(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere)
{
  const auto touches = [&](const Box& box)
  { return !box.IsEmpty() && DistanceTo(box, sphere.Centre) <= sphere.Radius; };
  return IsSphere(sphere) ? Collect(tree, boxes, touches, touches) : std::vector<std::uint32_t>();
}

std::vector<std::uint32_t> ItemsWithin(
  const Octree& tree, const ItemBoxes& boxes, const Sphere& sphere)
{
  if (!IsSphere(sphere))
  {
    return {};
  }
  return Collect(
    tree, boxes, [&](const Box& node) { return DistanceTo(node, sphere.Centre) <= sphere.Radius; },
    [&](const Box& item)
    { return !item.IsEmpty() && FarthestDistance(item, sphere.Centre) <= sphere.Radius; });
}

std::vector<std::uint32_t> ItemsAlong(const Octree& tree, const ItemBoxes& boxes, const Ray& ray)
{
  const auto meets = [&](const Box& box) { return !RangeInBox(ray, box).IsEmpty(); };
  return ray.IsFinite() ? Collect(tree, boxes, meets, meets) : std::vector<std::uint32_t>();
}

std::optional<FoundItem> NearestItem(
  const Octree& tree, const ItemBoxes& boxes, const glm::dvec3& point)
{
  return NearestItem(tree, boxes, point, [](std::uint32_t) { return 0.0; });
}

}
