// Parts that have more faces than there are cells where they stand.

#include "PartScenes.h"

#include "Core/culling/walk/PartCuller.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstdint>

namespace
{

using coverage::AheadView;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::PartScene;
using coverage::Random;
using coverage::Triangles;
using vitrine::PartCuller;
using vitrine::SampleGrid;

const double Cell = 1.0 / 3.0;    // in a parallel view ahead
const double Sample = 0.5 * Cell; // where a sample is, in x and y, of lines of one row

std::uint32_t AddBall(PartScene& scene, int rings, const glm::dvec3& middle, double radius)
{
  Random random(1);
  return scene.Add(coverage::BallOf(2 * rings, rings, 1.0, random),
    glm::scale(glm::translate(glm::dmat4(1.0), middle), glm::dvec3(radius)));
}

/** Beside the view, so that there is enough to spend. */
void AddBoxesAside(PartScene& scene, int count)
{
  for (int i = 0; i < count; ++i)
  {
    scene.AddBox({ 100 + i, 0, -30 }, { 100.5 + i, 1, -29 });
  }
}

/** Of so many quads in each direction, and not so long that it comes first. */
Triangles WallOfQuads(double z, int count)
{
  Triangles wall;
  const auto at = [&](int i, int j)
  { return glm::dvec3(-5.0 + 10.0 * i / count, -5.0 + 10.0 * j / count, z); };
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      wall.AddQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return wall;
}

void CullAheadAt(PartScene& scene, const SampleGrid& samples)
{
  PartCuller culler(FrameColumns, FrameLines, samples);
  scene.Cull(culler, AheadView(true));
}
}

TEST(DenseParts, HideWhereLinesHaveOneRowOfSamples)
{
  for (const int pixels : { 1, 2 })
  {
    SCOPED_TRACE(pixels);
    PartScene scene;
    const std::uint32_t ball = AddBall(scene, 110, { 0, 0, -30 }, 5.0); // 48,180 faces on 900 cells
    const std::uint32_t behind = scene.AddBox({ -1, -1, -42 }, { 1, 1, -40 });
    AddBoxesAside(scene, 1000);
    CullAheadAt(scene, SampleGrid::AtCentres(pixels));
    EXPECT_TRUE(scene.Visible[ball]);
    EXPECT_EQ(scene.Visible[behind], pixels != 1);
  }
}

// The corner of the rectangle around a ball has a sample that the ball has not.
TEST(DenseParts, ThatCoverNoSampleAreHidden)
{
  for (const int rings : { 5, 20, 60 }) // 80, 1,520 and 14,160 faces
  {
    SCOPED_TRACE(rings);
    PartScene scene;
    const double radius = 0.4 * Cell, aside = Sample + 0.8 * radius;
    const std::uint32_t ball = AddBall(scene, rings, { aside, aside, -30 }, radius);
    const std::uint32_t seen =
      AddBall(scene, rings, { Sample + 0.5 * radius, -2 * Cell - 0.5 * Cell, -30 }, radius);
    AddBoxesAside(scene, 1000);
    CullAheadAt(scene, SampleGrid::AtCentres(1));
    EXPECT_EQ(scene.Visible[ball], rings == 60) << "that would take longer than to draw it";
    EXPECT_TRUE(scene.Visible[seen]);
  }
}

// Behind its side that faces the eye, and before a plane through its rim.
TEST(DenseParts, OfFewCellsHideByTheirFaces)
{
  for (const int pixels : { 1, 2 })
  {
    SCOPED_TRACE(pixels);
    PartScene scene;
    const std::uint32_t ball = AddBall(scene, 10, { 0, 0, -30 }, 2.0); // 12 by 12 cells
    const std::uint32_t inside = scene.AddBox({ -0.4, -0.4, -29 }, { 0.4, 0.4, -28.5 });
    const std::uint32_t before = scene.AddBox({ 0.9, -0.4, -27.9 }, { 1.6, 0.4, -27.8 });
    AddBoxesAside(scene, 100);
    CullAheadAt(scene, SampleGrid::AtCentres(pixels));
    EXPECT_TRUE(scene.Visible[ball]);
    EXPECT_FALSE(scene.Visible[inside]);
    EXPECT_TRUE(scene.Visible[before]);
  }
}

TEST(DenseParts, LeaveEnoughForOthers)
{
  PartScene scene;
  for (int i = 0; i < 20; ++i)
  {
    AddBall(scene, 40, { -10.0 + i % 10 * 2.0, -6.0 + i / 10 * 2.0, -20 }, 0.5); // 9 cells each
  }
  scene.Add(WallOfQuads(-30.0, 60)); // takes more than what small parts leave, and is not dense
  const std::uint32_t behind = scene.AddBox({ -1, -1, -42 }, { 1, 1, -40 });
  CullAheadAt(scene, SampleGrid::AtCentres(1));
  EXPECT_FALSE(scene.Visible[behind]);
}
