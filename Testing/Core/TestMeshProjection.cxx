#include "OccluderScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::Random;
using coverage::Triangles;
using coverage::View;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::ScreenMargin;
using vitrine::ScreenMatrix;
using Facing = vitrine::MeshProjection::Facing;

/** What a device makes of a point: matrix and coordinates are floats, and so is every product and sum. */
glm::dvec3 ByDevice(const View& view, const glm::dmat4& toWorld, const glm::dvec3& point)
{
  const glm::mat4 toClip(view.ToClip * toWorld);
  const glm::vec3 p(point);
  const glm::vec4 clip = toClip[0] * p.x + toClip[1] * p.y + toClip[2] * p.z + toClip[3];
  return { (double{ clip.x / clip.w } + 1.0) / 2.0 * view.Columns,
    (double{ clip.y / clip.w } + 1.0) / 2.0 * view.Lines, (1.0 - double{ clip.z / clip.w }) / 2.0 };
}

bool IsOnScreen(const View& view, const glm::dvec3& point)
{
  return point.x >= 0.0 && point.x <= view.Columns && point.y >= 0.0 && point.y <= view.Lines;
}

/** Of what a matrix adds up for a point, in parts of `reach`. */
float CoarserOf(const glm::dmat4& toWorld, const std::vector<glm::dvec3>& points, double reach)
{
  double most = 1.0;
  for (const glm::dvec3& point : points)
  {
    const glm::dvec3 sums = coverage::SumsOf(toWorld, point);
    most = std::max({ most, sums.x / reach, sums.y / reach, sums.z / reach });
  }
  return static_cast<float>(most);
}

/** What a device computes points from that count from a place. */
vitrine::DeviceCoordinates DrawnFrom(
  const glm::dvec3& origin, const glm::dmat4& toWorld, const std::vector<glm::dvec3>& points)
{
  vitrine::DeviceCoordinates drawn{ origin, glm::dvec3(0.0), glm::dvec3(0.0) };
  for (const glm::dvec3& point : points)
  {
    drawn.Farthest = glm::max(drawn.Farthest, glm::abs(point - origin));
    drawn.InWorld = glm::max(drawn.InWorld, coverage::SumsOf(toWorld, point));
  }
  return drawn;
}

Triangles OneTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  Triangles triangle;
  triangle.Add(a, b, c);
  return triangle;
}

ScreenMatrix Plainly()
{
  return { glm::dmat4(1.0), glm::vec4(0.0f), { 0.5f, 0.25f, 0.125f }, { 40, 20 } };
}

Facing FacingOf(const Triangles& triangle)
{
  const OccluderMesh mesh = triangle.Mesh();
  MeshProjection projection;
  projection.Project(mesh, Plainly());
  projection.FindFacings();
  return projection.FacingOf(0);
}

}

TEST(MeshProjection, TellsWhichWayFacesGoAround)
{
  EXPECT_EQ(FacingOf(OneTriangle({ 1, 1, 0.5 }, { 9, 1, 0.5 }, { 1, 9, 0.5 })), Facing::Front);
  EXPECT_EQ(FacingOf(OneTriangle({ 1, 1, 0.5 }, { 1, 9, 0.5 }, { 9, 1, 0.5 })), Facing::Back);
  EXPECT_EQ(FacingOf(OneTriangle({ 1, 1, 0.5 }, { 2, 2, 0.5 }, { 3, 3, 0.2 })), Facing::Neither);
}

TEST(MeshProjection, HasARectangleWithTheMargin)
{
  const OccluderMesh mesh = OneTriangle({ 1, 2, 0.5 }, { 9, 3, 0.75 }, { 4, 11, 0.25 }).Mesh();
  MeshProjection projection;
  EXPECT_TRUE(projection.Project(mesh, Plainly()));
  const float ofColumns = 40.0f * 0x1p-24f,
              ofLines = 20.0f * 0x1p-24f; // what floats round of places
  EXPECT_EQ(projection.Rectangle().Left, 1.0f - (0.5f + ofColumns));
  EXPECT_EQ(projection.Rectangle().Right, 9.0f + (0.5f + ofColumns));
  EXPECT_EQ(projection.Rectangle().Bottom, 2.0f - (0.25f + ofLines));
  EXPECT_EQ(projection.Rectangle().Top, 11.0f + (0.25f + ofLines));
  EXPECT_EQ(projection.Rectangle().Nearest, 0.875f);
}

TEST(MeshProjection, HasNoneWithoutPointsOrBeforeTheNearPlaneOrTheEye)
{
  MeshProjection projection;
  EXPECT_FALSE(projection.Project(OccluderMesh(), Plainly()));
  const OccluderMesh near = OneTriangle({ 1, 2, 0.5 }, { 9, 3, 1.25 }, { 4, 11, 0.25 }).Mesh();
  EXPECT_FALSE(projection.Project(near, Plainly()));

  const OccluderMesh mesh = OneTriangle({ 1, 2, 0.5 }, { 9, 3, 0.75 }, { 4, 11, 0.25 }).Mesh();
  ScreenMatrix behindEye = Plainly();
  behindEye.Matrix = -behindEye.Matrix;
  behindEye.Matrix[3].z = -4.0;
  EXPECT_FALSE(projection.Project(mesh, behindEye));
  EXPECT_TRUE(projection.Faces().empty());
  EXPECT_EQ(projection.FacingOf(mesh.Faces()[0]), Facing::Neither);
}

TEST(MeshProjection, TakesTheMarginOfTheNearestPoint)
{
  ScreenMatrix matrix = Plainly();
  matrix.Matrix[2] = { 0, 0, 0, 1 }; // w is z
  matrix.Matrix[3] = { 0, 0, 0.25, 0 };
  matrix.Rounding = glm::vec4(0.01f);
  for (const int nearest : { 0, 1, 2 })
  {
    glm::dvec3 points[3] = { { 1, 1, 8 }, { 9, 1, 8 }, { 1, 9, 8 } };
    points[nearest].z = 2.0;
    const OccluderMesh mesh = OneTriangle(points[0], points[1], points[2]).Mesh();
    MeshProjection projection;
    EXPECT_TRUE(projection.Project(mesh, matrix));
    EXPECT_NEAR(projection.Margin().Column, 0.5 + (0.01 + 40 * 0.01) / 2.0, 1e-5);
    EXPECT_NEAR(projection.Margin().Line, 0.25 + (0.01 + 20 * 0.01) / 2.0, 1e-5);
    EXPECT_NEAR(projection.Margin().Depth, 0.125 + (0.01 + 0.01) / 2.0, 1e-5);
  }
}

// The coordinates are as large as a million times the part, in its model or in the world.
TEST(MeshProjection, HasPointsWhereADeviceHasThemWithinTheMargin)
{
  int tested = 0;
  double used = 0.0; // the most that was needed of a margin
  for (unsigned seed = 1; seed <= 1500; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Triangles triangles = coverage::RandomTriangles(random);
    const bool isFarInWorld = random.OneIn(3);
    const glm::dvec3 middle =
      std::pow(10.0, random.Between(0.0, 6.0)) * random.Point(-1, 1) * (isFarInWorld ? 1.0 : 0.0);
    const glm::dvec3 model = std::pow(10.0, random.Between(0.0, 6.0)) * random.Point(-1, 1) *
      (random.OneIn(3) ? 1.0 : 0.0);
    const bool isAboutMiddle = random.OneIn(2); // drawn
    glm::dmat4 toWorld = glm::translate(glm::dmat4(1.0), middle);
    toWorld = glm::rotate(toWorld, random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(1.01));
    toWorld = glm::translate(toWorld, -model);
    double reach = 0.0;
    for (glm::dvec3& point : triangles.Points)
    {
      point = isAboutMiddle ? point + model : glm::dvec3(glm::vec3(point + model));
      const glm::dvec3 world(toWorld * glm::dvec4(point, 1.0));
      reach = std::max({ reach, std::abs(world.x), std::abs(world.y), std::abs(world.z) });
    }
    View view = coverage::RandomView(middle, random);
    view.Snapping = { 1e-6f, 1e-6f, 0x1p-21f }; // for what is rounded after the division
    const OccluderMesh mesh = triangles.Mesh();
    MeshProjection projection;
    const vitrine::DeviceCoordinates drawn =
      DrawnFrom(isAboutMiddle ? model : glm::dvec3(0.0), toWorld, triangles.Points);
    projection.Project(mesh,
      view.Projection(reach * CoarserOf(toWorld, triangles.Points, reach)).Of(toWorld, drawn));
    projection.FindFacings();
    std::vector<bool> counts(mesh.PointCount(), false);
    for (std::uint32_t i = 0; i < projection.Faces().size(); ++i)
    {
      for (const std::uint32_t corner : projection.Faces()[i])
      {
        if (corner < mesh.PointCount() && projection.FacingOf(i) != Facing::Neither)
        {
          counts[corner] = true;
        }
      }
    }
    const ScreenMargin& margin = projection.Margin();
    for (std::uint32_t i = 0; i < mesh.PointCount(); ++i)
    {
      const glm::dvec3 model = mesh.Origin() +
        glm::dvec3(mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i]);
      const glm::dvec4 exact = view.OnScreen(glm::dvec3(toWorld * glm::dvec4(model, 1.0)));
      const glm::dvec3 device =
        ByDevice(view, glm::translate(toWorld, drawn.Origin), model - drawn.Origin);
      const vitrine::ScreenPoint point = projection.Point(i);
      if (!counts[i] || !IsOnScreen(view, glm::dvec3(exact)) || !(exact.z > 0.0))
      {
        continue;
      }
      ++tested;
      for (const glm::dvec3& place : { glm::dvec3(exact), device })
      {
        ASSERT_LE(std::abs(place.x - point.Column), margin.Column);
        ASSERT_LE(std::abs(place.y - point.Line), margin.Line);
        ASSERT_LE(std::abs(place.z - point.Depth), margin.Depth);
        used = std::max(used, std::abs(place.x - point.Column) / margin.Column);
      }
    }
  }
  EXPECT_GT(tested, 5000);
  EXPECT_GT(used, 0.02);
}

// The corners where a mesh is cut are stored behind its points. So all of them may be as many as the points of the next
// mesh. Sanitizers notice accesses beyond.
TEST(MeshProjection, HasRoomForAMeshAfterAnotherOneThatWasCut)
{
  const auto facesOf = [](int count, double depth)
  {
    Triangles faces;
    for (int i = 0; i < count; ++i)
    {
      faces.Add({ i, 0, depth }, { i + 1, 0, 0.5 }, { i, 1 + i, 0.25 });
    }
    return faces.Mesh();
  };
  for (int before = 1; before <= 12; ++before)
  {
    for (int count = 1; count <= 12; ++count)
    {
      SCOPED_TRACE(testing::Message() << count << " faces after " << before);
      const OccluderMesh cut = facesOf(before, 1.5), mesh = facesOf(count, 0.75);
      MeshProjection projection, fresh;
      ASSERT_FALSE(projection.Project(cut, Plainly()));
      ASSERT_TRUE(projection.Project(mesh, Plainly()));
      ASSERT_TRUE(fresh.Project(mesh, Plainly()));
      for (std::uint32_t i = 0; i < mesh.PointCount(); ++i)
      {
        EXPECT_TRUE(projection.IsBehindNear(i));
        EXPECT_EQ(projection.Point(i).Depth, fresh.Point(i).Depth);
      }
    }
  }
}
