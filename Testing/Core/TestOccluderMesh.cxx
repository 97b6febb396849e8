#include "NonFinite.h"

#include "Core/culling/mesh/OccluderMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace
{

using vitrine::OccluderMesh;
using Corners = std::vector<std::uint32_t>;
using Points = std::vector<glm::dvec3>;

const std::uint32_t NoFace = OccluderMesh::NoFace;

std::size_t CountBorders(const OccluderMesh& mesh)
{
  return std::count_if(mesh.Edges().begin(), mesh.Edges().end(),
    [](const OccluderMesh::Edge& edge) { return edge.Right == NoFace; });
}

/** The corners of the unit cube, by the bits of their numbers, and its triangles, counter-clockwise from outside. */
Points DicePoints()
{
  Points points;
  for (int i = 0; i < 8; ++i)
  {
    points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  return points;
}

Corners DiceCorners()
{
  return { 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6,
    1, 3, 5, 3, 7, 5 };
}

/** The same triangles, each with three points of its own. */
Points Exploded(const Points& points, const Corners& corners)
{
  Points exploded;
  for (const std::uint32_t corner : corners)
  {
    exploded.push_back(points[corner]);
  }
  return exploded;
}

Corners InOrder(std::size_t count)
{
  Corners corners(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    corners[i] = static_cast<std::uint32_t>(i);
  }
  return corners;
}

glm::dvec3 PlaceOf(const OccluderMesh& mesh, std::uint32_t point)
{
  return mesh.Origin() +
    glm::dvec3(mesh.Coordinates(0)[point], mesh.Coordinates(1)[point], mesh.Coordinates(2)[point]);
}

bool HasSide(const OccluderMesh::Face& face, std::uint32_t from, std::uint32_t to)
{
  return (face[0] == from && face[1] == to) || (face[1] == from && face[2] == to) ||
    (face[2] == from && face[0] == to);
}

/** Every side of every face stands in one edge, on the side where it lies; an edge joins what alone lies along it. */
void ExpectEdgesFit(const OccluderMesh& mesh)
{
  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  std::map<Ends, int> directed;
  for (const OccluderMesh::Face& face : mesh.Faces())
  {
    for (int i = 0; i < 3; ++i)
    {
      ++directed[Ends(face[i], face[(i + 1) % 3])];
    }
  }
  std::size_t sides = 0;
  for (const OccluderMesh::Edge& edge : mesh.Edges())
  {
    ASSERT_LT(edge.Left, mesh.Faces().size());
    EXPECT_TRUE(HasSide(mesh.Faces()[edge.Left], edge.From, edge.To));
    ++sides;
    const int along = directed[Ends(edge.From, edge.To)];
    const int against = directed[Ends(edge.To, edge.From)];
    EXPECT_EQ(edge.Right != NoFace, along == 1 && against == 1);
    if (edge.Right != NoFace)
    {
      ASSERT_LT(edge.Right, mesh.Faces().size());
      EXPECT_TRUE(HasSide(mesh.Faces()[edge.Right], edge.To, edge.From));
      ++sides;
    }
  }
  EXPECT_EQ(sides, 3 * mesh.Faces().size());
  EXPECT_EQ(mesh.IsClosed(), CountBorders(mesh) == 0);
}

}

TEST(OccluderMesh, OfNothing)
{
  for (const OccluderMesh& mesh :
    { OccluderMesh(), OccluderMesh({}, {}), OccluderMesh({ { 1, 2, 3 } }, {}) })
  {
    EXPECT_TRUE(mesh.Faces().empty());
    EXPECT_TRUE(mesh.Edges().empty());
    EXPECT_TRUE(mesh.IsClosed());
  }
  EXPECT_EQ(OccluderMesh().PointCount(), 0u);
}

TEST(OccluderMesh, OfABoxIsClosed)
{
  const Points exploded = Exploded(DicePoints(), DiceCorners());
  for (const OccluderMesh& mesh :
    { OccluderMesh(DicePoints(), DiceCorners()), OccluderMesh(exploded, InOrder(36)) })
  {
    EXPECT_EQ(mesh.PointCount(), 8u);
    EXPECT_EQ(mesh.Faces().size(), 12u);
    EXPECT_EQ(mesh.Edges().size(), 18u);
    EXPECT_EQ(mesh.Origin(), glm::dvec3(0.5));
    EXPECT_TRUE(mesh.IsClosed());
    ExpectEdgesFit(mesh);
  }
}

TEST(OccluderMesh, KeepsTheOrderAndTheTurnOfFaces)
{
  const OccluderMesh mesh(DicePoints(), DiceCorners());
  const Corners corners = DiceCorners();
  const Points points = DicePoints();
  ASSERT_EQ(mesh.Faces().size(), 12u);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    EXPECT_EQ(PlaceOf(mesh, mesh.Faces()[i / 3][i % 3]), points[corners[i]]) << i;
  }
}

TEST(OccluderMesh, OfASheetHasABorder)
{
  const OccluderMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { 0, 1, 2, 0, 2, 3 });
  EXPECT_FALSE(mesh.IsClosed());
  EXPECT_EQ(mesh.Edges().size(), 5u);
  EXPECT_EQ(CountBorders(mesh), 4u);
  ExpectEdgesFit(mesh);
}

TEST(OccluderMesh, OfABoxWithoutALidIsOpen)
{
  Corners corners = DiceCorners();
  corners.resize(33);
  const OccluderMesh mesh(DicePoints(), corners);
  EXPECT_FALSE(mesh.IsClosed());
  EXPECT_EQ(CountBorders(mesh), 3u);
  ExpectEdgesFit(mesh);
}

TEST(OccluderMesh, JoinsNoneOfThreeFacesAtOneEdge)
{
  const OccluderMesh mesh({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { 0, 1, 3, 1, 0, 2, 0, 1, 4 });
  EXPECT_EQ(mesh.Edges().size(), 9u);
  EXPECT_EQ(CountBorders(mesh), 9u);
  EXPECT_FALSE(mesh.IsClosed());
  ExpectEdgesFit(mesh);
}

TEST(OccluderMesh, JoinsNoneOfFourFacesAtOneEdge)
{
  const OccluderMesh mesh(
    { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { 0, 1, 3, 1, 0, 2, 0, 1, 4, 1, 0, 5 });
  EXPECT_EQ(CountBorders(mesh), 12u);
  ExpectEdgesFit(mesh);
}

TEST(OccluderMesh, DoesNotJoinNeighboursThatGoTheSameWay)
{
  const OccluderMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { 0, 1, 2, 0, 3, 2 });
  EXPECT_EQ(CountBorders(mesh), 6u);
  ExpectEdgesFit(mesh);
}

TEST(OccluderMesh, OfTheSameTriangleTwiceIsOpenAndOfBothItsSidesIsClosed)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } };
  EXPECT_FALSE(OccluderMesh(points, { 0, 1, 2, 1, 2, 0 }).IsClosed());
  const OccluderMesh both(points, { 0, 1, 2, 2, 1, 0 });
  EXPECT_TRUE(both.IsClosed());
  ExpectEdgesFit(both);
}

TEST(OccluderMesh, WeldsZerosOfBothSigns)
{
  const OccluderMesh mesh({ { 0.0, 0, 0 }, { 1, 0.0, 0 }, { 1, 1, 0 }, { -0.0, -0.0, 0 },
                            { 1, 1, -0.0 }, { 0, 1, -0.0 } },
    { 0, 1, 2, 3, 4, 5 });
  EXPECT_EQ(mesh.PointCount(), 4u);
  EXPECT_EQ(CountBorders(mesh), 4u);
}

// A device takes each to floats by its own transform; whether they meet is not known.
TEST(OccluderMesh, DoesNotWeldWhatDiffersByLessThanAFloat)
{
  const double less = std::nextafter(1.0, 0.0);
  ASSERT_EQ(static_cast<float>(less), 1.0f);
  const OccluderMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 0 }, { 1, less, 0 }, { 0, 1, 0 } },
    { 0, 1, 2, 3, 4, 5 });
  EXPECT_EQ(mesh.PointCount(), 5u);
  EXPECT_EQ(CountBorders(mesh), 6u);
}

TEST(OccluderMesh, LeavesOutTrianglesWithoutExtent)
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 } };
  const OccluderMesh mesh(points, { 0, 0, 1, 0, 1, 3, 2, 2, 2, 0, 1, 2 });
  ASSERT_EQ(mesh.Faces().size(), 1u);
  EXPECT_EQ(CountBorders(mesh), 3u);
  EXPECT_TRUE(OccluderMesh(points, { 0, 1, 3 }).Faces().empty());
}

TEST(OccluderMesh, LeavesOutTrianglesWithAPointThatIsNotFinite)
{
  for (const double bad : { double{ NotANumber }, double{ Infinity }, -double{ Infinity } })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Points points{ { 4, 0, 0 }, { 5, 0, 0 }, { 5, 2, 0 }, { 4, 2, 0 }, { 4, -2, 0 } };
      points[1][axis] = bad;
      const OccluderMesh mesh(points, { 0, 1, 2, 0, 2, 3 });
      ASSERT_EQ(mesh.Faces().size(), 1u);
      EXPECT_EQ(mesh.PointCount(), 4u);
      EXPECT_EQ(mesh.Origin(), glm::dvec3(4.5, 0, 0));
      EXPECT_EQ(PlaceOf(mesh, mesh.Faces()[0][2]), points[3]);
      EXPECT_EQ(CountBorders(mesh), 3u);
    }
  }
  const OccluderMesh none(Points(3, glm::dvec3(NotANumber)), { 0, 1, 2 });
  EXPECT_EQ(none.PointCount(), 0u);
  EXPECT_TRUE(none.Faces().empty());
}

TEST(OccluderMesh, IsFineFarFromTheOrigin)
{
  Points points = DicePoints();
  const glm::dvec3 offset(1e7, -2e7, 3e7);
  for (glm::dvec3& point : points)
  {
    point = offset + 1e-3 * point;
  }
  const OccluderMesh mesh(points, DiceCorners());
  EXPECT_TRUE(mesh.IsClosed());
  ASSERT_EQ(mesh.Faces().size(), 12u);
  EXPECT_EQ(mesh.PointCount(), 8u);
  for (std::size_t i = 0; i < 36; ++i)
  {
    const glm::dvec3 place = PlaceOf(mesh, mesh.Faces()[i / 3][i % 3]);
    const glm::dvec3 difference = place - points[DiceCorners()[i]];
    EXPECT_LT(std::abs(difference.x) + std::abs(difference.y) + std::abs(difference.z), 1.2e-8);
  }
}

TEST(OccluderMesh, HasAMiddleWhereSumsOverflow)
{
  const OccluderMesh mesh({ { 1.7e308, 0, 0 }, { 1.6e308, 0, 1 }, { 1.7e308, 1, 0 } }, { 0, 1, 2 });
  EXPECT_TRUE(std::isfinite(mesh.Origin().x));
  EXPECT_EQ(mesh.Faces().size(), 1u);
}

TEST(OccluderMesh, OfRandomTrianglesHasEverySideOnce)
{
  for (unsigned seed = 1; seed <= 50; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Points points(4 + random() % 8);
    for (glm::dvec3& point : points)
    {
      point = { random() % 3, random() % 2, random() % 2 };
    }
    Corners corners(3 * (1 + random() % 20));
    for (std::uint32_t& corner : corners)
    {
      corner = static_cast<std::uint32_t>(random() % points.size());
    }
    const OccluderMesh mesh(points, corners);
    ExpectEdgesFit(mesh);
    std::size_t faces = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const glm::dvec3 &a = points[corners[i]], &b = points[corners[i + 1]],
                       &c = points[corners[i + 2]];
      faces += a != b && b != c && c != a;
    }
    EXPECT_EQ(mesh.Faces().size(), faces);
    EXPECT_GE(mesh.Bytes(),
      sizeof(mesh) + mesh.Edges().size() * sizeof(OccluderMesh::Edge) + faces * 12 +
        mesh.PointCount() * 12);
  }
}
