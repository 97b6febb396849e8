// Faces that an eye sees from their edge, found by their planes.
#include "NonFinite.h"
#include "OccluderScenes.h"

#include "Core/culling/FacePlanes.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using coverage::BoxBetween;
using coverage::Random;
using coverage::Triangles;
using vitrine::FacePlanes;

const double Thickness = 1e-6; // of an image of the size of 1 at a distance of 1

FacePlanes PlanesOf(const Triangles& triangles)
{
  return FacePlanes(triangles.Points, triangles.Corners);
}

bool IsSeenFrom(const FacePlanes& planes, const glm::dvec3& eye)
{
  return planes.IsAnyEdgeOn(glm::dvec4(eye, 1.0), Thickness);
}

bool IsSeenAlong(const FacePlanes& planes, const glm::dvec3& direction)
{
  return planes.IsAnyEdgeOn(glm::dvec4(glm::normalize(direction), 0.0), Thickness);
}

/** How thin the thinnest face of some looks, at a distance of 1. */
double ThinnestFrom(const Triangles& triangles, const glm::dvec3& eye)
{
  double least = 1e300;
  for (std::size_t i = 0; i < triangles.Corners.size(); i += 3)
  {
    const glm::dvec3 a = triangles.Points[triangles.Corners[i]];
    const glm::dvec3 b = triangles.Points[triangles.Corners[i + 1]];
    const glm::dvec3 c = triangles.Points[triangles.Corners[i + 2]];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
    const double far = glm::length(a - eye);
    const double sine = std::abs(glm::dot(glm::normalize(cross), a - eye)) / far;
    const double across = std::max(glm::length(cross) / longest, longest / 64.0);
    least = std::min(least, sine * across / far);
  }
  return least;
}

/** Nothing, of some extent: whatever else is added has the same middle then. */
Triangles EmptyFrame()
{
  Triangles frame;
  for (const double end : { -20.0, 20.0 })
  {
    const glm::dvec3 corner(end);
    frame.Add(corner, corner, corner);
  }
  return frame;
}

}

TEST(FacePlanes, OfABoxAreSeenFromTheirEdgeInSixPlanes)
{
  const FacePlanes box = PlanesOf(BoxBetween({ 1, 2, 3 }, { 2, 4, 6 }));
  EXPECT_FALSE(IsSeenFrom(box, { 10, 20, 30 }));
  EXPECT_FALSE(IsSeenFrom(box, { 2, 20, 30 })) << "exactly";
  EXPECT_TRUE(IsSeenFrom(box, { 2 + 1e-4, 20, 30 }));
  EXPECT_FALSE(IsSeenFrom(box, { 2.01, 20, 30 }));
  EXPECT_TRUE(IsSeenFrom(box, { -50, 2.0001, 30 }));
  EXPECT_TRUE(IsSeenFrom(box, { -50, 70, 5.9999 }));
  EXPECT_FALSE(IsSeenAlong(box, { 0, 0, -1 })) << "exactly";
  EXPECT_TRUE(IsSeenAlong(box, { 1, 2, 1.8e-6 }));
  EXPECT_FALSE(IsSeenAlong(box, { 1, 2, 0.1 }));
}

TEST(FacePlanes, AreFoundWhereverAFaceIsAsThin)
{
  Random random(3);
  int thin = 0;
  for (int i = 0; i < 20000; ++i)
  {
    Triangles face;
    const glm::dvec3 a = random.Point(-5, 5), b = random.Point(-5, 5), c = random.Point(-5, 5);
    face.Add(a, b, c);
    const glm::dvec3 beside = std::pow(10.0, random.Between(-8, 0)) * random.Point(-1, 1);
    const glm::dvec3 eye =
      a + random.Between(2, 9) * (b - a) + random.Between(2, 9) * (c - a) + beside;
    const double thinnest = ThinnestFrom(face, eye);
    const bool isThin = thinnest < Thickness && thinnest > 0.5 * Thickness;
    thin += isThin;
    if (isThin)
    {
      ASSERT_TRUE(IsSeenFrom(PlanesOf(face), eye)) << "face " << i;
    }
  }
  EXPECT_GT(thin, 100);
}

TEST(FacePlanes, AreSeldomSeenFromTheirEdge)
{
  Random random(5);
  int seen = 0;
  const FacePlanes box = PlanesOf(BoxBetween({ -1, -1, -1 }, { 1, 1, 1 }));
  for (int i = 0; i < 10000; ++i)
  {
    seen += IsSeenFrom(box, random.Point(-9, 9));
  }
  EXPECT_LT(seen, 10);
}

// A run of faces counts as one plane, and still none of them is seen from its edge unnoticed.
TEST(FacePlanes, OfFacesThatFollowEachOtherAreSeenAsEachAlone)
{
  Random random(11);
  int thin = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 a = random.Point(-5, 5), b = random.Point(-5, 5), c = random.Point(-5, 5);
    const auto moved = [&](const glm::dvec3& point)
    { return point + std::pow(10.0, random.Between(-7, -5)) * random.Point(-1, 1); };
    const glm::dvec3 eye =
      moved(a + random.Between(-9, 9) * (b - a) + random.Between(-9, 9) * (c - a));
    Triangles run = EmptyFrame();
    bool isThin = false;
    for (int face = 0; face < 3; ++face)
    {
      Triangles alone = EmptyFrame();
      const glm::dvec3 p = moved(a), q = moved(b), r = moved(c);
      alone.Add(p, q, r);
      run.Add(p, q, r);
      isThin = isThin || IsSeenFrom(PlanesOf(alone), eye);
    }
    thin += isThin;
    ASSERT_TRUE(!isThin || IsSeenFrom(PlanesOf(run), eye)) << "run " << i;
  }
  EXPECT_GT(thin, 1000);
}

TEST(FacePlanes, AreTheSameInWhicheverOrderFacesFollowEachOther)
{
  const double leans = 0.9e-6;
  Triangles even, leaning;
  even.Add({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 });
  leaning.Add({ 1, 0, 0 }, { 2, 0, leans }, { 1, 1, 0 });
  Triangles first = even, last = leaning;
  first.Add(leaning.Points[0], leaning.Points[1], leaning.Points[2]);
  last.Add(even.Points[0], even.Points[1], even.Points[2]);
  const glm::dvec3 eye(-10, 0.3, 0);
  EXPECT_TRUE(IsSeenFrom(PlanesOf(leaning), eye));
  EXPECT_TRUE(IsSeenFrom(PlanesOf(first), eye));
  EXPECT_TRUE(IsSeenFrom(PlanesOf(last), eye));
}

TEST(FacePlanes, AreManyInOneMesh)
{
  Triangles many = BoxBetween({ 1, 1, 1 }, { 2, 2, 2 });
  for (int i = 0; i < 19; ++i) // in planes of their own, the last one of them level
  {
    many.Add({ 0, 0, 0.1 * i }, { 1, 0, 0.3 }, { 0.3, 1, i == 18 ? 1.8 : 0.1 });
  }
  many.Add({ 0, 0, -7 }, { 1, 0, -7 }, { 0, 1, -7 });
  const FacePlanes planes = PlanesOf(many);
  EXPECT_TRUE(IsSeenFrom(planes, { 33.3, 21.1, -7.0002 }));
  EXPECT_FALSE(IsSeenFrom(planes, { 33.3, 21.1, -9 }));
}

TEST(FacePlanes, OfNothingAndOfFacesWithoutExtentAreNone)
{
  EXPECT_FALSE(IsSeenFrom(FacePlanes({}, {}), { 0, 0, 0 }));
  Triangles none;
  none.Add({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 });
  none.Add({ 1, 1, NotANumber }, { 1, 0, 1 }, { 2, 2, 2 });
  EXPECT_FALSE(IsSeenFrom(PlanesOf(none), { 1, 1, 1 }));
}

TEST(FacePlanes, ShowToAnEyeThatIsNowhere)
{
  const FacePlanes box = PlanesOf(BoxBetween({ 1, 2, 3 }, { 2, 4, 6 }));
  EXPECT_TRUE(IsSeenFrom(box, { NotANumber, 0, 0 }));
}
