// What a plane says of depths, held to what a device draws that snaps the corners it covers with, and not those that it takes depths from.
#include "SnappedFaces.h"

#include "Core/culling/DepthPlane.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using coverage::DrawnOf;
using coverage::Random;
using vitrine::DepthBound;
using vitrine::DepthPlane;
using vitrine::ScreenPoint;
using Corners = coverage::ScreenCorners;

DepthPlane PlaneOf(const Corners& corners)
{
  std::array<ScreenPoint, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = { static_cast<float>(corners[i].x), static_cast<float>(corners[i].y),
      static_cast<float>(corners[i].z) };
  }
  return DepthPlane(points[0], points[1], points[2], coverage::SnappedMargin, coverage::Snapping);
}

/** Of all that may be drawn. */
float NearestOf(const DepthPlane& plane)
{
  return plane.Before(0.0f, 0.0f, 0.0f, 0.0f).Nearest;
}

/** Its third corner stands that far beside the middle of the side between the others. */
Corners Sliver(double width, Random& random)
{
  const glm::dvec3 from = random.Point(4, 20), along = random.Point(-3, 3);
  const double length = std::hypot(along.x, along.y) + 1e-3;
  const glm::dvec3 beside(-along.y * width / length, along.x * width / length, 0.0);
  Corners corners{ from, from + along, from + 0.5 * along + beside };
  for (glm::dvec3& corner : corners)
  {
    corner.z = random.Between(0.3, 0.5);
  }
  return corners;
}

}

TEST(DepthPlane, BoundsWhatADeviceDraws)
{
  Random random(7);
  int beyond = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const Corners corners = Sliver(std::pow(10.0, random.Between(-6.0, 0.5)), random);
    const glm::dvec3 drawn = DrawnOf(corners, random);
    const double depth = drawn.z;
    const DepthPlane plane = PlaneOf(corners);
    const float column = static_cast<float>(drawn.x), line = static_cast<float>(drawn.y);
    const DepthBound farthest =
      plane.Within(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f);
    ASSERT_GE(depth, 0.5 * (farthest.Left + farthest.Right)) << "face " << i;
    ASSERT_LE(depth, plane.NearestWithin(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f))
      << "face " << i;
    ASSERT_LE(depth, NearestOf(plane)) << "face " << i;
    beyond += depth > 0.51 || depth < 0.29;
  }
  EXPECT_GT(beyond, 1000) << "so many are drawn far beyond their corners";
}

TEST(DepthPlane, OfAWideFaceIsAsNearAsItsCorners)
{
  const Corners corners{ glm::dvec3(5, 5, 0.3), glm::dvec3(15, 5, 0.4), glm::dvec3(5, 15, 0.5) };
  EXPECT_NEAR(NearestOf(PlaneOf(corners)), 0.5, 1e-3);
}

TEST(DepthPlane, OfASliverHasAnyDepth)
{
  const Corners corners{ glm::dvec3(5, 5, 0.3), glm::dvec3(5, 15, 0.4),
    glm::dvec3(5.001, 10, 0.4) };
  EXPECT_GT(NearestOf(PlaneOf(corners)), 1.0);
  EXPECT_LT(PlaneOf(corners).Within(4.9f, 5.1f, 9.9f, 10.1f).Left, 0.0);
}
