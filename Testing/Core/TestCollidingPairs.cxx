#include "OctreeScenes.h"

#include "Core/octree/CollidingPairs.h"
#include "Core/octree/Triangle.h"
#include "Core/octree/TriangleBoxes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace octree_scenes;
using vitrine::Collide;
using vitrine::CollidingPairs;
using vitrine::ItemPair;
using vitrine::Ray;
using vitrine::RayMeets;
using vitrine::Triangle;
using vitrine::TrianglesMeet;
using Pairs = std::vector<ItemPair>;

bool Always(std::uint32_t, std::uint32_t)
{
  return true;
}

const Triangle Flat{ glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 0) };

TEST(Triangle, MeetsWhatPiercesItOrLiesInItsPlane)
{
  const auto meets = [](const Triangle& other)
  {
    EXPECT_EQ(TrianglesMeet(Flat, other), TrianglesMeet(other, Flat));
    return TrianglesMeet(Flat, other);
  };
  EXPECT_TRUE(meets({ glm::dvec3(1, 1, -1), glm::dvec3(1, 1, 1), glm::dvec3(9, 9, 1) }));
  EXPECT_FALSE(meets({ glm::dvec3(3, 3, -1), glm::dvec3(3, 3, 1), glm::dvec3(9, 9, 1) }));
  EXPECT_FALSE(meets({ glm::dvec3(1, 1, 0.1), glm::dvec3(1, 1, 1), glm::dvec3(9, 9, 1) }));
  EXPECT_TRUE(
    meets({ glm::dvec3(1, 1, 0), glm::dvec3(1, 1, 1), glm::dvec3(9, 9, 1) })); // by a corner
  EXPECT_TRUE(meets({ glm::dvec3(0, 0, 0), glm::dvec3(-4, 0, 0), glm::dvec3(0, -4, 0) }));
  EXPECT_TRUE(
    meets({ glm::dvec3(1, 1, 0), glm::dvec3(1.1, 1, 0), glm::dvec3(1, 1.1, 0) })); // within
  EXPECT_FALSE(meets({ glm::dvec3(3, 3, 0), glm::dvec3(4, 3, 0), glm::dvec3(3, 4, 0) }));
  EXPECT_FALSE(meets({ glm::dvec3(1, 1, 1), glm::dvec3(2, 1, 1), glm::dvec3(1, 2, 1) }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(meets({ glm::dvec3(nan, 1, -1), glm::dvec3(1, 1, 1), glm::dvec3(9, 9, 1) }));
}

TEST(Triangle, IsMetByARayFromEitherSideWithinItsEnds)
{
  const glm::dvec3 down(0, 0, -2);
  EXPECT_EQ(RayMeets({ { 1, 1, 3 }, down }, Flat), 1.5);
  EXPECT_EQ(RayMeets({ { 1, 1, -3 }, -down }, Flat), 1.5);
  EXPECT_EQ(RayMeets({ { 1, 1, 3 }, down, 1.5 }, Flat), 1.5);
  EXPECT_FALSE(RayMeets({ { 1, 1, 3 }, down, 1.49 }, Flat));
  EXPECT_FALSE(RayMeets({ { 1, 1, -3 }, down }, Flat)); // behind
  EXPECT_FALSE(RayMeets({ { 3, 3, 3 }, down }, Flat));
  EXPECT_TRUE(RayMeets({ { 2, 2, 3 }, down }, Flat));         // on an edge
  EXPECT_FALSE(RayMeets({ { 1, 1, 0 }, { 1, 0, 0 } }, Flat)); // in its plane
  EXPECT_FALSE(RayMeets({ { 1, 1, 3 }, { 0, 0, 0 } }, Flat));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(RayMeets({ { nan, 1, 3 }, down }, Flat));
}

TEST(CollidingPairs, OfTwoRowsAreThoseThatTouch)
{
  std::vector<Box> below;
  std::vector<Box> above;
  for (int i = 0; i < 20; ++i)
  {
    below.push_back(BoxAt({ i, 0, 0 }, { 0.5f, 1, 1 }));
    above.push_back(
      BoxAt({ i + 0.75f, 1, 0 }, { 0.25f, 1, 1 })); // touches the next one below by an edge
  }
  const Pairs pairs = CollidingPairs(
    Octree(ViewOf(below), 1), ViewOf(below), Octree(ViewOf(above), 2), ViewOf(above), Always);
  Pairs expected;
  for (std::uint32_t i = 0; i < 19; ++i)
  {
    expected.emplace_back(i + 1, i);
  }
  EXPECT_EQ(pairs, expected);
}

TEST(CollidingPairs, OfTheTrianglesOfTwoPartsAreThoseThatMeet)
{
  // Two crossed plates of two triangles each, and a plate apart; a part's own triangles do not count.
  const float points[] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0.1f, -1, 0.5f, 0.1f, 1, 0.5f,
    0.2f, 1, 0.5f, 0.2f, -1, 0, 0, 5, 1, 0, 5, 1, 1, 5, 0, 1, 5 };
  const std::uint32_t corners[] = { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 9, 10, 8, 10, 11 };
  const vitrine::TriangleBoxes<float, std::uint32_t> mesh(points, corners, 6);
  const Octree tree(mesh, 1);
  const auto areCrossed = [&](std::uint32_t a, std::uint32_t b)
  { return a / 2 != b / 2 && TrianglesMeet(mesh.TriangleAt(a), mesh.TriangleAt(b)); };
  EXPECT_EQ(CollidingPairs(tree, mesh, areCrossed), (Pairs{ { 0, 2 }, { 0, 3 } }));
  EXPECT_TRUE(Collide(tree, mesh, tree, mesh, areCrossed));
  const auto areFar = [&](std::uint32_t a, std::uint32_t b)
  { return a / 2 == 2 && b / 2 != 2 && TrianglesMeet(mesh.TriangleAt(a), mesh.TriangleAt(b)); };
  EXPECT_FALSE(Collide(tree, mesh, tree, mesh, areFar));
}

TEST(CollidingPairs, AreThoseOfBruteForceEachTestedOnce)
{
  const unsigned seed = 60;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Kinds kind : AllKinds())
  {
    for (const Kinds otherKind : AllKinds())
    {
      SCOPED_TRACE(static_cast<int>(kind));
      SCOPED_TRACE(static_cast<int>(otherKind));
      const std::vector<Box> boxes = RandomBoxes(kind, 150, random);
      const std::vector<Box> others = RandomBoxes(otherKind, 120, random);
      const auto test = [](std::uint32_t a, std::uint32_t b) { return (a + b) % 3 != 0; };
      Pairs expected;
      Pairs expectedWithin;
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
      {
        for (std::uint32_t j = 0; j < others.size(); ++j)
        {
          if (Touches(boxes[i], others[j]) && test(i, j))
          {
            expected.emplace_back(i, j);
          }
        }
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
        {
          if (Touches(boxes[i], boxes[j]) && test(i, j))
          {
            expectedWithin.emplace_back(i, j);
          }
        }
      }
      const Octree tree(ViewOf(boxes), 1 + random() % 9);
      const Octree other(ViewOf(others), 1 + random() % 9);
      std::set<ItemPair> tested;
      const auto testOnce = [&](std::uint32_t a, std::uint32_t b)
      {
        EXPECT_TRUE(tested.insert({ a, b }).second);
        return test(a, b);
      };
      EXPECT_EQ(CollidingPairs(tree, ViewOf(boxes), other, ViewOf(others), testOnce), expected);
      EXPECT_EQ(CollidingPairs(tree, ViewOf(boxes), test), expectedWithin);
      EXPECT_EQ(Collide(tree, ViewOf(boxes), other, ViewOf(others), test), !expected.empty());
    }
  }
}

}
