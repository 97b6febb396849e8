// Faces that a device may draw as slivers: how near they may be drawn, and when they are hidden.
#include "OccluderScenes.h"

#include "Core/culling/FaceThickness.h"
#include "Core/culling/HiddenFaces.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using coverage::Random;
using coverage::Triangles;
using vitrine::HiddenFaces;
using vitrine::MeshProjection;
using vitrine::NearestOfThickness;
using vitrine::OccluderMesh;
using vitrine::SBuffer;
using vitrine::ScreenMargin;
using vitrine::ScreenMatrix;
using vitrine::ScreenProjection;

const int Columns = 40;
const int Lines = 20;

/** Columns, lines and depths are those of the points. */
ScreenMatrix PlainMatrix()
{
  return { glm::dmat4(1.0), glm::vec4(1e-3f, 1e-3f, 1e-6f, 0.0f), { 4e-3f, 4e-3f, 1e-6f },
    { Columns, Lines } };
}

/** The same as a view. */
ScreenProjection PlainView()
{
  glm::dmat4 toClip(1.0);
  toClip[0][0] = 2.0 / Columns;
  toClip[1][1] = 2.0 / Lines;
  toClip[2][2] = -2.0;
  toClip[3] = { -1.0, -1.0, 1.0, 1.0 };
  return ScreenProjection(toClip, Columns, Lines, glm::dvec3(Columns), { 1e-3f, 1e-3f, 1e-6f });
}

/** A triangle that is so long and thick, somewhere, its depths from 0.3 on. */
void AddTriangle(Triangles& to, double length, double thickness, double depths, Random& random)
{
  const double angle = random.Between(0.0, 2.0 * M_PI);
  const glm::dvec3 along(std::cos(angle), std::sin(angle), 0.0), across(-along.y, along.x, 0.0);
  const glm::dvec3 place(random.Between(5.0, 35.0), random.Between(5.0, 15.0), 0.3);
  const auto depth = [&] { return glm::dvec3(0.0, 0.0, random.Between(0.0, depths)); };
  to.Add(place + depth(), place + length * along + depth(),
    place + random.Between(0.0, 1.0) * length * along + thickness * across + depth());
}

/** So many slivers at one place behind a wall, whose depths differ by so much. */
bool AreHiddenBehindWall(int count, double depths)
{
  SBuffer lines(Columns, Lines);
  for (int line = 0; line < Lines; ++line)
  {
    lines.Insert(line, { 0.0f, Columns, 0.5f, 0.5f, 1 });
  }
  Triangles slivers;
  for (int i = 0; i < count; ++i)
  {
    const double left = 10.0 + 1e-3 * i;
    slivers.Add({ left, 5, 0.3 }, { left + 1e-6, 7, 0.3 - depths }, { left - 1e-6, 7, 0.3 });
  }
  const OccluderMesh mesh = slivers.Mesh();
  const ScreenProjection view = PlainView();
  MeshProjection projection;
  projection.Project(mesh, view.Of(glm::dmat4(1.0)));
  return HiddenFaces(lines, view).AreAllOfAnyThickness(projection);
}

}

TEST(FaceThickness, AreNowhereNearerThanTheirThicknessTells)
{
  Random random(23);
  double closest = 1e30;
  for (int round = 0; round < 20000; ++round)
  {
    const double thickness = std::exp(random.Between(-12.0, -1.0));
    Triangles triangle;
    AddTriangle(triangle, thickness * std::exp(random.Between(0.0, 8.0)), thickness, 0.1, random);
    const glm::dvec3 &a = triangle.Points[0], &b = triangle.Points[1], &c = triangle.Points[2];
    const OccluderMesh mesh = triangle.Mesh();
    MeshProjection projection;
    projection.Project(mesh, PlainMatrix());
    ASSERT_EQ(projection.Faces().size(), 1u);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::dvec2 slope = -glm::dvec2(normal) / normal.z;
    // Of places that corners were moved to, the nearest lies beside one of them.
    const ScreenMargin& snapping = projection.Snapping();
    const double beside = std::abs(slope.x) * snapping.Column + std::abs(slope.y) * snapping.Line;
    const double reached = std::max({ a.z, b.z, c.z }) + beside;
    const double told =
      NearestOfThickness(projection, projection.Faces()[0], static_cast<float>(0.999 * thickness));
    ASSERT_LE(reached, told) << "seed 23, round " << round;
    closest = std::min(closest, (told - 0.4) / (reached - 0.4 + 1e-9));
  }
  EXPECT_LT(closest, 3.0) << "nor is it told to be much nearer";
}

TEST(FaceThickness, OfPartsOfManyAreNoThinnerThanFloats)
{
  EXPECT_FALSE(AreHiddenBehindWall(1024, 1e-6)) << "each may be of any thickness";
  EXPECT_TRUE(AreHiddenBehindWall(1025, 1e-6));
  EXPECT_FALSE(AreHiddenBehindWall(1025, 1e-2));
}
