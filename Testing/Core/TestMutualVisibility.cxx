#include "OctreeScenes.h"

#include "Core/octree/MutualVisibility.h"
#include "Core/octree/Shaft.h"
#include "Core/octree/TriangleBoxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace
{

using namespace octree_scenes;
using vitrine::MaySeeEachOther;
using vitrine::Ray;
using vitrine::RayMeets;
using vitrine::Shaft;
using vitrine::Triangle;
using vitrine::TriangleBoxes;

// Triangles, with a tree when asked.
struct Mesh
{
  std::vector<float> Points;
  std::vector<std::uint32_t> Corners;

  std::uint32_t AddPoint(const glm::vec3& point)
  {
    this->Points.insert(this->Points.end(), { point.x, point.y, point.z });
    return static_cast<std::uint32_t>(this->Points.size() / 3 - 1);
  }

  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    this->Corners.insert(this->Corners.end(), { a, b, c });
  }

  // A sheet of points(u, v), u and v from 0 to 1 in steps.
  template <class PointAt>
  void AddSheet(int steps, const PointAt& pointAt)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(this->Points.size() / 3);
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; j <= steps; ++j)
      {
        this->AddPoint(pointAt(static_cast<float>(i) / steps, static_cast<float>(j) / steps));
      }
    }
    for (int i = 0; i < steps; ++i)
    {
      for (int j = 0; j < steps; ++j)
      {
        const std::uint32_t a = first + i * (steps + 1) + j;
        const std::uint32_t b = a + steps + 1;
        this->AddTriangle(a, b, b + 1);
        this->AddTriangle(a, b + 1, a + 1);
      }
    }
  }

  TriangleBoxes<float, std::uint32_t> View() const
  {
    return { this->Points.data(), this->Corners.data(),
      static_cast<std::uint32_t>(this->Corners.size() / 3) };
  }

  bool MaySee(const Box& a, const Box& b, std::size_t most = 100000) const
  {
    const auto view = this->View();
    const auto blocker = [&](std::uint32_t item)
    { return std::optional<Triangle>(view.TriangleAt(item)); };
    const Octree tree(view, 4);
    EXPECT_EQ(
      MaySeeEachOther(tree, blocker, a, b, most), MaySeeEachOther(tree, blocker, b, a, most));
    return MaySeeEachOther(tree, blocker, a, b, most);
  }
};

// A square wall in the plane z = 0, from -size to size.
Mesh Wall(float size, int steps)
{
  Mesh mesh;
  mesh.AddSheet(
    steps, [&](float u, float v) { return glm::vec3(size * (2 * u - 1), size * (2 * v - 1), 0); });
  return mesh;
}

const Box InFront = BoxAt({ -0.5f, -0.5f, 1 }, glm::vec3(1));
const Box Behind = BoxAt({ -0.5f, -0.5f, -2 }, glm::vec3(1));

TEST(Shaft, HoldsTheBoxesAndWhatLiesBetween)
{
  const Shaft shaft(BoxAt(glm::vec3(0), glm::vec3(1)), BoxAt(glm::vec3(9), glm::vec3(1)));
  EXPECT_TRUE(shaft.MayMeet(BoxAt(glm::vec3(5), glm::vec3(0.1f))));
  EXPECT_TRUE(shaft.MayMeet(BoxAt(glm::vec3(-1), glm::vec3(1))));
  EXPECT_FALSE(shaft.MayMeet(BoxAt(glm::vec3(-1), glm::vec3(0.9f))));
  EXPECT_FALSE(shaft.MayMeet(BoxAt({ 0, 8, 5 }, glm::vec3(1))));   // in the box around both
  EXPECT_TRUE(shaft.MayMeet(BoxAt({ 5, 6, 5 }, glm::vec3(0.1f)))); // y <= x + 1
  EXPECT_FALSE(shaft.MayMeet(BoxAt({ 5, 6.2f, 5 }, glm::vec3(0.1f))));
  const glm::dvec3 across[] = { { 0, 9, 5 }, { 9, 0, 5 } };
  EXPECT_TRUE(shaft.MayMeet(across, 2));
  EXPECT_FALSE(shaft.MayMeet(across, 1));
}

TEST(Shaft, LeavesOutNoSegmentBetweenTheBoxes)
{
  const unsigned seed = 70;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Box a = BoxAt(RandomPoint(random, -1, 1), RandomPoint(random, 0, 1));
    const Box b = BoxAt(RandomPoint(random, -1, 1), RandomPoint(random, 0, 1));
    const Shaft shaft(a, b);
    for (int i = 0; i < 50; ++i)
    {
      const auto pick = [&](float low, float high) {
        return random() % 3 == 0 ? low : random() % 2 == 0 ? high : Uniform(random, low, high);
      };
      glm::vec3 point;
      const float share = Uniform(random, 0, 1);
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] =
          (1 - share) * pick(a.Min[axis], a.Max[axis]) + share * pick(b.Min[axis], b.Max[axis]);
      }
      const glm::vec3 beside = 1e-6f * glm::vec3(1);
      ASSERT_TRUE(shaft.MayMeet({ point - beside, point + beside }));
    }
  }
}

TEST(MutualVisibility, BoxesWithNothingBetweenSeeEachOther)
{
  EXPECT_TRUE(Mesh().MaySee(InFront, Behind));
  Mesh aside = Wall(2, 3);
  for (std::size_t i = 0; i < aside.Points.size(); i += 3)
  {
    aside.Points[i] += 10;
  }
  EXPECT_TRUE(aside.MaySee(InFront, Behind));
}

TEST(MutualVisibility, WallThatIsLargeEnoughBlocks)
{
  for (const int steps : { 1, 2, 7, 30 })
  {
    EXPECT_FALSE(Wall(0.51f, steps).MaySee(InFront, Behind)) << steps;
    EXPECT_TRUE(Wall(0.49f, steps).MaySee(InFront, Behind)) << steps;
    EXPECT_FALSE(Wall(50, steps).MaySee(InFront, Behind)) << steps;
  }
}

TEST(MutualVisibility, WallThatLacksATriangleDoesNotBlock)
{
  Mesh mesh = Wall(2, 10);
  ASSERT_FALSE(mesh.MaySee(InFront, Behind));
  const std::uint32_t middle = 2 * (5 * 10 + 5);
  mesh.Corners.erase(mesh.Corners.begin() + 3 * middle, mesh.Corners.begin() + 3 * middle + 3);
  EXPECT_TRUE(mesh.MaySee(InFront, Behind));
}

TEST(MutualVisibility, WallWithACrackDoesNotBlock)
{
  Mesh mesh = Wall(2, 10);
  // A corner in the middle moves for one of its triangles, by less than can be seen.
  const std::uint32_t old = 5 * 11 + 5;
  const std::uint32_t moved =
    mesh.AddPoint({ mesh.Points[3 * old], 1e-6f, mesh.Points[3 * old + 2] });
  for (std::uint32_t& corner : mesh.Corners)
  {
    if (corner == old)
    {
      corner = moved;
      break;
    }
  }
  EXPECT_TRUE(mesh.MaySee(InFront, Behind));
}

TEST(MutualVisibility, BentWallBlocksAndAFoldDoesNot)
{
  Mesh bent;
  bent.AddSheet(20,
    [](float u, float v)
    { return glm::vec3(4 * u - 2, 4 * v - 2, 0.7f * std::sin(9 * u) * std::cos(7 * v)); });
  EXPECT_FALSE(bent.MaySee(InFront, Behind));
  // A sheet folded back upon itself, which a segment crosses twice and another passes by.
  Mesh fold;
  fold.AddSheet(20,
    [](float u, float v)
    { return glm::vec3(2 * u - 2, 4 * v - 2, 0.5f * std::cos(3.14159265f * u) * 0.5f); });
  EXPECT_TRUE(fold.MaySee(InFront, Behind));
}

TEST(MutualVisibility, ClosedHousingBlocksFromInsideOutAndNotWithin)
{
  Mesh cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.AddPoint(2.0f * glm::vec3(i & 1, i >> 1 & 1, i >> 2 & 1) - 1.0f);
  }
  const std::uint32_t faces[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
  for (const auto& face : faces)
  {
    cube.AddTriangle(face[0], face[1], face[2]);
    cube.AddTriangle(face[0], face[2], face[3]);
  }
  const Box inside = BoxAt(glm::vec3(-0.2f), glm::vec3(0.4f));
  const Box alsoInside = BoxAt(glm::vec3(0.5f), glm::vec3(0.4f));
  const Box outside = BoxAt(glm::vec3(1.5f), glm::vec3(1));
  EXPECT_FALSE(cube.MaySee(inside, outside));
  EXPECT_TRUE(cube.MaySee(inside, alsoInside));
  // Not from one side to the other: each segment crosses twice, which proves nothing.
  EXPECT_TRUE(cube.MaySee(outside, BoxAt(glm::vec3(-2.5f), glm::vec3(1))));
  // A box that the housing runs through.
  EXPECT_TRUE(cube.MaySee(BoxAt(glm::vec3(0.5f), glm::vec3(1)), BoxAt(glm::vec3(4), glm::vec3(1))));
}

TEST(MutualVisibility, OfHostileBoxesIsAssumed)
{
  const Mesh mesh = Wall(50, 2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(mesh.MaySee(InFront, InFront));
  EXPECT_TRUE(mesh.MaySee(InFront, Box()));
  EXPECT_TRUE(mesh.MaySee(InFront, Box::Everything()));
  EXPECT_TRUE(mesh.MaySee(InFront, { glm::vec3(-1, -1, nan), glm::vec3(1, 1, -1) }));
  EXPECT_TRUE(mesh.MaySee(InFront, Behind, 3)); // of 8 triangles
  EXPECT_FALSE(mesh.MaySee(InFront, Behind, 8));
  // Points are boxes too.
  EXPECT_FALSE(mesh.MaySee({ { 1, 3, 1 }, { 1, 3, 1 } }, { { 1, 3, -1 }, { 1, 3, -1 } }));
}

TEST(MutualVisibility, WhatDoesNotBlockIsLookedThrough)
{
  const Mesh mesh = Wall(2, 4);
  const auto view = mesh.View();
  const auto translucent = [&](std::uint32_t item)
  { return item == 20 ? std::nullopt : std::optional<Triangle>(view.TriangleAt(item)); };
  EXPECT_TRUE(MaySeeEachOther(Octree(view), translucent, InFront, Behind));
}

TEST(MutualVisibility, NeverDeniedWhereASegmentIsFree)
{
  const unsigned seed = 71;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int denied = 0;
  for (int trial = 0; trial < 400; ++trial)
  {
    SCOPED_TRACE(trial);
    // Bent sheets, some with a triangle missing, about as large as what they stand before.
    Mesh mesh;
    const float size = Uniform(random, 0.3f, 2);
    const float bend = Uniform(random, 0, 1);
    mesh.AddSheet(1 + random() % 6,
      [&](float u, float v) {
        return glm::vec3(size * (2 * u - 1), size * (2 * v - 1), bend * std::sin(5 * u + 3 * v));
      });
    if (random() % 2 == 0)
    {
      const std::size_t hole = random() % (mesh.Corners.size() / 3);
      mesh.Corners.erase(mesh.Corners.begin() + 3 * hole, mesh.Corners.begin() + 3 * hole + 3);
    }
    const Box a =
      BoxAt(RandomPoint(random, -1, 0) + glm::vec3(0, 0, 1.5f), RandomPoint(random, 0, 0.7f));
    const Box b =
      BoxAt(RandomPoint(random, -1, 0) - glm::vec3(0, 0, 1.5f), RandomPoint(random, 0, 0.7f));
    if (mesh.MaySee(a, b))
    {
      continue;
    }
    ++denied;
    const auto view = mesh.View();
    for (int i = 0; i < 300; ++i)
    {
      glm::dvec3 from;
      glm::dvec3 to;
      for (int axis = 0; axis < 3; ++axis)
      {
        from[axis] = Uniform(random, a.Min[axis], a.Max[axis]);
        to[axis] = Uniform(random, b.Min[axis], b.Max[axis]);
      }
      bool isBlocked = false;
      for (std::uint32_t item = 0; item < view.Count() && !isBlocked; ++item)
      {
        isBlocked = RayMeets(Ray{ from, to - from, 1.0 }, view.TriangleAt(item)).has_value();
      }
      ASSERT_TRUE(isBlocked);
    }
  }
  EXPECT_GT(denied, 40);
}

}
