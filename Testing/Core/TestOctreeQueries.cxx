#include "NonFinite.h"
#include "OctreeScenes.h"

#include "Core/octree/OctreeQueries.h"
#include "Core/octree/TriangleBoxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace
{

using namespace octree_scenes;
using vitrine::DistanceTo;
using vitrine::FirstHit;
using vitrine::FoundItem;
using vitrine::ItemBoxes;
using vitrine::ItemsAlong;
using vitrine::ItemsTouching;
using vitrine::ItemsWithin;
using vitrine::NearestItem;
using vitrine::Ray;
using vitrine::RayMeets;
using vitrine::Sphere;
using vitrine::Triangle;
using Numbers = std::vector<std::uint32_t>;

// Unit cubes at x = 0, 2, 4, ...
std::vector<Box> RowOfCubes(int count)
{
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i)
  {
    boxes.push_back(BoxAt({ 2.0f * i, 0, 0 }, glm::vec3(1)));
  }
  return boxes;
}

TEST(OctreeQueries, BoxTouchesAndHoldsTheCubesOfARow)
{
  const std::vector<Box> boxes = RowOfCubes(10);
  const Octree tree(ViewOf(boxes), 1);
  const auto touching = [&](const Box& box) { return ItemsTouching(tree, ViewOf(boxes), box); };
  const auto within = [&](const Box& box) { return ItemsWithin(tree, ViewOf(boxes), box); };
  EXPECT_EQ(touching({ { 3, 0, 0 }, { 6, 1, 1 } }), (Numbers{ 1, 2, 3 })); // 1 and 3 by a side
  EXPECT_EQ(within({ { 3, 0, 0 }, { 6, 1, 1 } }), (Numbers{ 2 }));
  EXPECT_EQ(within({ { 2, 0, 0 }, { 7, 1, 1 } }), (Numbers{ 1, 2, 3 }));
  EXPECT_EQ(touching({ { 3.5f, 0, 0 }, { 3.5f, 0, 0 } }), Numbers());
  EXPECT_EQ(touching({ { 6, 0, 0 }, { 3, 1, 1 } }), Numbers());
  EXPECT_EQ(touching(Box::Everything()).size(), 10u);
  EXPECT_EQ(within(Box::Everything()).size(), 10u);
}

TEST(OctreeQueries, SphereTouchesAndHoldsTheCubesOfARow)
{
  const std::vector<Box> boxes = RowOfCubes(10);
  const Octree tree(ViewOf(boxes), 1);
  const auto touching = [&](const Sphere& sphere)
  { return ItemsTouching(tree, ViewOf(boxes), sphere); };
  const auto within = [&](const Sphere& sphere)
  { return ItemsWithin(tree, ViewOf(boxes), sphere); };
  EXPECT_EQ(touching({ { 4.5, 0.5, 0.5 }, 1.5 }), (Numbers{ 1, 2, 3 }));
  EXPECT_EQ(touching({ { 4.5, 0.5, 0.5 }, 1.4 }), (Numbers{ 2 }));
  EXPECT_EQ(within({ { 4.5, 0.5, 0.5 }, 0.87 }), (Numbers{ 2 })); // half a diagonal is 0.866
  EXPECT_EQ(within({ { 4.5, 0.5, 0.5 }, 0.86 }), Numbers());
  EXPECT_EQ(touching({ { 4.5, 0.5, 0.5 }, Infinity }).size(), 10u);
  EXPECT_EQ(touching({ { 4.5, 0.5, 0.5 }, 0 }), (Numbers{ 2 }));
  for (const Sphere& none :
    { Sphere{ { 4.5, 0.5, 0.5 }, -1 }, Sphere{ { 4.5, 0.5, 0.5 }, NotANumber },
      Sphere{ { NotANumber, 0.5, 0.5 }, 1 }, Sphere{ { Infinity, 0.5, 0.5 }, Infinity } })
  {
    EXPECT_EQ(touching(none), Numbers());
    EXPECT_EQ(within(none), Numbers());
  }
}

TEST(OctreeQueries, RayMeetsTheCubesOfARow)
{
  const std::vector<Box> boxes = RowOfCubes(10);
  const Octree tree(ViewOf(boxes), 1);
  const auto along = [&](const Ray& ray) { return ItemsAlong(tree, ViewOf(boxes), ray); };
  EXPECT_EQ(along({ { -1, 0.5, 0.5 }, { 1, 0, 0 } }).size(), 10u);
  EXPECT_EQ(along({ { -1, 0.5, 0.5 }, { -1, 0, 0 } }), Numbers());
  EXPECT_EQ(along({ { 8.5, 0.5, 0.5 }, { -2, 0, 0 }, 1.5 }), (Numbers{ 3, 4 }));
  EXPECT_EQ(along({ { -1, 1, 1 }, { 1, 0, 0 } }).size(), 10u); // along an edge
  EXPECT_EQ(along({ { -1, 1.001, 1 }, { 1, 0, 0 } }), Numbers());
  EXPECT_EQ(along({ { 0.5, -1, 0.5 }, { 1, 1, 0 } }), (Numbers{ 1 }));  // touches (2, 0.5)
  EXPECT_EQ(along({ { 2.5, 0.5, 0.5 }, { 0, 0, 0 } }), (Numbers{ 1 })); // a point
  EXPECT_EQ(along({ { NotANumber, 0, 0 }, { 1, 0, 0 } }), Numbers());
  EXPECT_EQ(along({ { 0, 0, 0 }, { Infinity, 0, 0 } }), Numbers());
  EXPECT_EQ(along({ { 2.5, 0.5, 0.5 }, { 1, 0, 0 }, NotANumber }), Numbers());
  EXPECT_EQ(along({ { 2.5, 0.5, 0.5 }, { 1, 0, 0 }, -1 }), Numbers());
}

TEST(OctreeQueries, NearestOfEquallyNearCubesIsTheFirst)
{
  const std::vector<Box> boxes = RowOfCubes(10);
  const Octree tree(ViewOf(boxes), 1);
  const std::optional<FoundItem> between = NearestItem(tree, ViewOf(boxes), { 5.5, 0.5, 0.5 });
  ASSERT_TRUE(between);
  EXPECT_EQ(between->Item, 2u);
  EXPECT_EQ(between->Distance, 0.5);
  EXPECT_EQ(NearestItem(tree, ViewOf(boxes), { 100, 0.5, 0.5 })->Item, 9u);
  EXPECT_FALSE(NearestItem(tree, ViewOf(boxes), { NotANumber, 0, 0 }));
  EXPECT_FALSE(NearestItem(Octree(), ViewOf(boxes), { 0, 0, 0 }));
  // One may leave items out.
  const auto other = NearestItem(tree, ViewOf(boxes), { 5.5, 0.5, 0.5 },
    [](std::uint32_t item) { return item == 2 ? Infinity : 0.0; });
  EXPECT_EQ(other->Item, 3u);
}

TEST(OctreeQueries, RayHitsTheTriangleInFrontAndNotTheBoxOfAnother)
{
  // Two parallel triangles, and before them one whose box the ray meets and which it passes by.
  const float points[] = { 0, 0, 1, 4, 0, 1, 0, 4, 1, 0, 0, 2, 4, 0, 2, 0, 4, 2, 4, 4, 0, 4, 3, 0,
    0, 4, 0 };
  const std::uint32_t corners[] = { 3, 4, 5, 0, 1, 2, 6, 7, 8 };
  const vitrine::TriangleBoxes<float, std::uint32_t> mesh(points, corners, 3);
  const Octree tree(mesh, 1);
  const Ray ray{ { 1, 3.1, -1 }, { 0, 0, 0.5 } };
  const auto hit = [&](std::uint32_t item) { return RayMeets(ray, mesh.TriangleAt(item)); };
  EXPECT_FALSE(FirstHit(tree, mesh, ray, hit));
  const Ray through{ { 1, 1, -1 }, { 0, 0, 0.5 } };
  const auto hitThrough = [&](std::uint32_t item)
  { return RayMeets(through, mesh.TriangleAt(item)); };
  const auto found = FirstHit(tree, mesh, through, hitThrough);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->Item, 1u);
  EXPECT_EQ(found->Distance, 4.0);
}

// A query's number: one of a scene's coordinates, so that it lies in sides and planes; anywhere; or hostile.
double QueryNumber(const std::vector<Box>& boxes, std::mt19937& random)
{
  const unsigned kind = random() % 20;
  if (kind == 0)
  {
    return HostileNumber(random);
  }
  const Box& box = boxes[random() % boxes.size()];
  const int axis = random() % 3;
  return kind < 10 ? box.Min[axis] : kind < 15 ? box.Max[axis] : Uniform(random, -2, 2);
}

class RandomQueries
{
public:
  RandomQueries(const std::vector<Box>& boxes, std::mt19937& random)
    : Boxes(boxes)
    , View(ViewOf(boxes))
    , Random(random)
  {
  }

  void Ask(const Octree& tree)
  {
    this->AskBox(tree);
    this->AskSphere(tree);
    this->AskRay(tree);
    this->AskPoint(tree);
  }

private:
  double Number() { return QueryNumber(this->Boxes, this->Random); }
  glm::dvec3 Point()
  {
    const double x = this->Number();
    const double y = this->Number();
    return { x, y, this->Number() };
  }

  template <class IsFound>
  Numbers ByBruteForce(const IsFound& isFound) const
  {
    Numbers found;
    for (std::uint32_t item = 0; item < this->Boxes.size(); ++item)
    {
      if (isFound(this->Boxes[item]))
      {
        found.push_back(item);
      }
    }
    return found;
  }

  void AskBox(const Octree& tree)
  {
    Box box{ glm::vec3(this->Point()), glm::vec3(this->Point()) };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (box.Min[axis] > box.Max[axis] && this->Random() % 10 != 0)
      {
        std::swap(box.Min[axis], box.Max[axis]);
      }
    }
    EXPECT_EQ(ItemsTouching(tree, this->View, box),
      this->ByBruteForce([&](const Box& item) { return Touches(box, item); }));
    EXPECT_EQ(ItemsWithin(tree, this->View, box),
      this->ByBruteForce([&](const Box& item) { return Contains(box, item); }));
  }

  void AskSphere(const Octree& tree)
  {
    const Sphere sphere{ this->Point(), std::abs(this->Number()) };
    const bool isSphere = std::isfinite(sphere.Centre.x + sphere.Centre.y + sphere.Centre.z);
    EXPECT_EQ(ItemsTouching(tree, this->View, sphere),
      this->ByBruteForce(
        [&](const Box& item) {
          return isSphere && !item.IsEmpty() && DistanceTo(item, sphere.Centre) <= sphere.Radius;
        }));
    EXPECT_EQ(ItemsWithin(tree, this->View, sphere),
      this->ByBruteForce(
        [&](const Box& item)
        {
          // Each corner is no farther than the radius.
          bool isWithin = isSphere && !item.IsEmpty();
          for (int corner = 0; corner < 8 && isWithin; ++corner)
          {
            const glm::vec3 point(corner & 1 ? item.Max.x : item.Min.x,
              corner & 2 ? item.Max.y : item.Min.y, corner & 4 ? item.Max.z : item.Min.z);
            isWithin = DistanceTo({ point, point }, sphere.Centre) <= sphere.Radius;
          }
          return isWithin;
        }));
  }

  void AskRay(const Octree& tree)
  {
    Ray ray{ this->Point(), this->Point() };
    if (this->Random() % 2 == 0)
    {
      ray.Direction[this->Random() % 3] = 0;
    }
    if (this->Random() % 2 == 0)
    {
      ray.Furthest = this->Number();
    }
    const auto meets = [&](const Box& item)
    { return ray.IsFinite() && !RangeInBox(ray, item).IsEmpty(); };
    EXPECT_EQ(ItemsAlong(tree, this->View, ray), this->ByBruteForce(meets));

    // Hits anywhere, in the box and beside it, and none.
    const auto hit = [&](std::uint32_t item)
    {
      const int kind = item % 7;
      return kind == 0 ? std::nullopt
        : kind == 1    ? std::optional<double>(NotANumber)
                       : std::optional<double>((item * 37 % 101) * 0.05 - 0.5);
    };
    std::optional<FoundItem> expected;
    for (const std::uint32_t item : this->ByBruteForce(meets))
    {
      const auto range = RangeInBox(ray, this->Boxes[item]);
      const std::optional<double> distance = hit(item);
      if (distance && *distance >= 0 && *distance <= ray.Furthest)
      {
        const double clamped = std::min(std::max(*distance, range.Enter), range.Leave);
        if (clamped < Infinity && (!expected || clamped < expected->Distance))
        {
          expected = FoundItem{ item, clamped };
        }
      }
    }
    this->Compare(FirstHit(tree, this->View, ray, hit), expected);
  }

  void AskPoint(const Octree& tree)
  {
    const glm::dvec3 point = this->Point();
    const auto farther = [&](std::uint32_t item)
    { return item % 5 == 0 ? NotANumber : (item * 53 % 97) * 0.02; };
    std::optional<FoundItem> nearest;
    std::optional<FoundItem> nearestByFunction;
    const auto offer = [](std::optional<FoundItem>& best, std::uint32_t item, double distance)
    {
      if (distance < Infinity && (!best || distance < best->Distance))
      {
        best = FoundItem{ item, distance };
      }
    };
    for (std::uint32_t item = 0; item < this->Boxes.size(); ++item)
    {
      if (std::isfinite(point.x + point.y + point.z) && !this->Boxes[item].IsEmpty())
      {
        const double toBox = DistanceTo(this->Boxes[item], point);
        offer(nearest, item, toBox);
        offer(nearestByFunction, item, farther(item) < toBox ? toBox : farther(item));
      }
    }
    this->Compare(NearestItem(tree, this->View, point), nearest);
    this->Compare(NearestItem(tree, this->View, point, farther), nearestByFunction);
  }

  void Compare(const std::optional<FoundItem>& found, const std::optional<FoundItem>& expected)
  {
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (found)
    {
      EXPECT_EQ(found->Item, expected->Item);
      EXPECT_EQ(found->Distance, expected->Distance);
    }
  }

  const std::vector<Box>& Boxes;
  BoxArray View;
  std::mt19937& Random;
};

TEST(OctreeQueries, AnswerAsBruteForceDoes)
{
  const unsigned seed = 40;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    for (const std::uint32_t leafSize : { 1u, 6u })
    {
      SCOPED_TRACE(static_cast<int>(kind));
      const std::vector<Box> boxes = RandomBoxes(kind, 400, random);
      const Octree tree(ViewOf(boxes), leafSize);
      RandomQueries queries(boxes, random);
      for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i)
      {
        SCOPED_TRACE(i);
        queries.Ask(tree);
      }
    }
  }
}

TEST(OctreeQueries, AnswerAsBruteForceDoesAfterMoves)
{
  const unsigned seed = 41;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<Box> boxes = RandomBoxes(Kinds::Mixed, 300, random);
  Octree tree(ViewOf(boxes), 4);
  RandomQueries queries(boxes, random);
  for (int i = 0; i < 500 && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE(i);
    const std::uint32_t item = random() % 300;
    const Octree::MovedItem move{ item, boxes[item] };
    boxes[item] = RandomBox(AllKinds()[random() % 6], random);
    tree.Move(&move, 1, ViewOf(boxes));
    queries.Ask(tree);
  }
}

}
