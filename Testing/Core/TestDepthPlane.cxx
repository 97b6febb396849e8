// Tests the depths of a plane against a device that snaps the corners for coverage, but takes depths from the unsnapped
// corners.
#include "SnappedFaces.h"

#include "Core/culling/steady/DepthPlane.h"

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
  return plane.NearestSegment(0.0f, 0.0f, 0.0f, 0.0f).Nearest;
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

/** Column, line and depth, times w, and w. */
using ClipCorners = std::array<glm::dvec4, 3>;

constexpr glm::vec2 ScreenSize(40, 20);

bool IsOnScreen(const glm::dvec3& point)
{
  return point.x >= 0.0 && point.x <= ScreenSize.x && point.y >= 0.0 && point.y <= ScreenSize.y;
}

/** Each of its corners is as far from the eye as may be, and every second face is a sliver. */
ClipCorners FaceNearTheEye(Random& random)
{
  ClipCorners corners;
  for (glm::dvec4& corner : corners)
  {
    const double w = std::pow(10.0, random.Between(-1.5, 1.5));
    corner = { w * random.Between(-60, 90), w * random.Between(-40, 60), 0.03, w };
  }
  if (random.OneIn(2))
  {
    corners[2] = glm::mix(corners[0], corners[1], random.Between(0.1, 0.9)) +
      glm::dvec4(random.Point(-1e-3, 1e-3), 0.0);
  }
  return corners;
}

/** Leads there from the ends of the unit vectors. */
vitrine::ScreenMatrix MatrixTo(const ClipCorners& corners)
{
  return { glm::dmat4(corners[0], corners[1], corners[2], glm::dvec4(0.0)),
    glm::vec4(2e-5f, 2e-5f, 1e-5f, 1e-5f), { 0.004f, 0.004f, 1e-6f }, ScreenSize };
}

vitrine::OccluderMesh FaceOfUnitVectors()
{
  coverage::Triangles face;
  face.Add({ 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 });
  return face.Mesh();
}

/** Where a device draws them that rounds each coordinate by half of what it may. */
Corners Rounded(const ClipCorners& corners, const glm::vec4& rounding, Random& random)
{
  Corners drawn;
  for (int i = 0; i < 3; ++i)
  {
    glm::dvec4 corner = corners[i];
    for (int axis = 0; axis < 4; ++axis)
    {
      const double most = 0.5 * rounding[axis];
      corner[axis] += random.OneIn(2) ? most : -most;
    }
    drawn[i] = glm::dvec3(corner) / corner.w;
  }
  return drawn;
}

/** Whether the corners on the screen are drawn as close to where they are as a margin says, without what is snapped. */
bool AreWithin(const vitrine::ScreenMargin& margin, const vitrine::ScreenMargin& snapping,
  const ClipCorners& corners, const Corners& drawn)
{
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 exact = glm::dvec3(corners[i]) / corners[i].w;
    const glm::dvec3 off = glm::abs(drawn[i] - exact);
    if (IsOnScreen(exact) &&
      !(off.x <= margin.Column - snapping.Column && off.y <= margin.Line - snapping.Line &&
        off.z <= margin.Depth - snapping.Depth))
    {
      return false;
    }
  }
  return true;
}

/** Somewhere in a face that is snapped besides. */
glm::dvec3 CoveredOf(const Corners& face, const vitrine::ScreenMargin& snapping, Random& random)
{
  const double u = random.Between(0, 1), v = random.Between(0, 1 - u);
  return face[0] + u * (face[1] - face[0]) + v * (face[2] - face[0]) +
    glm::dvec3(random.Between(-snapping.Column, snapping.Column),
      random.Between(-snapping.Line, snapping.Line), 0.0);
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
      plane.BoundIn(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f);
    ASSERT_GE(depth, 0.5 * (farthest.Left + farthest.Right)) << "face " << i;
    ASSERT_LE(depth, plane.NearestIn(column - 0.1f, column + 0.1f, line - 0.1f, line + 0.1f))
      << "face " << i;
    ASSERT_LE(depth, NearestOf(plane)) << "face " << i;
    beyond += depth > 0.51 || depth < 0.29;
  }
  EXPECT_GT(beyond, 1000) << "so many are drawn far beyond their corners";
}

// Where a face comes near the eye, its corners there are rounded the most; far from them little of that is left.
TEST(DepthPlane, BoundsFacesWhoseCornersAreRoundedApart)
{
  Random random(9);
  int known = 0, unknown = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const ClipCorners corners = FaceNearTheEye(random);
    const vitrine::ScreenMatrix matrix = MatrixTo(corners);
    const vitrine::OccluderMesh mesh = FaceOfUnitVectors();
    vitrine::MeshProjection projection;
    if (!projection.Project(mesh, matrix))
    {
      continue;
    }
    const vitrine::MeshFace& face = projection.Faces()[0];
    const DepthPlane plane(projection, face);
    const Corners drawn = Rounded(corners, matrix.Rounding, random);
    const vitrine::ScreenMargin margin = projection.MarginOf(face);
    EXPECT_LE(margin.Column, projection.Margin().Column);
    ASSERT_TRUE(AreWithin(margin, matrix.Snapping, corners, drawn)) << "seed 9, face " << i;
    for (int sample = 0; sample < 10; ++sample)
    {
      const glm::dvec3 covered = CoveredOf(drawn, matrix.Snapping, random);
      if (IsOnScreen(covered))
      {
        const double depth = glm::clamp(coverage::DepthAt(drawn, covered), 0.0, 1.0);
        ASSERT_LE(depth, NearestOf(plane) + 1e-6) << "seed 9, face " << i;
        ASSERT_GE(depth, plane.Bound().Farthest - 1e-6) << "seed 9, face " << i;
      }
    }
    ++(NearestOf(plane) < 1.5f ? known : unknown);
  }
  EXPECT_GT(known, 5000);
  EXPECT_GT(unknown, 500);
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
  EXPECT_LT(PlaneOf(corners).BoundIn(4.9f, 5.1f, 9.9f, 10.1f).Left, 0.0);
}
