// Distances, solids and clashes: closed forms first, then brute force with seeds, then hostile input.
#include "BruteClash.h"
#include "MeasuredShapes.h"

#include "Core/measure/AssemblyIndex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace measure_tests
{

using namespace measured_shapes;
using vitrine::AssemblyIndex;
using vitrine::Clash;
using vitrine::ClashKinds;
using vitrine::ClashLimits;
using vitrine::Enclosures;
using vitrine::Gap;
using vitrine::GapWithin;
using vitrine::PlacedPart;
using vitrine::Ray;
using vitrine::Triangle;

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::optional<Clash> CompareTwo(const Mesh& first, const glm::dmat4& firstPlace, const Mesh& second,
  const glm::dmat4& secondPlace, double tolerance, double clearance = 0)
{
  AssemblyIndex index;
  index.Add(first, firstPlace);
  index.Add(second, secondPlace);
  index.Build();
  const std::vector<Clash> all =
    index.Clashes({ clearance, tolerance }, [](double) { return true; });
  EXPECT_LE(all.size(), 1u);
  return all.empty() ? std::nullopt : std::optional<Clash>(all[0]);
}

const Mesh Cube = BoxMesh(glm::dvec3(0), glm::dvec3(1));
const glm::dmat4 Here(1.0);

// Rounding decides on which side of a triangle without an area a point is.
TEST(TriangleGap, NearestPointsOfSliversAreThoseOfTheirSides)
{
  std::mt19937 random(53);
  std::uniform_real_distribution<double> place(-40, 40);
  const glm::dvec3 ends[]{ { -39, 0, 9 }, { -12.8800001, 0, 9 }, { 39, 0, 9 } };
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 point(place(random), place(random) / 2, 9 + place(random) / 4);
    for (const Triangle& sliver :
      { Triangle{ ends[0], ends[1], ends[2] }, Triangle{ ends[1], ends[2], ends[0] } })
    {
      const double distance = glm::length(point - vitrine::NearestOnTriangle(sliver, point));
      const double toLine = vitrine::GapOfSegments(point, point, ends[0], ends[2]).Distance;
      EXPECT_NEAR(distance, toLine, 1e-9) << i;
    }
  }
}

TEST(TriangleGap, OfKnownPairs)
{
  const Triangle flat{ glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 0) };
  const auto gapTo = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const double there = GapWithin(flat, { a, b, c }, Infinity, 0)->Distance;
    EXPECT_DOUBLE_EQ(there, GapWithin({ a, b, c }, flat, Infinity, 0)->Distance);
    return there;
  };
  EXPECT_EQ(gapTo({ 1, 1, 2 }, { 2, 1, 2 }, { 1, 2, 2 }), 2);            // parallel
  EXPECT_EQ(gapTo({ 1, 1, -1 }, { 1, 1, 1 }, { 5, 5, 0 }), 0);           // pierced
  EXPECT_EQ(gapTo({ 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 }), 0);            // inside, in the plane
  EXPECT_EQ(gapTo({ 4, 0, 0 }, { 5, 0, 0 }, { 5, 0, 1 }), 0);            // a corner
  EXPECT_EQ(gapTo({ -3, -4, 0 }, { -3, -9, 0 }, { -9, -4, 0 }), 5);      // corner to corner
  EXPECT_EQ(gapTo({ 1, 1, 3 }, { 1, 1, 3 }, { 1, 1, 3 }), 3);            // a point
  EXPECT_EQ(gapTo({ -2, 1, 0 }, { -1, 1, 0 }, { -3, 1, 0 }), 1);         // a segment, in the plane
  EXPECT_DOUBLE_EQ(gapTo({ 2, 2, 1 }, { 3, 3, 1 }, { 2.5, 2.5, 9 }), 1); // edge to edge
}

TEST(TriangleGap, IsTheLeastDistanceOfPoints)
{
  std::mt19937 random(11);
  for (int i = 0; i < 300; ++i)
  {
    Triangle a, b;
    for (int k = 0; k < 3; ++k)
    {
      a[k] = Point(random, -1, 1);
      b[k] = Point(random, -1, 1) + glm::dvec3(i % 3, 0, 0);
    }
    const Gap gap = *GapWithin(a, b, Infinity, 0);
    double sampled = Infinity;
    const int steps = 24;
    for (int u = 0; u <= steps; ++u)
    {
      for (int v = 0; u + v <= steps; ++v)
      {
        const glm::dvec3 onA =
          a[0] + (a[1] - a[0]) * (double(u) / steps) + (a[2] - a[0]) * (double(v) / steps);
        const glm::dvec3 onB = vitrine::NearestOnTriangle(b, onA);
        sampled = std::min(sampled, glm::length(onA - onB));
      }
    }
    EXPECT_LE(gap.Distance, sampled + 1e-12) << i;
    EXPECT_GE(gap.Distance, sampled - 4.0 / steps) << i;
    EXPECT_NEAR(glm::length(gap.OnFirst - gap.OnSecond), gap.Distance, 1e-12) << i;
    EXPECT_LE(glm::length(gap.OnFirst - vitrine::NearestOnTriangle(a, gap.OnFirst)), 1e-9) << i;
    EXPECT_LE(glm::length(gap.OnSecond - vitrine::NearestOnTriangle(b, gap.OnSecond)), 1e-9) << i;
    glm::dvec3 apart(0.0);
    EXPECT_FALSE(gap.Distance > 0 && GapWithin(a, b, gap.Distance * 0.999, 0, &apart)) << i;
    if (apart != glm::dvec3(0.0))
    {
      double between = Infinity;
      for (int k = 0; k < 9; ++k)
      {
        between = std::min(between, glm::dot(apart, b[k / 3] - a[k % 3]));
      }
      EXPECT_NEAR(glm::length(apart), 1, 1e-12) << i;
      EXPECT_GT(between, gap.Distance * 0.999 - 1e-12) << i;
    }
    EXPECT_TRUE(GapWithin(a, b, gap.Distance * 1.001, 0)) << i;
  }
}

TEST(PartMesh, IsClosedIfEachEdgeHasAnEvenNumberOfTriangles)
{
  EXPECT_TRUE(Cube->IsClosed());
  EXPECT_TRUE(Ball(1, 12)->IsClosed());
  EXPECT_TRUE(Torus(2, 1, 9)->IsClosed());
  EXPECT_FALSE(Sheet(1, 1, 3)->IsClosed());
  EXPECT_FALSE(vitrine::PartMesh({}, {}).IsClosed());
  Points points;
  Corners corners;
  for (std::uint32_t i = 0; i < Cube->TriangleCount(); ++i) // each triangle with points of its own
  {
    for (const glm::dvec3& corner : Cube->TriangleAt(i))
    {
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(corner);
    }
  }
  const vitrine::PartMesh soup(points, corners);
  EXPECT_TRUE(soup.IsClosed());
  EXPECT_EQ(soup.Points().size(), 8u);
  corners.resize(corners.size() - 3);
  EXPECT_FALSE(vitrine::PartMesh(points, corners).IsClosed());
}

TEST(PartMesh, ContainsThePointsOfItsSolid)
{
  std::mt19937 random(12);
  const Mesh ball = Ball(1, 40);
  const Mesh torus = Torus(2, 0.5, 40);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 point = Point(random, -1.2, 1.2);
    const double radius = glm::length(point);
    if (radius < 0.99 || radius > 1.0)
    {
      EXPECT_EQ(ball->Contains(point), radius < 1) << i;
    }
    const glm::dvec3 wide = 2.5 * point;
    const double tube = glm::length(glm::dvec2(glm::length(glm::dvec2(wide)) - 2, wide.z));
    if (tube < 0.48 || tube > 0.5)
    {
      EXPECT_EQ(torus->Contains(wide), tube < 0.5) << i;
    }
  }
}

// Rays along axes through corners and along edges of a regular mesh are the hardest to count.
TEST(PartMesh, RaysCrossAClosedSurfaceInPairs)
{
  const Mesh ball = Ball(1, 16);
  const PlacedPart part(ball, Here);
  AssemblyIndex index;
  index.Add(ball, Here);
  index.Build();
  std::mt19937 random(13);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 target = i % 2 == 0 ? Point(random, -0.7, 0.7)
                                         : (ball->Points()[random() % ball->Points().size()] +
                                             ball->Points()[random() % ball->Points().size()]) /
        2.0;
    glm::dvec3 along(0.0);
    along[i % 3] = i % 5 == 0 ? -1 : 1;
    const auto crossings = index.Crossings({ target - 3.0 * along, along });
    EXPECT_EQ(crossings.size() % 2, 0u) << i;
    for (std::size_t k = 0; k < crossings.size(); ++k)
    {
      EXPECT_EQ(crossings[k].IsEntering, k % 2 == 0) << i;
    }
  }
}

TEST(PartMesh, RayGoesInByTheFrontOfAnOpenPart)
{
  for (const bool isMirrored : { false, true })
  {
    AssemblyIndex index;
    index.Add(Sheet(1, 1), glm::scale(Here, glm::dvec3(isMirrored ? -1 : 1, 1, 1)));
    index.Build();
    const auto down = index.Crossings({ { 0.1, 0.2, 5 }, { 0, 0, -1 } });
    const auto up = index.Crossings({ { 0.1, 0.2, -5 }, { 0, 0, 1 } });
    ASSERT_EQ(down.size(), 1u);
    ASSERT_EQ(up.size(), 1u);
    EXPECT_DOUBLE_EQ(down[0].Distance, 5);
    EXPECT_EQ(down[0].IsEntering, !isMirrored);
    EXPECT_EQ(up[0].IsEntering, isMirrored);
  }
}

TEST(AssemblyIndex, WallsAndWhereARayBeginsInOne)
{
  AssemblyIndex index;
  index.Add(Cube, Here);
  index.Add(Cube, At({ 3, 0, 0 }));
  index.Add(Sheet(9, 9), At({ 2, 0, 0.5 }));
  index.Build();
  const auto walls = index.Walls({ { -1, 0.3, 0.4 }, { 1, 0, 0 } });
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].Part, 0u);
  EXPECT_DOUBLE_EQ(walls[0].Start, 1);
  EXPECT_DOUBLE_EQ(walls[0].End, 2);
  EXPECT_EQ(walls[1].Part, 1u);
  EXPECT_DOUBLE_EQ(walls[1].Start, 4);
  EXPECT_DOUBLE_EQ(walls[1].End, 5);
  const auto inside = index.Walls({ { 0.25, 0.3, 0.4 }, { 1, 0, 0 }, 3.0 });
  ASSERT_EQ(inside.size(), 2u);
  EXPECT_EQ(inside[0].Start, 0);
  EXPECT_DOUBLE_EQ(inside[0].End, 0.75);
  EXPECT_EQ(inside[1].End, 3.0);
}

TEST(Clashes, OfBoxesThatOverlapTouchAndAreNear)
{
  const double tolerance = 0.01;
  const auto moved = [&](double by) {
    return CompareTwo(Cube, Here, Cube, At({ by, 0.1, 0.2 }), tolerance, 0.5);
  };
  const auto deep = moved(0.7);
  ASSERT_TRUE(deep);
  EXPECT_EQ(deep->Kind, ClashKinds::Interfering);
  EXPECT_NEAR(deep->Depth, 0.3, 1e-12);
  EXPECT_EQ(deep->Distance, 0);
  EXPECT_EQ(moved(0.98)->Kind, ClashKinds::Interfering);
  EXPECT_NEAR(moved(0.98)->Depth, 0.02, 1e-12);
  for (const double by : { 0.995, 1.0, 1.005 })
  {
    EXPECT_EQ(moved(by)->Kind, ClashKinds::Touching) << by;
    EXPECT_EQ(moved(by)->Depth, 0) << by;
    EXPECT_NEAR(moved(by)->Distance, std::max(by - 1, 0.0), 1e-12) << by;
  }
  EXPECT_EQ(moved(1.4)->Kind, ClashKinds::Near);
  EXPECT_NEAR(moved(1.4)->Distance, 0.4, 1e-12);
  EXPECT_NEAR(moved(1.4)->Place.x, 1.2, 1e-12);
  EXPECT_FALSE(moved(1.6));
}

// No corner of one is in the other, or on no surface of it.
TEST(Clashes, WithoutACornerInside)
{
  const Mesh bar = BoxMesh({ -5, -0.5, -0.5 }, { 5, 0.5, 0.5 });
  const glm::dmat4 turned = glm::rotate(Here, Pi / 2, glm::dvec3(0, 0, 1));
  const auto cross = CompareTwo(bar, Here, bar, turned, 0.01);
  EXPECT_EQ(cross->Kind, ClashKinds::Interfering);
  EXPECT_GE(cross->Depth, 0.25);
  const auto equal = CompareTwo(Cube, Here, Cube, Here, 0.01);
  EXPECT_EQ(equal->Kind, ClashKinds::Interfering);
  EXPECT_GE(equal->Depth, 0.2);
  const auto inLine = CompareTwo(Cube, Here, Cube, At({ 0.5, 0, 0 }), 0.01);
  EXPECT_EQ(inLine->Kind, ClashKinds::Interfering);
  const Mesh plate = BoxMesh({ -9, -9, -0.01 }, { 9, 9, 0.01 });
  const auto cut = CompareTwo(Ball(1, 20), Here, plate, Here, 0.1);
  EXPECT_EQ(cut->Kind, ClashKinds::Interfering);
  EXPECT_GE(cut->Depth, 0.5);
}

TEST(Clashes, OfAPartWhollyInTheSolidOfAnother)
{
  const auto inner = CompareTwo(Ball(3, 20), Here, Cube, At({ 0.5, 0.5, 0.5 }), 0.01);
  EXPECT_EQ(inner->Kind, ClashKinds::Interfering);
  EXPECT_EQ(inner->Enclosure, Enclosures::SecondInFirst);
  EXPECT_GT(inner->Distance, 0.3);
  EXPECT_GT(inner->Depth, inner->Distance);
  const Mesh hollow = Torus(2, 0.5, 30); // a cube in its hole is outside
  EXPECT_FALSE(CompareTwo(hollow, Here, Cube, At(glm::dvec3(-0.5)), 0.01));
  const auto sheet = CompareTwo(Sheet(0.2, 0.2), At({ 0, 0, 1 }), Ball(3, 20), Here, 0.01);
  EXPECT_EQ(sheet->Enclosure, Enclosures::FirstInSecond);
}

TEST(Clashes, OfOpenParts)
{
  const glm::dmat4 upright = glm::rotate(Here, Pi / 2, glm::dvec3(1, 0, 0));
  const auto through = CompareTwo(Sheet(2, 2), Here, Sheet(1, 1), upright, 0.01);
  EXPECT_EQ(through->Kind, ClashKinds::Interfering);
  EXPECT_NEAR(through->Depth, 0.5, 1e-12);
  EXPECT_EQ(CompareTwo(Sheet(2, 2), Here, Sheet(1, 1), At({ 0, 0, 0.5 }) * upright, 0.01)->Kind,
    ClashKinds::Touching); // stands on it
  EXPECT_EQ(CompareTwo(Sheet(2, 2), Here, Sheet(1, 1), Here, 0.01)->Kind, ClashKinds::Touching);
  const auto inBall = CompareTwo(Sheet(9, 9), Here, Ball(1, 20), Here, 0.01);
  EXPECT_EQ(inBall->Kind, ClashKinds::Interfering);
  EXPECT_GE(inBall->Depth, 0.5);
}

// A shaft in a hole of the same radius: facets of both cut into each other, but for less than they are off the circle.
TEST(Clashes, OfMeshedCirclesAreWithinTheirTolerance)
{
  const auto tube = [](std::uint32_t count, double from)
  {
    return Grid(count, 2, true, false,
      [=](double u, double v)
      {
        const double angle = 2 * Pi * u + from;
        return glm::dvec3(std::cos(angle), std::sin(angle), 4 * v - 2);
      });
  };
  const Mesh ring = Torus(1.5, 0.5, 24);
  const double facets = 1 - std::cos(Pi / 24);
  const auto fit = CompareTwo(tube(24, 0.13), Here, ring, Here, 2 * facets);
  EXPECT_EQ(fit->Kind, ClashKinds::Touching);
  EXPECT_EQ(CompareTwo(tube(24, 0.13), At({ 0.2, 0, 0 }), ring, Here, 2 * facets)->Kind,
    ClashKinds::Interfering);
}

// The same as brute force, of shapes that overlap, enclose, touch and miss each other.
TEST(Clashes, AreThoseOfBruteForce)
{
  const Mesh shapes[] = { Cube, Ball(1, 9), Torus(1, 0.4, 9), Sheet(2, 1, 3), Ball(0.2, 5),
    BoxMesh({ -3, -0.05, -0.05 }, { 3, 0.05, 0.05 }) };
  std::set<std::pair<int, int>> kinds;
  for (std::uint32_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    AssemblyIndex index;
    index.Add(Ball(2, 9), At({ 0, 0, 3 }));
    for (int i = 0; i < 24; ++i)
    {
      const bool isOnLattice = i % 3 == 0; // so that faces coincide
      const glm::dvec3 step = glm::floor(Point(random, -2, 2));
      glm::dmat4 place = RandomPlace(random, 2, 0.5, 1.5);
      if (i % 7 == 1)
      {
        place = glm::scale(place, glm::dvec3(-1, 0.5, 2)); // not even, so of a mesh of its own
      }
      index.Add(isOnLattice ? Cube : shapes[random() % 6], isOnLattice ? At(step) : place);
    }
    index.Build();
    const ClashLimits limits{ 0.2, 0.02 };
    const std::vector<Clash> found = index.Clashes(limits, [](double) { return true; });
    auto next = found.begin();
    for (std::uint32_t a = 0; a < index.Count(); ++a)
    {
      for (std::uint32_t b = a + 1; b < index.Count(); ++b)
      {
        const auto truth = brute_clash::Compare(index.At(a), index.At(b), limits);
        const bool isFound = next != found.end() && next->First == a && next->Second == b;
        ASSERT_EQ(isFound, truth.has_value()) << a << " " << b;
        if (isFound)
        {
          EXPECT_EQ(next->Kind, truth->Kind) << a << " " << b;
          EXPECT_NEAR(next->Depth, truth->Depth, 1e-9) << a << " " << b;
          EXPECT_NEAR(next->Distance, truth->Distance, 1e-9) << a << " " << b;
          kinds.emplace(static_cast<int>(next->Kind), static_cast<int>(next->Enclosure));
          ++next;
        }
      }
    }
    EXPECT_EQ(next, found.end());
  }
  EXPECT_GE(kinds.size(), 4u); // the scenes have all kinds, and enclosed parts
}

TEST(AssemblyIndex, QueriesAreThoseOfBruteForce)
{
  std::mt19937 random(21);
  AssemblyIndex index;
  const Mesh shapes[] = { Cube, Ball(1, 8), Sheet(2, 1, 3) };
  for (int i = 0; i < 60; ++i)
  {
    index.Add(shapes[i % 3], RandomPlace(random, 6, 0.2, 1.5));
  }
  index.Build();
  std::vector<brute_clash::Surface> surfaces;
  for (std::uint32_t part = 0; part < index.Count(); ++part)
  {
    surfaces.emplace_back(index.At(part));
  }
  for (int i = 0; i < 40; ++i)
  {
    SCOPED_TRACE(i);
    const glm::dvec3 point = Point(random, -8, 8);
    const double radius = Number(random, 0, 5);
    const vitrine::WideBox box{ point, point + Point(random, 0, 5) };
    double least = Infinity;
    std::vector<std::uint32_t> touching, within, withinBox;
    std::size_t crossings = 0;
    const Ray ray{ point, glm::normalize(Point(random, -1, 1)) };
    for (std::uint32_t part = 0; part < index.Count(); ++part)
    {
      const double distance = surfaces[part].DistanceTo(point);
      least = std::min(least, distance);
      bool isWithin = true;
      bool isInBox = true;
      for (const Triangle& triangle : surfaces[part].Triangles)
      {
        for (const glm::dvec3& corner : triangle)
        {
          isWithin = isWithin && glm::length(corner - point) <= radius;
          isInBox = isInBox && box.Contains(corner);
        }
        crossings += vitrine::RayMeets(ray, triangle).has_value();
      }
      distance <= radius ? touching.push_back(part) : void();
      isWithin ? within.push_back(part) : void();
      isInBox ? withinBox.push_back(part) : void();
    }
    EXPECT_NEAR(index.Nearest(point)->Point.Distance, least, 1e-12);
    EXPECT_EQ(index.PartsTouching(point, radius), touching);
    EXPECT_EQ(index.PartsWithin(point, radius), within);
    EXPECT_EQ(index.PartsWithin(box), withinBox);
    EXPECT_EQ(index.Crossings(ray).size(), crossings);
    const Mesh boxMesh = BoxMesh(box.Low, box.High);
    const PlacedPart boxPart(boxMesh, Here);
    std::vector<std::uint32_t> touchingBox;
    for (std::uint32_t part = 0; part < index.Count(); ++part)
    {
      const bool isEnclosed = box.Contains(surfaces[part].Triangles[0][0]);
      const auto gap = vitrine::FindSurfaceGap(index.At(part), boxPart, 0);
      isEnclosed || gap ? touchingBox.push_back(part) : void();
    }
    EXPECT_EQ(index.PartsTouching(box), touchingBox);
  }
}

TEST(AssemblyIndex, DistanceOfBalls)
{
  AssemblyIndex index;
  index.Add(Ball(1, 64), Here);
  index.Add(Ball(2, 64), At({ 0, 0, 7 })); // poles are nearest
  index.Add(std::make_shared<vitrine::PartMesh>(Points(), Corners()), Here);
  index.Build();
  const auto gap = index.Distance(0, 1);
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->Distance, 4, 1e-12);
  EXPECT_NEAR(gap->OnFirst.z, 1, 1e-12);
  EXPECT_NEAR(gap->OnSecond.z, 5, 1e-12);
  EXPECT_FALSE(index.Distance(0, 2));
}

TEST(AssemblyIndex, WallHidesPartsFromEachOther)
{
  AssemblyIndex index;
  index.Add(Cube, Here);
  index.Add(Cube, At({ 5, 0, 0 }));
  const auto wall = index.Add(BoxMesh({ 2, -90, -90 }, { 3, 90, 90 }), Here);
  index.Build();
  EXPECT_FALSE(index.MaySee(0, 1, [](std::uint32_t) { return true; }));
  EXPECT_TRUE(index.MaySee(0, 1, [&](std::uint32_t part) { return part != wall; }));
}

TEST(AssemblyIndex, StopsWhenAsked)
{
  AssemblyIndex index;
  index.Add(Cube, Here);
  index.Add(Cube, Here);
  index.Build();
  EXPECT_TRUE(index.Clashes({ 0, 0.01 }, [](double) { return false; }).empty());
}

TEST(AssemblyIndex, TakesHostileInput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto strange = std::make_shared<vitrine::PartMesh>(
    Points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { nan, 0, 0 }, { Infinity, 1, 1 }, { 2, 0, 0 } },
    Corners{ 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 0, 1, 0, 1, 5, 0, 1, 99, 7 });
  EXPECT_EQ(strange->TriangleCount(), 2u); // one of them is a segment
  EXPECT_EQ(strange->SourceOf(1), 4u);
  EXPECT_FALSE(strange->IsClosed());
  AssemblyIndex index;
  index.Add(strange, Here);
  index.Add(std::make_shared<vitrine::PartMesh>(Points(), Corners()), Here);
  index.Add(Cube, glm::dmat4(nan));
  index.Add(Cube, glm::dmat4(0.0));
  index.Add(Cube, glm::scale(Here, glm::dvec3(1, 1, 0)));
  index.Add(Cube, glm::scale(Here, glm::dvec3(1e30)));
  index.Add(Cube, glm::scale(Here, glm::dvec3(1e-30)));
  index.Add(Cube, glm::scale(Here, glm::dvec3(1e300)));
  index.Build();
  for (const ClashLimits limits : { ClashLimits{ 0, 0 }, ClashLimits{ 1e300, 1e-300 } })
  {
    for (const Clash& clash : index.Clashes(limits, [](double) { return true; }))
    {
      EXPECT_FALSE(std::isnan(clash.Depth));
      EXPECT_GE(clash.Distance, 0);
    }
  }
  index.Nearest({ 1e300, 0, 0 });
  index.Crossings({ { 0, 0, -1 }, { 0, 0, 1 } });
  index.PartsTouching({ { -1, -1, -1 }, { 1, 1, 1 } });
  EXPECT_FALSE(index.Nearest({ nan, 0, 0 }));
  EXPECT_TRUE(index.Crossings({ { nan, 0, 0 }, { 1, 0, 0 } }).empty());
}

// The answer does not depend on where the model stands, or in which unit it is.
TEST(Clashes, AreTheSameFarAwayAndInOtherUnits)
{
  for (const double unit : { 1e-6, 1.0, 1e6 })
  {
    for (const double far : { 0.0, 1e4 })
    {
      const glm::dmat4 moved = glm::scale(Here, glm::dvec3(unit)) * At(glm::dvec3(far));
      const auto deep = CompareTwo(Cube, moved, Cube, moved * At({ 0.7, 0.1, 0.2 }), 0.01 * unit);
      ASSERT_TRUE(deep) << unit << " " << far;
      EXPECT_EQ(deep->Kind, ClashKinds::Interfering) << unit << " " << far;
      EXPECT_NEAR(deep->Depth / unit, 0.3, 1e-9) << unit << " " << far;
      EXPECT_EQ(CompareTwo(Cube, moved, Cube, moved * At({ 1, 0.1, 0.2 }), 0.01 * unit)->Kind,
        ClashKinds::Touching);
    }
  }
}

}
