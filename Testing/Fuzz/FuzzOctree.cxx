// Builds an octree of made-up boxes, moves some of them and asks questions, with brute force as the judge.

#include "FuzzBytes.h"

#include "Core/octree/CollidingPairs.h"
#include "Core/octree/ItemMarks.h"
#include "Core/octree/OctreeQueries.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace vitrine;
using Numbers = std::vector<std::uint32_t>;

constexpr unsigned MostItems = 80;

glm::vec3 PointOf(FuzzBytes& bytes)
{
  const float x = bytes.Number();
  const float y = bytes.Number();
  return { x, y, bytes.Number() };
}

Box BoxOf(FuzzBytes& bytes)
{
  Box box{ PointOf(bytes), PointOf(bytes) };
  const bool isOrdered = bytes.Below(8) != 0;
  for (int axis = 0; axis < 3 && isOrdered; ++axis)
  {
    if (box.Min[axis] > box.Max[axis])
    {
      std::swap(box.Min[axis], box.Max[axis]);
    }
  }
  return box;
}

// A tree, which items it holds, and where they are.
struct Scene
{
  std::vector<Box> Boxes;
  std::vector<bool> IsHeld;
  Octree Tree;

  BoxArray View() const
  {
    return { this->Boxes.data(), static_cast<std::uint32_t>(this->Boxes.size()) };
  }

  template <class IsFound>
  Numbers ByBruteForce(const IsFound& isFound) const
  {
    Numbers found;
    for (std::uint32_t item = 0; item < this->Boxes.size(); ++item)
    {
      if (this->IsHeld[item] && isFound(this->Boxes[item]))
      {
        found.push_back(item);
      }
    }
    return found;
  }
};

void Change(Scene& scene, FuzzBytes& bytes)
{
  std::vector<Octree::MovedItem> moved;
  for (unsigned count = bytes.Below(4) + 1; count > 0; --count)
  {
    const std::uint32_t item = bytes.Below(static_cast<unsigned>(scene.Boxes.size()));
    const bool isMoved = std::any_of(moved.begin(), moved.end(),
      [&](const Octree::MovedItem& other) { return other.Item == item; });
    if (isMoved)
    {
      continue;
    }
    if (!scene.IsHeld[item])
    {
      scene.Tree.Insert(item, scene.View());
      scene.IsHeld[item] = true;
    }
    else if (bytes.Below(3) == 0)
    {
      scene.Tree.Remove(item, scene.Boxes[item], scene.View());
      scene.IsHeld[item] = false;
    }
    else
    {
      moved.push_back({ item, scene.Boxes[item] });
    }
  }
  for (const Octree::MovedItem& move : moved)
  {
    scene.Boxes[move.Item] = BoxOf(bytes);
  }
  scene.Tree.Move(moved.data(), moved.size(), scene.View());
}

void AskForBoxes(const Scene& scene, FuzzBytes& bytes)
{
  const Box box = BoxOf(bytes);
  Require(ItemsTouching(scene.Tree, scene.View(), box) ==
      scene.ByBruteForce([&](const Box& item) { return Touches(box, item); }),
    "other items touch the box");
  Require(ItemsWithin(scene.Tree, scene.View(), box) ==
      scene.ByBruteForce([&](const Box& item) { return Contains(box, item); }),
    "other items are within the box");
}

void AskForSphere(const Scene& scene, FuzzBytes& bytes)
{
  const Sphere sphere{ PointOf(bytes), bytes.Number() };
  const bool isSphere = Ray{ sphere.Centre }.IsFinite();
  Require(ItemsTouching(scene.Tree, scene.View(), sphere) ==
      scene.ByBruteForce(
        [&](const Box& item) {
          return isSphere && !item.IsEmpty() && DistanceTo(item, sphere.Centre) <= sphere.Radius;
        }),
    "other items touch the sphere");
}

void AskForRay(const Scene& scene, FuzzBytes& bytes)
{
  const Ray ray{ PointOf(bytes), PointOf(bytes), bytes.Number() };
  const auto isMet = [&](const Box& item)
  { return ray.IsFinite() && !RangeInBox(ray, item).IsEmpty(); };
  const Numbers met = scene.ByBruteForce(isMet);
  Require(ItemsAlong(scene.Tree, scene.View(), ray) == met, "the ray meets other items");

  // Each box is hit where the ray leaves it.
  const auto hit = [&](std::uint32_t item)
  { return std::optional<double>(RangeInBox(ray, scene.Boxes[item]).Leave); };
  std::optional<FoundItem> first;
  for (const std::uint32_t item : met)
  {
    const double distance = *hit(item);
    if (std::isfinite(distance) && (!first || distance < first->Distance))
    {
      first = FoundItem{ item, distance };
    }
  }
  const std::optional<FoundItem> found = FirstHit(scene.Tree, scene.View(), ray, hit);
  Require(found.has_value() == first.has_value(), "the ray hits something else or nothing");
  Require(!found || (found->Item == first->Item && found->Distance == first->Distance),
    "the ray hits another item first");
}

void AskForNearest(const Scene& scene, FuzzBytes& bytes)
{
  const glm::dvec3 point = PointOf(bytes);
  std::optional<FoundItem> nearest;
  if (Ray{ point }.IsFinite())
  {
    for (const std::uint32_t item :
      scene.ByBruteForce([](const Box& box) { return !box.IsEmpty(); }))
    {
      const double distance = DistanceTo(scene.Boxes[item], point);
      if (std::isfinite(distance) && (!nearest || distance < nearest->Distance))
      {
        nearest = FoundItem{ item, distance };
      }
    }
  }
  const std::optional<FoundItem> found = NearestItem(scene.Tree, scene.View(), point);
  Require(found.has_value() == nearest.has_value(), "something or nothing is nearest");
  Require(!found || found->Item == nearest->Item, "another item is nearest");
}

void AskForPairs(const Scene& scene)
{
  std::vector<ItemPair> expected;
  for (std::uint32_t a = 0; a < scene.Boxes.size(); ++a)
  {
    for (std::uint32_t b = a + 1; b < scene.Boxes.size(); ++b)
    {
      if (scene.IsHeld[a] && scene.IsHeld[b] && Touches(scene.Boxes[a], scene.Boxes[b]))
      {
        expected.emplace_back(a, b);
      }
    }
  }
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  Require(CollidingPairs(scene.Tree, scene.View(), all) == expected, "other pairs collide");
}

// Comes by every item whose box the nodes above it hold, whatever the eye.
void Walk(const Scene& scene, FuzzBytes& bytes)
{
  struct Visitor
  {
    const Scene& Items;
    ItemMarks Marks{ MostItems };
    std::size_t Count = 0;

    bool Enter(const OctreeNode& node)
    {
      Require(node.Bounds.IsPlaceable(), "a node has an impossible box");
      return true;
    }
    void Visit(const OctreeNode& leaf, const std::uint32_t* items, std::uint32_t count)
    {
      for (std::uint32_t i = 0; i < count; ++i)
      {
        Require(this->Items.IsHeld[items[i]], "a leaf holds an item that was removed");
        Require(
          Touches(leaf.Bounds, this->Items.Boxes[items[i]]), "an item is in a leaf beside it");
        this->Count += this->Marks.Mark(items[i]);
      }
    }
  };
  Visitor visitor{ scene };
  WalkFrontToBack(scene.Tree, OrderFromEye(PointOf(bytes)), visitor);
  const Numbers placed = scene.ByBruteForce([](const Box& box) { return box.IsPlaceable(); });
  Require(visitor.Count == placed.size(), "the walk leaves items out");
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  Scene scene;
  const std::uint32_t leafSize = 1 + bytes.Below(6);
  scene.Boxes.resize(1 + bytes.Below(MostItems));
  for (Box& box : scene.Boxes)
  {
    box = BoxOf(bytes);
  }
  scene.IsHeld.assign(scene.Boxes.size(), true);
  scene.Tree = Octree(scene.View(), leafSize);
  while (bytes.AreLeft())
  {
    switch (bytes.Below(8))
    {
      case 0:
        AskForBoxes(scene, bytes);
        break;
      case 1:
        AskForSphere(scene, bytes);
        break;
      case 2:
        AskForRay(scene, bytes);
        break;
      case 3:
        AskForNearest(scene, bytes);
        break;
      case 4:
        AskForPairs(scene);
        break;
      case 5:
        Walk(scene, bytes);
        break;
      default:
        Change(scene, bytes);
        break;
    }
  }
  return 0;
}
