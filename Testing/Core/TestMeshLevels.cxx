// Levels of detail: closed forms first, then samples beside the bounds, seams, and hostile input.
#include "MeasuredShapes.h"

#include "Core/levels/MeshLevels.h"
#include "Core/levels/MeshReduction.h"
#include "Core/levels/MeshSpeck.h"
#include "Core/levels/PixelLength.h"
#include "Core/levels/SurfaceBound.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace mesh_levels_tests
{

using measured_shapes::Ball;
using measured_shapes::Corners;
using measured_shapes::Grid;
using measured_shapes::Points;
using measured_shapes::Torus;
using vitrine::AreaOf;
using vitrine::BoundOfDistance;
using vitrine::DetailedMesh;
using vitrine::LengthOfPixels;
using vitrine::LevelsOf;
using vitrine::MeshLevel;
using vitrine::MeshLevels;
using vitrine::MeshReduction;
using vitrine::MeshSpeck;
using vitrine::NeverStopped;
using vitrine::PartMesh;
using vitrine::PixelView;
using vitrine::SpeckOf;
using vitrine::Surface;
using vitrine::TrianglesOf;

DetailedMesh MeshOf(const measured_shapes::Mesh& mesh)
{
  return { mesh->Content().Points, mesh->Content().Corners, {}, {} };
}

/** A square of side 1 in z = 0, of count x count quads. */
DetailedMesh Square(std::uint32_t count)
{
  return MeshOf(
    Grid(count, count, false, false, [](double u, double v) { return glm::dvec3(u, v, 0); }));
}

/** Adds a mesh with a normal. */
void Append(DetailedMesh& all, const DetailedMesh& mesh, const glm::vec3& normal)
{
  const auto first = static_cast<std::uint32_t>(all.Points.size());
  all.Points.insert(all.Points.end(), mesh.Points.begin(), mesh.Points.end());
  all.Normals.resize(all.Points.size(), normal);
  for (const std::uint32_t corner : mesh.Corners)
  {
    all.Corners.push_back(first + corner);
  }
}

/** A cube with six flat faces of count x count quads each, which have normals and points of their own. */
DetailedMesh HardCube(std::uint32_t count)
{
  DetailedMesh cube;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.0, 1.0 })
    {
      DetailedMesh face = Square(count);
      for (glm::dvec3& point : face.Points)
      {
        glm::dvec3 turned;
        turned[axis] = side;
        turned[(axis + 1) % 3] = side > 0 ? point.x : point.y;
        turned[(axis + 2) % 3] = side > 0 ? point.y : point.x;
        point = turned;
      }
      glm::vec3 normal(0.0f);
      normal[axis] = side > 0 ? 1.0f : -1.0f;
      Append(cube, face, normal);
    }
  }
  return cube;
}

std::array<glm::dvec3, 3> TriangleOf(
  const DetailedMesh& mesh, const Corners& corners, std::size_t i)
{
  return { mesh.Points[corners[i]], mesh.Points[corners[i + 1]], mesh.Points[corners[i + 2]] };
}

glm::dvec3 AreaOf(const std::array<glm::dvec3, 3>& triangle)
{
  return glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) / 2.0;
}

/** Returns the greatest distance of random points of some triangles from others of the same mesh. */
double SampledDistance(const DetailedMesh& mesh, const Corners& from, const Corners& to, int count)
{
  std::mt19937 random(53);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> areas;
  for (std::size_t i = 0; i < from.size(); i += 3)
  {
    areas.push_back(glm::length(AreaOf(TriangleOf(mesh, from, i))));
  }
  std::discrete_distribution<std::size_t> triangles(areas.begin(), areas.end());
  const PartMesh other(mesh.Points, to);
  double most = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto [a, b, c] = TriangleOf(mesh, from, 3 * triangles(random));
    double s = unit(random);
    double t = unit(random);
    if (s + t > 1)
    {
      s = 1 - s;
      t = 1 - t;
    }
    most = std::max(most, other.Nearest(a + s * (b - a) + t * (c - a))->Distance);
  }
  return most;
}

/** Expects that no sample is beyond a bound, and that bounds are no more than so many times what samples find. */
void ExpectHonest(const DetailedMesh& mesh, const MeshLevels& made, double slack)
{
  ASSERT_FALSE(made.Levels.empty());
  for (const MeshLevel& level : made.Levels)
  {
    const double there = SampledDistance(mesh, mesh.Corners, level.Corners, 10000);
    const double back = SampledDistance(mesh, level.Corners, mesh.Corners, 10000);
    SCOPED_TRACE(level.Corners.size() / 3);
    EXPECT_LE(there, level.Bound);
    EXPECT_LE(back, level.Bound);
    EXPECT_LE(level.Bound, slack * std::max(there, back) + 1e-7);
  }
}

TEST(MeshLevels, OfAPlaneHaveNoDistance)
{
  const DetailedMesh square = Square(32);
  const MeshLevels made = LevelsOf(square);
  ASSERT_FALSE(made.Levels.empty());
  EXPECT_EQ(made.Unfit, 0u);
  EXPECT_EQ(made.Levels.back().Corners.size(), 3u);
  EXPECT_LE(made.Levels[made.Levels.size() - 2].Corners.size(), 3 * 8u);
  for (const MeshLevel& level : made.Levels)
  {
    if (level.Corners.size() == 3)
    {
      continue;
    }
    glm::dvec3 area(0.0);
    for (std::size_t i = 0; i < level.Corners.size(); i += 3)
    {
      area += AreaOf(TriangleOf(square, level.Corners, i));
    }
    EXPECT_NEAR(area.z, 1, 1e-9);
    EXPECT_LE(level.Bound, 1e-4); // what is not worth cutting, from level to level
  }
}

TEST(MeshLevels, OfAHardCubeEndWithTwelveTriangles)
{
  const DetailedMesh cube = HardCube(16);
  MeshReduction reduction(vitrine::Welded(cube));
  reduction.ReduceTo(0, NeverStopped);
  const Corners left = reduction.Triangles();
  ASSERT_EQ(left.size(), 3 * 12u);
  for (std::size_t i = 0; i < left.size(); i += 3)
  {
    const glm::dvec3 area = AreaOf(TriangleOf(cube, left, i));
    for (int k = 0; k < 3; ++k)
    {
      // Each corner still has the normal of its face.
      EXPECT_NEAR(glm::dot(glm::dvec3(cube.Normals[left[i + k]]), area), 0.5, 1e-12);
    }
  }
  const Surface whole(cube.Points, cube.Corners);
  const Surface reduced(cube.Points, left);
  EXPECT_LE(BoundOfDistance(cube.Points, whole, reduced, 1e-9, NeverStopped), 1e-9);
  EXPECT_LE(BoundOfDistance(cube.Points, reduced, whole, 1e-9, NeverStopped), 1e-9);
}

TEST(MeshLevels, KeepTheBorderOfColours)
{
  DetailedMesh square =
    Square(32); // the left half has points of another colour than the right half
  const DetailedMesh whole = square;
  square = {};
  for (std::size_t i = 0; i < whole.Corners.size(); i += 3)
  {
    const auto triangle = TriangleOf(whole, whole.Corners, i);
    const bool isRight = (triangle[0].x + triangle[1].x + triangle[2].x) / 3 > 0.5;
    for (const glm::dvec3& corner : triangle)
    {
      square.Corners.push_back(static_cast<std::uint32_t>(square.Points.size()));
      square.Points.push_back(corner);
      square.Colors.push_back(isRight ? 1 : 0);
    }
  }
  for (const MeshLevel& level : LevelsOf(square).Levels)
  {
    if (level.Corners.size() / 3 <= 8)
    {
      continue; // a level of so few has no colours to keep
    }
    std::array<double, 2> areas{ 0, 0 };
    for (std::size_t i = 0; i < level.Corners.size(); i += 3)
    {
      const std::uint32_t color = square.Colors[level.Corners[i]];
      EXPECT_EQ(color, square.Colors[level.Corners[i + 1]]);
      EXPECT_EQ(color, square.Colors[level.Corners[i + 2]]);
      areas[color] += AreaOf(TriangleOf(square, level.Corners, i)).z;
    }
    EXPECT_NEAR(areas[0], 0.5, 1e-9);
    EXPECT_NEAR(areas[1], 0.5, 1e-9);
  }
}

TEST(MeshLevels, OfABallAreWithinItsRadius)
{
  const double radius = 3;
  const DetailedMesh ball = MeshOf(Ball(radius, 48));
  const MeshLevels made = LevelsOf(ball);
  ExpectHonest(ball, made, 2.2);
  for (const MeshLevel& level : made.Levels)
  {
    // All corners are on the sphere, so a triangle is nowhere farther from it than the middle of the ball.
    EXPECT_LE(level.Bound, 2 * radius);
    double sagitta = 0;
    for (std::size_t i = 0; i < level.Corners.size(); i += 3)
    {
      const auto triangle = TriangleOf(ball, level.Corners, i);
      const glm::dvec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
      sagitta = std::max(sagitta, radius - glm::length(middle));
    }
    const double facets =
      radius * (1 - std::cos(std::acos(-1.0) / 48)) * 2; // the ball is no sphere
    EXPECT_GE(level.Bound, sagitta - facets);
  }
}

TEST(MeshLevels, AreWithinTheirBounds)
{
  ExpectHonest(MeshOf(Torus(3, 1, 40)), LevelsOf(MeshOf(Torus(3, 1, 40))), 2.5);
  const DetailedMesh waves = MeshOf(Grid(50, 50, false, false,
    [](double u, double v) { return glm::dvec3(u, v, 0.1 * std::sin(9 * u) * std::cos(7 * v)); }));
  ExpectHonest(waves, LevelsOf(waves), 2.5);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  DetailedMesh soup; // triangles without neighbours
  for (std::uint32_t i = 0; i < 300; ++i)
  {
    soup.Points.emplace_back(unit(random), unit(random), unit(random));
    soup.Corners.push_back(i);
  }
  ExpectHonest(soup, LevelsOf(soup), 2.2);
}

/** A disc of radius 1, of triangles around its middle. */
DetailedMesh Fan(std::uint32_t count)
{
  DetailedMesh fan;
  fan.Points.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const double angle = 2 * glm::pi<double>() * i / count;
    fan.Points.emplace_back(std::cos(angle), std::sin(angle), 0);
    fan.Corners.insert(fan.Corners.end(), { 0, 1 + i, 1 + (i + 1) % count });
  }
  return fan;
}

// The middle is a neighbour of all other vertices. Work at each of them that looks at its neighbours would not end.
TEST(MeshLevels, OfALargeFanAreMade)
{
  const DetailedMesh fan = Fan(4000);
  const MeshLevels made = LevelsOf(fan);
  ASSERT_GE(made.Levels.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const MeshLevel& level = made.Levels[i];
    const auto sides = static_cast<double>(level.Corners.size() / 3);
    const double sagitta = 1 - std::cos(glm::pi<double>() / sides); // if all are of one length
    EXPECT_GE(level.Bound + 1e-6, sagitta);
    EXPECT_LE(level.Bound, 20 * sagitta);
    EXPECT_LE(SampledDistance(fan, fan.Corners, level.Corners, 100), level.Bound);
  }
}

TEST(MeshLevels, HaveFewerTrianglesAndGreaterBoundsStepByStep)
{
  const DetailedMesh torus = MeshOf(Torus(3, 1, 64));
  const MeshLevels made = LevelsOf(torus);
  ASSERT_GE(made.Levels.size(), 5u);
  std::size_t triangles = torus.Corners.size();
  double bound = 0;
  for (const MeshLevel& level : made.Levels)
  {
    EXPECT_LE(4 * level.Corners.size(), 3 * triangles);
    EXPECT_GE(level.Bound, bound);
    triangles = level.Corners.size();
    bound = level.Bound;
  }
  EXPECT_EQ(vitrine::CoarsestWithin(made.Levels, 0), -1);
  EXPECT_EQ(vitrine::CoarsestWithin(made.Levels, made.Levels[2].Bound), 2);
  EXPECT_EQ(vitrine::CoarsestWithin(made.Levels, std::nan("")), -1);
  EXPECT_EQ(vitrine::CoarsestWithin(made.Levels, 1e9), static_cast<int>(made.Levels.size()) - 1);
}

TEST(MeshLevels, KeepTrianglesThatFitNoManifold)
{
  // Three walls that meet in one line.
  DetailedMesh walls;
  for (int wall = 0; wall < 3; ++wall)
  {
    DetailedMesh square = Square(16);
    for (glm::dvec3& point : square.Points)
    {
      const double angle = 2 * std::acos(-1.0) * wall / 3;
      point = { point.x == 0 ? 0 : point.x * std::cos(angle),
        point.x == 0 ? 0 : point.x * std::sin(angle), point.y };
    }
    Append(walls, square, { 0, 0, 1 });
  }
  walls.Normals.clear();
  const MeshLevels made = LevelsOf(walls);
  EXPECT_EQ(made.Unfit, 32u); // those of the third wall that are at the line
  ExpectHonest(walls, made, 2.2);
}

TEST(MeshLevels, OfTurnedTrianglesKeepTheirTurns)
{
  DetailedMesh square = Square(16);
  for (std::size_t i = 0; i < square.Corners.size(); i += 6)
  {
    std::swap(square.Corners[i], square.Corners[i + 1]);
  }
  ExpectHonest(square, LevelsOf(square), 2.2);
}

TEST(MeshLevels, AreNoneForMeshesThatAreNotUsable)
{
  const DetailedMesh good = Square(16);
  EXPECT_TRUE(LevelsOf(DetailedMesh()).Levels.empty());
  DetailedMesh bad = good;
  bad.Points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  bad.Corners[7] = 100000;
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  bad.Corners.pop_back();
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  bad.Normals.resize(3);
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  bad.Colors.resize(3);
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  std::fill(
    bad.Points.begin(), bad.Points.end(), glm::dvec3(1, 2, 3)); // all triangles are one point
  EXPECT_TRUE(LevelsOf(bad).Levels.empty());
  bad = good;
  for (glm::dvec3& point : bad.Points)
  {
    point.y = 0; // all lie on one line
  }
  for (const MeshLevel& level : LevelsOf(bad).Levels)
  {
    EXPECT_LE(level.Bound, 1e-7);
  }
}

TEST(MeshLevels, AreNotMadeOnceStopped)
{
  const std::atomic<bool> isStopped{ true };
  EXPECT_TRUE(LevelsOf(MeshOf(Torus(3, 1, 64)), isStopped).Levels.empty());
}

// A regular tetrahedron of a ball's area 4 pi r^2 has the edge 2 r sqrt(pi / sqrt(3)), and its corners are sqrt(3/8) of
// that from the middle. They are the points farthest from the ball, as the middles of faces are a third of that inside.
TEST(MeshSpeck, OfABallIsATetrahedronOfItsArea)
{
  DetailedMesh ball = MeshOf(Ball(2, 64));
  const double area = AreaOf(ball.Points, ball.Corners);
  for (glm::dvec3& point : ball.Points)
  {
    point += glm::dvec3(5, -3, 1);
  }
  const std::optional<MeshSpeck> speck = SpeckOf(ball, NeverStopped);
  ASSERT_TRUE(speck);
  const std::vector<glm::dvec3> corners(speck->Corners.begin(), speck->Corners.end());
  EXPECT_NEAR(AreaOf(corners, TrianglesOf(*speck)), area, 1e-9);
  const double far = std::sqrt(area / std::sqrt(3.0)) * std::sqrt(3.0 / 8.0);
  for (const glm::dvec3& corner : corners)
  {
    EXPECT_NEAR(glm::length(corner - glm::dvec3(5, -3, 1)), far, 0.01);
  }
  const double distance = std::max(far - 2, 2 - far / 3);
  EXPECT_GE(speck->Bound, distance - 0.01);
  EXPECT_LE(speck->Bound, 1.1 * distance + 0.1);
}

TEST(MeshSpeck, FacesOutwards)
{
  const std::optional<MeshSpeck> speck = SpeckOf(MeshOf(Torus(3, 1, 16)), NeverStopped);
  ASSERT_TRUE(speck);
  for (std::size_t i = 0; i < TrianglesOf(*speck).size(); i += 3)
  {
    const auto at = [&](std::size_t corner) { return speck->Corners[TrianglesOf(*speck)[corner]]; };
    const glm::dvec3 normal = glm::cross(at(i + 1) - at(i), at(i + 2) - at(i));
    EXPECT_GT(glm::dot(normal, at(i) - speck->Middle), 0);
  }
}

// A ring has the area 3/4 pi r^2 if half of its radius is a hole, and the square of that area is about its middle. Its
// corner is half of its diagonal away, and the middle of the ring's hole half of r.
TEST(MeshSpeck, OfASheetIsARectangleOfItsArea)
{
  DetailedMesh ring = MeshOf(Grid(64, 1, true, false,
    [](double u, double v)
    {
      const double angle = 2 * glm::pi<double>() * u;
      return (1 - 0.5 * v) *
        glm::dvec3(std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle)) +
        glm::dvec3(5, -3, 1);
    }));
  const std::optional<MeshSpeck> speck = SpeckOf(ring, NeverStopped);
  ASSERT_TRUE(speck);
  EXPECT_TRUE(speck->IsSheet);
  EXPECT_EQ(TrianglesOf(*speck).size(), 6u);
  const std::vector<glm::dvec3> corners(speck->Corners.begin(), speck->Corners.end());
  const double area = AreaOf(ring.Points, ring.Corners);
  EXPECT_NEAR(area, 0.75 * glm::pi<double>(), 0.01);
  EXPECT_NEAR(AreaOf(corners, TrianglesOf(*speck)), area, 1e-9);
  for (std::size_t i = 0; i < 6; i += 3)
  {
    const auto at = [&](std::size_t corner) { return corners[TrianglesOf(*speck)[corner]]; };
    const glm::dvec3 normal = glm::normalize(glm::cross(at(i + 1) - at(i), at(i + 2) - at(i)));
    const glm::dvec3 first = glm::normalize(AreaOf(TriangleOf(ring, ring.Corners, 0)));
    EXPECT_NEAR(glm::dot(normal, first), 1, 1e-6);
  }
  EXPECT_GE(speck->Bound, 0.5 - 0.01);
  EXPECT_LE(speck->Bound, 0.6);
}

TEST(MeshSpeck, OfAMeshWithoutAreaIsNone)
{
  DetailedMesh line = MeshOf(Torus(3, 1, 16));
  for (glm::dvec3& point : line.Points)
  {
    point.y = point.z = 0;
  }
  EXPECT_FALSE(SpeckOf(line, NeverStopped));
}

TEST(PixelLength, OfAParallelViewIsThatOfAPixel)
{
  PixelView view;
  view.IsParallel = true;
  view.Height = 50;
  view.ParallelHeight = 10;
  EXPECT_DOUBLE_EQ(LengthOfPixels(view, 0.5, glm::dvec3(1, 2, 3), 4), 0.1);
}

TEST(PixelLength, MovesNoPointInViewByMore)
{
  std::mt19937 random(53);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto anywhere = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  double most = 0;
  for (int i = 0; i < 200000; ++i)
  {
    PixelView view; // looks along -z from the origin
    view.HalfTangent = 0.1 + std::abs(unit(random));
    view.Width = 300;
    view.Height = 200;
    view.Nearest = 0.05;
    const double pixels = 3 * std::abs(unit(random));
    const glm::dvec3 centre = 5.0 * anywhere();
    const double radius = std::abs(unit(random));
    const double length = LengthOfPixels(view, pixels, centre, radius);
    const glm::dvec3 from = centre + radius * glm::normalize(anywhere());
    const glm::dvec3 to = from + length * glm::normalize(anywhere());
    const double focal = view.Height / (2 * view.HalfTangent);
    const glm::dvec2 before = focal * glm::dvec2(from) / -from.z;
    if (-from.z >= view.Nearest && std::abs(before.x) <= 150 && std::abs(before.y) <= 100)
    {
      const double moved = glm::length(focal * glm::dvec2(to) / -to.z - before);
      ASSERT_LE(moved, pixels * (1 + 1e-9)) << i;
      most = std::max(most, moved / pixels);
    }
  }
  EXPECT_GE(most, 0.8); // and no less than needed
}

TEST(SurfaceBound, OfKnownTriangles)
{
  const Points points{ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 2 }, { 4, 0, 2 }, { 0, 4, 3 },
    { 9, 0, 0 } };
  const Surface flat(points, { 0, 1, 2 });
  const auto bound = [&](const Corners& corners)
  { return BoundOfDistance(points, Surface(points, corners), flat, 0, NeverStopped); };
  EXPECT_DOUBLE_EQ(bound({ 3, 4, 5 }), 3);
  EXPECT_DOUBLE_EQ(bound({ 0, 1, 2 }), 0);
  EXPECT_DOUBLE_EQ(bound({ 6, 6, 6 }), 5); // a point
  EXPECT_DOUBLE_EQ(bound({ 0, 6, 6 }), 5); // a segment
}

TEST(SurfaceBound, OfAWayBetweenPiecesIsHalfOfTheGap)
{
  Points points;
  Corners pieces;
  for (const double x : { 0, 10, 20 })
  {
    for (const glm::dvec3& corner :
      { glm::dvec3(x, 0, 0), glm::dvec3(x, 1, 0), glm::dvec3(x, 0, 1) })
    {
      pieces.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(corner);
    }
  }
  const double bound =
    BoundOfDistance(points, Surface(points, { 0, 6, 6 }), Surface(points, pieces), 0, NeverStopped);
  EXPECT_GE(bound, 5);
  EXPECT_LE(bound, 1.05 * 5);
}

}
