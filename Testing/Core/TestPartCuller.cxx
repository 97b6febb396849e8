#include "NonFinite.h"
#include "PartScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::Triangles;
using coverage::View;
using vitrine::Box;
using vitrine::Octree;
using vitrine::PartCuller;

const int FrameColumns = 96;
const int FrameLines = 54;

/** From the origin along -z, or of all that lies 10 to either side; from 1 to 100. */
View AheadView(bool isParallel)
{
  View view;
  view.Columns = FrameColumns;
  view.Lines = FrameLines;
  view.IsParallel = isParallel;
  view.Eye = isParallel ? glm::dvec3(0, 0, -1) : glm::dvec3(0.0);
  view.ToClip = isParallel ? glm::ortho(-16.0, 16.0, -9.0, 9.0, 1.0, 100.0)
                           : glm::perspective(glm::radians(60.0), 16.0 / 9.0, 1.0, 100.0);
  return view;
}

Triangles WallAt(double z)
{
  Triangles wall;
  wall.AddQuad({ -60, -60, z }, { 60, -60, z }, { 60, 60, z }, { -60, 60, z });
  return wall;
}

/** A heap of boxes within -10 .. 10, some turned, some open, some that hide nothing or have no back faces. */
PartScene HeapOf(int count, Random& random)
{
  PartScene scene;
  const double size = random.Between(0.5, 3.0);
  for (int i = 0; i < count; ++i)
  {
    glm::dvec3 half = random.Point(0.05, size);
    if (random.OneIn(6))
    {
      half[random.Below(3)] = 6.0;
    }
    Triangles box = coverage::BoxBetween(-half, half);
    if (random.OneIn(5))
    {
      box.Corners.resize(box.Corners.size() - 3 * (1 + random.Below(6)));
    }
    glm::dmat4 toWorld = glm::translate(glm::dmat4(1.0), random.Point(-10, 10));
    if (random.OneIn(2))
    {
      toWorld = glm::rotate(toWorld, random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(1.01));
    }
    if (random.OneIn(7))
    {
      toWorld = glm::scale(toWorld, glm::dvec3(-1.0, 1.0, 1.0));
    }
    const std::uint32_t part = scene.Add(box, toWorld);
    scene.Parts[part].Hides = !random.OneIn(10);
    scene.Parts[part].HasBackFaces = !random.OneIn(4);
    scene.Visible[part] = !random.OneIn(12);
  }
  return scene;
}

/** Of a heap, from without or from within. */
View ViewOfHeap(Random& random)
{
  View view = AheadView(random.OneIn(3));
  view.Columns = 20 + random.Below(80);
  view.Lines = 12 + random.Below(50);
  const glm::dvec3 eye = random.OneIn(3)
    ? random.Point(-9, 9)
    : random.Between(14.0, 30.0) * glm::normalize(random.Point(-1, 1) + glm::dvec3(0, 0, 0.01));
  const glm::dvec3 target = random.Point(-3, 3);
  const double nearest = random.OneIn(2) ? 0.1 : 2.0;
  view.ToClip = (view.IsParallel ? glm::ortho(-13.0, 13.0, -9.0, 9.0, nearest, 60.0)
                                 : glm::perspective(random.Between(0.5, 1.5), 1.5, nearest, 60.0)) *
    glm::lookAt(eye, target, glm::dvec3(0.1, 1.0, 0.2));
  view.Eye = view.IsParallel ? glm::normalize(target - eye) : eye;
  return view;
}

}

TEST(PartCuller, DropsNothingThatIsSeen)
{
  int hidden = 0;
  int culled = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = HeapOf(100 + random.Below(300), random);
    const View view = ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    PartCuller culler(view.Columns, view.Lines);
    scene.Cull(culler, view);
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      EXPECT_LE(scene.Visible[i], drawn[i]) << i;
      if (drawn[i] && !scene.Visible[i])
      {
        ASSERT_FALSE(sight.Sees(i, 150, random)) << "part " << i;
        ++culled;
        ++hidden;
      }
      else if (drawn[i])
      {
        hidden += !sight.Sees(i, 60, random);
      }
    }
  }
  EXPECT_GT(hidden, 2000);
  EXPECT_GT(culled, 0.5 * hidden);
}

TEST(PartCuller, DropsWhatIsBehindAWall)
{
  for (const bool isParallel : { false, true })
  {
    SCOPED_TRACE(isParallel);
    PartScene scene;
    const std::uint32_t wall = scene.Add(WallAt(-20.0));
    for (int i = 0; i < 100; ++i)
    {
      scene.AddBox({ i % 10 - 5, i / 10 - 5, -50 }, { i % 10 - 4.1, i / 10 - 4.1, -40 });
    }
    const std::uint32_t before = scene.AddBox({ -1, -1, -12 }, { 1, 1, -10 });
    PartCuller culler(FrameColumns, FrameLines);
    scene.Cull(culler, AheadView(isParallel));
    EXPECT_EQ(std::count(scene.Visible.begin(), scene.Visible.end(), 1), 2);
    EXPECT_TRUE(scene.Visible[wall]);
    EXPECT_TRUE(scene.Visible[before]);
    EXPECT_EQ(scene.Asked, 2);
    EXPECT_EQ(culler.Counts().Inserted, 2u);
    EXPECT_LT(culler.Counts().Tested, 103u);
  }
}

TEST(PartCuller, SeesThroughASlit)
{
  for (const double slit : { 0.3, 0.02, 0.001 })
  {
    SCOPED_TRACE(slit);
    PartScene scene;
    scene.AddBox({ -60, -60, -21 }, { 0.0, 60, -20 });
    scene.AddBox({ slit, -60, -21 }, { 60, 60, -20 });
    const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    const std::uint32_t aside = scene.AddBox({ 9, -1, -32 }, { 11, 1, -30 });
    PartCuller culler(FrameColumns, FrameLines);
    scene.Cull(culler, AheadView(false));
    EXPECT_TRUE(scene.Visible[behind]);
    EXPECT_FALSE(scene.Visible[aside]);
  }
}

TEST(PartCuller, WhatIsNotDrawnNeitherHidesNorCounts)
{
  PartScene scene;
  const std::uint32_t wall = scene.Add(WallAt(-20.0));
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  const std::uint32_t absent = scene.AddBox({ -5, -1, -16 }, { -4, 1, -15 });
  scene.Visible[wall] = 0;
  scene.Visible[absent] = 0;
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 0, 1, 0 }));
  EXPECT_TRUE(scene.Visible[behind]);
  EXPECT_EQ(culler.Counts().Tested, 1u);
  EXPECT_EQ(scene.Asked, 1);
}

TEST(PartCuller, WhatHidesNothingStaysAndHidesNothing)
{
  PartScene scene;
  const std::uint32_t glass = scene.Add(WallAt(-20.0));
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Parts[glass].Hides = false;
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[glass]);
  EXPECT_TRUE(scene.Visible[behind]);
}

TEST(PartCuller, WhatHidesWithAMeshOfNothingStays)
{
  PartScene scene;
  const std::uint32_t part = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Parts[part].Mesh = std::make_shared<vitrine::OccluderMesh>();
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[part]);
}

TEST(PartCuller, BackFacesHideWhereTheyAreDrawn)
{
  for (const bool hasBackFaces : { false, true })
  {
    SCOPED_TRACE(hasBackFaces);
    PartScene scene;
    const std::uint32_t wall =
      scene.Add(WallAt(20.0), glm::rotate(glm::dmat4(1.0), M_PI, glm::dvec3(0, 1, 0)));
    const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    scene.Parts[wall].HasBackFaces = hasBackFaces;
    PartCuller culler(FrameColumns, FrameLines);
    scene.Cull(culler, AheadView(false));
    EXPECT_EQ(scene.Visible[behind], !hasBackFaces);
  }
}

TEST(PartCuller, WhatReachesBeforeTheNearPlaneIsNotHidden)
{
  PartScene scene;
  scene.Add(WallAt(-1.5));
  const std::uint32_t around = scene.AddBox({ -30, -30, -50 }, { 30, 30, 30 });
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[around]);
  EXPECT_FALSE(scene.Visible[behind]);
}

TEST(PartCuller, DropsWhatIsOutside)
{
  PartScene scene;
  scene.AddBox({ 50, -1, -32 }, { 52, 1, -30 });
  scene.AddBox({ -1, -1, 30 }, { 1, 1, 32 });
  scene.AddBox({ -1, -1, -132 }, { 1, 1, -130 });
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 0, 0, 0 }));
  EXPECT_EQ(scene.Asked, 0);
}

TEST(PartCuller, TwoPartsInOnePlaceBothStay)
{
  for (const bool isParallel : { false, true })
  {
    PartScene scene;
    scene.AddBox({ -4, -4, -32 }, { 4, 4, -30 });
    scene.AddBox({ -4, -4, -32 }, { 4, 4, -30 });
    PartCuller culler(FrameColumns, FrameLines);
    scene.Cull(culler, AheadView(isParallel));
    EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 1, 1 }));
  }
}

TEST(PartCuller, WhatHasNoPlaceStays)
{
  PartScene scene;
  scene.Add(WallAt(-20.0));
  for (const float bad : { NotANumber, Infinity, -Infinity })
  {
    scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    scene.Bounds.back().Max.y = bad;
  }
  scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Bounds.back() = Box();
  scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Bounds.back() = Box();
  scene.Visible.back() = 0;
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 1, 1, 1, 1, 1, 0 }));
}

TEST(PartCuller, OfNothing)
{
  PartScene scene;
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_EQ(culler.Counts().Nodes, 0u);

  scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Bounds.back() = Box();
  scene.Cull(culler, AheadView(false));
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 1 }));
}

TEST(PartCuller, DropsNothingInAViewThatIsNone)
{
  for (const double bad : { double{ NotANumber }, double{ Infinity } })
  {
    PartScene scene;
    scene.Add(WallAt(-20.0));
    scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    View view = AheadView(false);
    view.ToClip = glm::dmat4(bad);
    view.Eye = glm::dvec3(bad);
    PartCuller culler(FrameColumns, FrameLines);
    scene.Cull(culler, view);
    EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 1, 1 }));
  }
}

TEST(PartCuller, WhoseMatrixIsNoneStaysAndHidesNothing)
{
  PartScene scene;
  const std::uint32_t wall = scene.Add(WallAt(-20.0));
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Parts[wall].ToWorld = glm::dmat4(NotANumber);
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[wall]);
  EXPECT_TRUE(scene.Visible[behind]);
}

TEST(PartCuller, ForgetsTheFrameBefore)
{
  PartScene scene;
  const std::uint32_t wall = scene.Add(WallAt(-20.0));
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_FALSE(scene.Visible[behind]);
  scene.Visible = { 0, 1 };
  scene.Cull(culler, AheadView(false));
  EXPECT_FALSE(scene.Visible[wall]);
  EXPECT_TRUE(scene.Visible[behind]);
}
