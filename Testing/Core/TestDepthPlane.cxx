// What a plane says of depths, held to what a device draws that snaps the corners it covers with, and not those that it takes depths from.
#include "OccluderScenes.h"

#include "Core/culling/DepthPlane.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

using coverage::Random;
using vitrine::DepthBound;
using vitrine::DepthPlane;
using vitrine::ScreenMargin;
using vitrine::ScreenPoint;

using Corners = std::array<glm::dvec3, 3>; // column, line and depth

const ScreenMargin Margin{ 0.017f, 0.017f, 2e-5f };
const ScreenMargin Snapping{ 0.016f, 0.016f, 1e-5f };

DepthPlane PlaneOf(const Corners& corners)
{
  std::array<ScreenPoint, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = { static_cast<float>(corners[i].x), static_cast<float>(corners[i].y),
      static_cast<float>(corners[i].z) };
  }
  return DepthPlane(points[0], points[1], points[2], Margin, Snapping);
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

glm::dvec3 Moved(const glm::dvec3& corner, double pixels, double depth, Random& random)
{
  return corner +
    glm::dvec3(random.Between(-pixels, pixels), random.Between(-pixels, pixels),
      random.Between(-depth, depth));
}

/** Depth at a place, of the plane through three points. */
double DepthAt(const Corners& corners, const glm::dvec3& place)
{
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3 offset = place - corners[0];
  return corners[0].z - (normal.x * offset.x + normal.y * offset.y) / normal.z;
}

}

TEST(DepthPlane, BoundsWhatADeviceDraws)
{
  Random random(7);
  int beyond = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const Corners corners = Sliver(std::pow(10.0, random.Between(-6.0, 0.5)), random);
    Corners drawn, snapped;
    for (int k = 0; k < 3; ++k)
    {
      drawn[k] = Moved(corners[k], 0.0009, 0.9e-5, random);
      snapped[k] = Moved(drawn[k], 0.0159, 0.0, random);
    }
    const double u = random.Between(0, 1), v = random.Between(0, 1 - u);
    const glm::dvec3 sample =
      snapped[0] + u * (snapped[1] - snapped[0]) + v * (snapped[2] - snapped[0]);
    const double depth = glm::clamp(DepthAt(drawn, sample), 0.0, 1.0);
    const DepthPlane plane = PlaneOf(corners);
    const float column = static_cast<float>(sample.x), line = static_cast<float>(sample.y);
    const DepthBound farthest =
      plane.Within(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f);
    ASSERT_GE(depth, 0.5 * (farthest.Left + farthest.Right)) << "face " << i;
    ASSERT_LE(depth, plane.NearestWithin(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f))
      << "face " << i;
    ASSERT_LE(depth, plane.NearestOfAll()) << "face " << i;
    beyond += depth > 0.51 || depth < 0.29;
  }
  EXPECT_GT(beyond, 1000) << "so many are drawn far beyond their corners";
}

TEST(DepthPlane, OfAWideFaceIsAsNearAsItsCorners)
{
  const Corners corners{ glm::dvec3(5, 5, 0.3), glm::dvec3(15, 5, 0.4), glm::dvec3(5, 15, 0.5) };
  EXPECT_NEAR(PlaneOf(corners).NearestOfAll(), 0.5, 1e-3);
}

TEST(DepthPlane, OfASliverHasAnyDepth)
{
  const Corners corners{ glm::dvec3(5, 5, 0.3), glm::dvec3(5, 15, 0.4),
    glm::dvec3(5.001, 10, 0.4) };
  EXPECT_GT(PlaneOf(corners).NearestOfAll(), 1.0);
  EXPECT_LT(PlaneOf(corners).Within(4.9f, 5.1f, 9.9f, 10.1f).Left, 0.0);
}
