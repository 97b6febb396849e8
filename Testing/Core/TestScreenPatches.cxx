// Planes behind patches of faces, held to what a device draws of these.
#include "SnappedFaces.h"

#include "Core/culling/cover/ScreenPatches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

using coverage::BoxBetween;
using coverage::DrawnOf;
using coverage::Random;
using coverage::ScreenCorners;
using coverage::Triangles;
using vitrine::DepthBound;
using vitrine::MeshFace;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::ScreenMatrix;
using vitrine::ScreenPatches;

using Facing = MeshProjection::Facing;

/** A mesh on a screen, and its patches. Without a matrix its points are given as columns, lines and reversed depths. */
class Shown
{
public:
  explicit Shown(const Triangles& triangles, const glm::dmat4& matrix = glm::dmat4(1.0))
    : Mesh(triangles.Mesh())
  {
    const glm::vec4 rounding(coverage::SnappedMargin.Column - coverage::Snapping.Column,
      coverage::SnappedMargin.Line - coverage::Snapping.Line,
      coverage::SnappedMargin.Depth - coverage::Snapping.Depth, 0.0f);
    const ScreenMatrix toScreen{ matrix, rounding, coverage::Snapping, { 40, 20 } };
    this->Projection.Project(this->Mesh, toScreen);
    this->Projection.FindFacings();
    this->Patches.Find(this->Projection, Facing::Front, vitrine::SampleGrid::AtCentres(1));
  }

  ScreenCorners CornersOf(const MeshFace& face) const
  {
    ScreenCorners corners;
    for (int i = 0; i < 3; ++i)
    {
      const vitrine::ScreenPoint point = this->Projection.Point(face[i]);
      corners[i] = { point.Column, point.Line, point.Depth };
    }
    return corners;
  }

  DepthBound BoundAt(std::uint32_t patch, double column, double line) const
  {
    const float x = static_cast<float>(column), y = static_cast<float>(line);
    return this->Patches[patch].Bound.BoundIn(x - 0.05f, x + 0.05f, y - 0.05f, y + 0.05f);
  }

  OccluderMesh Mesh;
  MeshProjection Projection;
  ScreenPatches Patches;
};

/** Bent a little, with some faces next to nothing wide. */
Triangles BentGrid(Random& random)
{
  const double bend = random.Between(-0.002, 0.002), slant = random.Between(-0.01, 0.01);
  const double narrow = random.OneIn(2) ? 1.0 : random.Between(3.0, 12.0);
  return coverage::GridOf(6, 4,
    [&](double u, double v)
    {
      const double x = 4.0 + 30.0 * std::pow(u, narrow), y = 3.0 + 12.0 * v;
      return glm::dvec3(x, y, 0.5 + slant * (x - 18.0) + bend * (x - 18.0) * (x - 18.0) / 18.0);
    });
}

}

TEST(ScreenPatches, LieBehindWhatADeviceDraws)
{
  int several = 0;
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Shown shown(BentGrid(random));
    several += shown.Patches.Count() < shown.Mesh.Faces().size() / 2;
    for (std::uint32_t i = 0; i < shown.Mesh.Faces().size(); ++i)
    {
      const std::uint32_t patch = shown.Patches.IndexOf(i);
      if (patch == ScreenPatches::None) // without area
      {
        continue;
      }
      for (int k = 0; k < 20; ++k)
      {
        const glm::dvec3 drawn = DrawnOf(shown.CornersOf(shown.Mesh.Faces()[i]), random);
        const DepthBound bound = shown.BoundAt(patch, drawn.x, drawn.y);
        ASSERT_GE(drawn.z, 0.5 * (bound.Left + bound.Right)) << "face " << i;
      }
    }
  }
  EXPECT_GT(several, 200) << "of so many most faces are joined";
}

TEST(ScreenPatches, OfABoxAreItsSides)
{
  const glm::dmat4 place =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(20, 10, 0.5)), glm::dvec3(5, 5, 0.1));
  const Shown shown(
    BoxBetween({ -1, -1, -1 }, { 1, 1, 1 }), glm::rotate(place, 0.7, glm::dvec3(1.0, 2.0, 0.5)));
  EXPECT_EQ(shown.Patches.Count(), 3u);
  std::set<std::uint32_t> patches;
  for (std::uint32_t i = 0; i < shown.Mesh.Faces().size(); ++i)
  {
    const bool counts = shown.Projection.FacingOf(i) == Facing::Front;
    EXPECT_EQ(shown.Patches.IndexOf(i) != ScreenPatches::None, counts);
    patches.insert(shown.Patches.IndexOf(i));
  }
  EXPECT_EQ(patches.size(), 4u) << "three, and none";
}

TEST(ScreenPatches, HaveThePlaneOfFlatFaces)
{
  const Shown shown(coverage::GridOf(8, 5,
    [](double u, double v)
    { return glm::dvec3(3 + 30 * u, 2 + 15 * v, 0.3 + 0.3 * u + 0.1 * v); }));
  ASSERT_EQ(shown.Patches.Count(), 1u);
  const DepthBound bound = shown.BoundAt(0, 18.0, 9.5);
  EXPECT_NEAR(bound.Left, 0.5 - 0.05 * 0.01 - 0.05 * 0.1 / 15, 2e-3);
  EXPECT_LE(bound.Left, 0.5);
  EXPECT_NEAR(shown.Patches[0].Bottom, 2.0, 0.02);
  EXPECT_NEAR(shown.Patches[0].Top, 17.0, 0.02);
}

// A device may draw a sliver at any depth: the wall beside it keeps its own.
TEST(ScreenPatches, AreNotSpoiledBySlivers)
{
  Triangles wall;
  wall.AddQuad({ 5, 5, 0.5 }, { 30, 5, 0.5 }, { 30, 15, 0.5 }, { 5, 15, 0.5 });
  wall.Add({ 30, 15, 0.5 }, { 30, 5, 0.5 }, { 30.001, 10, 0.5 });
  wall.Add({ 5, 5, 0.5 }, { 5, 15, 0.5 }, { 4.999, 10, 0.500002 });
  const Shown shown(wall);
  const std::uint32_t patch = shown.Patches.IndexOf(0);
  EXPECT_EQ(shown.Patches.IndexOf(1), patch);
  EXPECT_NEAR(shown.BoundAt(patch, 18.0, 10.0).Left, 0.5, 1e-3);
  EXPECT_GT(shown.Patches.Count(), 1u);
}
