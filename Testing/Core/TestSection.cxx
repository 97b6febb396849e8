#include "Core/geometry/ClosedMesh.h"
#include "Core/section/CutPolygon.h"
#include "Core/section/PartSums.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace
{

using vitrine::CutPlane;
using vitrine::IsClosed;

const std::vector<glm::dvec3> TetrahedronCorners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 } };
const std::vector<std::uint32_t> TetrahedronFaces = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 };

TEST(ClosedMesh, NeedsAllFaces)
{
  EXPECT_TRUE(IsClosed(TetrahedronCorners, TetrahedronFaces));
  EXPECT_FALSE(
    IsClosed(TetrahedronCorners, { TetrahedronFaces.begin() + 3, TetrahedronFaces.end() }));
  EXPECT_FALSE(IsClosed(TetrahedronCorners, {}));
}

TEST(ClosedMesh, MergesEqualPoints)
{
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t corner : TetrahedronFaces)
  {
    corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(TetrahedronCorners[corner]);
    points.back().x += 0.0 * points.back().y; // negative zeros are zeros
  }
  points[0].z = -points[0].z;
  EXPECT_TRUE(IsClosed(points, corners));
  points[0].z = 1e-9;
  EXPECT_FALSE(IsClosed(points, corners));
}

TEST(ClosedMesh, DropsDegenerateTrianglesAndTakesAnyEvenNumber)
{
  std::vector<std::uint32_t> more = TetrahedronFaces;
  more.insert(more.end(), { 1, 1, 2 });
  EXPECT_TRUE(IsClosed(TetrahedronCorners, more));
  more.insert(more.end(), TetrahedronFaces.begin(),
    TetrahedronFaces.end()); // twice the same: four faces at each edge
  EXPECT_TRUE(IsClosed(TetrahedronCorners, more));
  EXPECT_FALSE(IsClosed(TetrahedronCorners, { 1, 1, 2, 0, 0, 0 }));
  std::vector<glm::dvec3> points = TetrahedronCorners;
  points[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(IsClosed(points, TetrahedronFaces));
}

TEST(CutPlane, KeepsItsPointsInOtherCoordinates)
{
  const CutPlane plane{ glm::normalize(glm::dvec3(1, 2, 3)), -0.5 };
  const glm::dmat4 toWorld =
    glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(1, -2, 0.5)), 0.7,
                 glm::dvec3(0.6, 0.8, 0)),
      glm::dvec3(2, 1, 0.5));
  const glm::dvec3 point(0.3, -0.2, 0.9);
  const glm::dvec3 inWorld(toWorld * glm::dvec4(point, 1.0));
  EXPECT_NEAR(plane.In(toWorld).At(point), plane.At(inWorld), 1e-14);
  EXPECT_NEAR(plane.MovedBy(0.25).At(inWorld), plane.At(inWorld) + 0.25, 1e-14);
}

TEST(CutPlane, KnowsTheDistancesOfABox)
{
  const CutPlane plane{ { 0, -1, 0 }, 2.0 };
  const vitrine::DistanceRange range = DistancesOf(plane, { -5, 1, 0 }, { 5, 3, 9 });
  EXPECT_DOUBLE_EQ(range.Least, -1.0);
  EXPECT_DOUBLE_EQ(range.Greatest, 1.0);
}

TEST(CutPolygon, IsAHexagonInTheMiddleOfACube)
{
  const CutPlane plane{ glm::normalize(glm::dvec3(1, 1, 1)), 0.0 };
  const std::vector<glm::dvec3> polygon = CutPolygon(plane, glm::dvec3(-1.0), glm::dvec3(1.0));
  ASSERT_EQ(polygon.size(), 6u);
  glm::dvec3 area(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    EXPECT_NEAR(plane.At(polygon[i]), 0.0, 1e-14);
    area += 0.5 * glm::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  // The order is that around the normal.
  EXPECT_NEAR(glm::dot(area, plane.Normal), 3.0 * std::sqrt(3.0), 1e-12);
  EXPECT_TRUE(CutPolygon(plane.MovedBy(2.0), glm::dvec3(-1.0), glm::dvec3(1.0)).empty());
}

TEST(PlaneAxes, StandUprightWhereThePlaneDoes)
{
  const glm::dvec3 up(0, 1, 0);
  for (const glm::dvec3& normal :
    { glm::dvec3(1, 0, 0), glm::dvec3(-2, 0.3, 1), glm::dvec3(0, 1, 1e-9) })
  {
    const vitrine::PlaneAxes axes = vitrine::AxesOf({ normal, 0.5 }, up);
    EXPECT_NEAR(glm::dot(axes.U, normal), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(axes.V, normal), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(axes.U, axes.V), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(axes.U), 1.0, 1e-12);
    if (normal.x != 0.0)
    {
      EXPECT_NEAR(axes.U.y, 0.0, 1e-12) << "lines along U are not level";
      EXPECT_GT(axes.V.y, 0.0);
    }
  }
}

vitrine::PartSum SumOf(const vitrine::PartSlots& slots)
{
  vitrine::PartSum sum{ 0, 0 };
  for (const std::uint32_t slot : slots)
  {
    sum = vitrine::Toggled(sum, slot);
  }
  return sum;
}

TEST(PartSums, TellUpToThreePartsOfMany)
{
  vitrine::PartSlots known;
  for (std::uint32_t slot = 1; slot <= 60; ++slot)
  {
    known.insert(slot);
  }
  for (std::uint32_t a = 1; a <= 60; a += 3)
  {
    EXPECT_EQ(vitrine::PartsOf(SumOf({ a }), known), vitrine::PartSlots{ a });
    for (std::uint32_t b = a + 1; b <= 60; b += 7)
    {
      EXPECT_EQ(vitrine::PartsOf(SumOf({ a, b }), known), (vitrine::PartSlots{ a, b }));
      const vitrine::PartSlots three{ a, b, (a + b) % 60 + 1 };
      EXPECT_EQ(vitrine::PartsOf(SumOf(three), known), three);
    }
  }
  EXPECT_EQ(vitrine::PartsOf({ 0, 0 }, known), vitrine::PartSlots());
  EXPECT_FALSE(vitrine::PartsOf(SumOf({ 61 }), known));
  EXPECT_FALSE(vitrine::PartsOf(SumOf({ 1, 2 }), known, 1));
}

TEST(PartSums, TellManyPartsByThoseThatAreExpected)
{
  vitrine::PartSlots known;
  vitrine::PartSlots real;
  for (std::uint32_t slot = 1; slot <= 30; ++slot)
  {
    known.insert(slot);
    if (slot % 3 != 0)
    {
      real.insert(slot);
    }
  }
  vitrine::PartSlots expected = real;
  expected.erase(1);
  expected.insert(3);
  EXPECT_FALSE(vitrine::PartsOf(SumOf(real), known));
  EXPECT_EQ(vitrine::PartsNear(SumOf(real), expected, known), real);
  expected.erase(2);
  expected.erase(4);
  EXPECT_FALSE(vitrine::PartsNear(SumOf(real), expected, known));
}
}
