#include "NonFinite.h"
#include "PartScenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace
{

using coverage::AheadView;
using coverage::CullAhead;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::HeapOf;
using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::Triangles;
using coverage::View;
using coverage::ViewOfHeap;
using coverage::WallAt;
using vitrine::Box;
using vitrine::PartCuller;
using vitrine::SampleGrid;

}

TEST(PartCuller, DropsNothingThatIsSeen)
{
  int hidden = 0;
  int culled = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
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
    const vitrine::CullCounts counts = CullAhead(scene, isParallel);
    EXPECT_EQ(std::count(scene.Visible.begin(), scene.Visible.end(), 1), 2);
    EXPECT_TRUE(scene.Visible[wall]);
    EXPECT_TRUE(scene.Visible[before]);
    EXPECT_EQ(scene.Asked(), 2);
    EXPECT_EQ(counts.Inserted, 2u);
    EXPECT_LT(counts.Tested, 103u);
  }
}

TEST(PartCuller, AWallHidesBeforeWhatIsBehindIsLookedAt)
{
  PartScene scene;
  for (int i = 0; i < 1000; ++i)
  {
    const double x = i % 10 - 5, y = i / 10 % 10 - 5, z = -22 - i / 100;
    scene.AddBox({ x, y, z }, { x + 0.3, y + 0.3, z + 0.3 });
  }
  scene.Add(WallAt(-20.0));
  scene.AddBox({ -1, -1, -12 }, { 1, 1, -10 });
  scene.AddBox({ -3, -3, -12 }, { -2, -2, -10 });
  const vitrine::CullCounts counts = CullAhead(scene, false);
  EXPECT_EQ(std::count(scene.Visible.begin(), scene.Visible.end(), 1), 3);
  EXPECT_EQ(counts.Inserted, 3u);
}

// Nodes that reach in front of it hold others that do not.
TEST(PartCuller, ALongWallComesBeforeNodesThatReachInFrontOfIt)
{
  Random random(7);
  PartScene scene;
  scene.Add(WallAt(-30));
  std::uint32_t inFront = 0;
  for (int i = 0; i < 400; ++i)
  {
    const glm::dvec3 low(random.Between(-12, 12), random.Between(-7, 7), random.Between(-45, -29));
    scene.AddBox(low, low + 0.2);
    inFront += low.z + 0.2 > -30.0;
  }
  const vitrine::CullCounts counts = CullAhead(scene, false);
  EXPECT_LE(counts.Inserted, inFront + 1);
}

// Where devices clip it at the borders of the screen, floats round too much.
TEST(PartCuller, WhatReachesVeryFarOffTheScreenHidesNothing)
{
  struct Wall
  {
    SampleGrid Samples;
    double Size;
    bool Hides;
  };
  for (const Wall& of : { Wall{ SampleGrid::AtCentres(1), 1e4, true },
         Wall{ SampleGrid::AtCentres(1), 1e5, false }, // as cuts there tell depths too badly
         Wall{ SampleGrid::InCells(32, 8), 1e3, true },
         Wall{ SampleGrid::InCells(32, 8), 4e3, false } }) // as samples there are close to the side
  {
    Triangles wall;
    wall.AddQuad({ -of.Size, -of.Size, -20 }, { of.Size, -of.Size, -20 }, { of.Size, of.Size, -20 },
      { -of.Size, of.Size, -20 });
    PartScene scene;
    scene.Add(wall);
    const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    PartCuller culler(FrameColumns, FrameLines, of.Samples);
    scene.Cull(culler, AheadView(true));
    EXPECT_EQ(scene.Visible[behind] == 0, of.Hides) << of.Size << ", " << of.Samples.Inset();
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
    CullAhead(scene, false);
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
  const vitrine::CullCounts counts = CullAhead(scene, false);
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 0, 1, 0 }));
  EXPECT_TRUE(scene.Visible[behind]);
  EXPECT_EQ(counts.Tested, 1u);
  EXPECT_EQ(scene.Asked(), 1);
}

TEST(PartCuller, WhatHidesNothingStaysAndHidesNothing)
{
  PartScene scene;
  const std::uint32_t glass = scene.Add(WallAt(-20.0));
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Parts[glass].Hides = false;
  CullAhead(scene, false);
  EXPECT_TRUE(scene.Visible[glass]);
  EXPECT_TRUE(scene.Visible[behind]);
}

TEST(PartCuller, WhatHidesWithAMeshOfNothingStays)
{
  PartScene scene;
  const std::uint32_t part = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.Parts[part].Mesh = std::make_shared<vitrine::OccluderMesh>();
  CullAhead(scene, false);
  EXPECT_TRUE(scene.Visible[part]);
}

TEST(PartCuller, BackFacesHideWhereTheyAreDrawn)
{
  for (const bool hasBackFaces : { false, true })
  {
    SCOPED_TRACE(hasBackFaces);
    PartScene scene;
    const std::uint32_t wall =
      scene.Add(WallAt(20.0), glm::rotate(glm::dmat4(1.0), glm::pi<double>(), glm::dvec3(0, 1, 0)));
    const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
    scene.Parts[wall].HasBackFaces = hasBackFaces;
    CullAhead(scene, false);
    EXPECT_EQ(scene.Visible[behind], !hasBackFaces);
  }
}

TEST(PartCuller, WhatReachesBeforeTheNearPlaneIsNotHidden)
{
  PartScene scene;
  scene.Add(WallAt(-1.5));
  const std::uint32_t around = scene.AddBox({ -33, -31, -50 }, { 30, 32, 30 });
  const std::uint32_t behind = scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false));
  EXPECT_FALSE(scene.Visible[around]) << "its faces are all behind the wall";
  EXPECT_FALSE(scene.Visible[behind]);
  scene.Visible.assign(3, 1);
  scene.Parts[around].IsOfFacesAlone = false;
  scene.Cull(culler, AheadView(false));
  EXPECT_TRUE(scene.Visible[around]);
}

TEST(PartCuller, DropsWhatIsOutside)
{
  PartScene scene;
  scene.AddBox({ 50, -1, -32 }, { 52, 1, -30 });
  scene.AddBox({ -1, -1, 30 }, { 1, 1, 32 });
  scene.AddBox({ -1, -1, -132 }, { 1, 1, -130 });
  CullAhead(scene, false);
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 0, 0, 0 }));
  EXPECT_EQ(scene.Asked(), 0);
}

TEST(PartCuller, TwoPartsInOnePlaceBothStay)
{
  for (const bool isParallel : { false, true })
  {
    PartScene scene;
    scene.AddBox({ -4, -4, -32 }, { 4, 4, -30 });
    scene.AddBox({ -4, -4, -32 }, { 4, 4, -30 });
    CullAhead(scene, isParallel);
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
  CullAhead(scene, false);
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
  CullAhead(scene, false);
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

TEST(PartCuller, AtCentresDropsNothingThatIsSeenThere)
{
  int anywhere = 0;
  int culled = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = HeapOf(100 + random.Below(300), random);
    const View view = ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    const int pixels = 1 << random.Below(3);
    PartCuller culler(view.Columns, view.Lines, vitrine::SampleGrid::AtCentres(pixels));
    scene.Cull(culler, view);
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      if (drawn[i] && !scene.Visible[i])
      {
        ASSERT_FALSE(sight.SeesAtCentre(i, pixels)) << "part " << i;
        ++culled;
      }
    }
    scene.Visible = drawn;
    PartCuller without(view.Columns, view.Lines);
    scene.Cull(without, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      anywhere += drawn[i] && !scene.Visible[i];
    }
  }
  EXPECT_GT(culled, anywhere);
}

TEST(PartCuller, WithoutOcclusionDropsWhatIsOutsideAlone)
{
  PartScene scene;
  scene.Add(WallAt(-20.0));
  scene.AddBox({ -1, -1, -32 }, { 1, 1, -30 });
  scene.AddBox({ 50, -1, -32 }, { 52, 1, -30 });
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(false), false);
  EXPECT_EQ(scene.Visible, (std::vector<std::uint8_t>{ 1, 1, 0 }));
  EXPECT_EQ(scene.Asked(), 0);
  EXPECT_EQ(culler.Counts().Inserted, 0u);
}

// Its far wall's inside, which faces the view too, does not make it farther.
TEST(PartCuller, DropsWhatIsRightBehindTheNearWallOfAShell)
{
  for (const bool isOpen : { false, true })
  {
    SCOPED_TRACE(isOpen);
    PartScene scene;
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -30));
    const std::uint32_t shell = scene.Add(coverage::ShellOf(7.0, 0.2, isOpen), away);
    const std::uint32_t inside = scene.AddBox({ -4, -4, -23.5 }, { 4, 4, -23.3 });
    const std::uint32_t before = scene.AddBox({ -1, -1, -22 }, { 1, 1, -21 });
    CullAhead(scene, true);
    EXPECT_TRUE(scene.Visible[shell]);
    EXPECT_FALSE(scene.Visible[inside]);
    EXPECT_TRUE(scene.Visible[before]);
  }
}

// To put it into the s-buffer takes longer than what it hides is worth.
TEST(PartCuller, MeshesOfMoreFacesThanCellsHideNothing)
{
  for (const bool isDense : { false, true })
  {
    SCOPED_TRACE(isDense);
    PartScene scene;
    Random random(1);
    const int rings = isDense ? 110 : 10;
    const std::uint32_t ball = scene.Add(coverage::BallOf(2 * rings, rings, 1.0, random),
      glm::scale(
        glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -30)), glm::dvec3(5.0))); // 30 by 30 cells
    const std::uint32_t behind = scene.AddBox({ -1, -1, -42 }, { 1, 1, -40 });
    for (int i = 0; i < 400; ++i) // beside the view, so that there is enough to spend
    {
      scene.AddBox({ 100 + i, 0, -30 }, { 100.5 + i, 1, -29 });
    }
    CullAhead(scene, true);
    EXPECT_TRUE(scene.Visible[ball]);
    EXPECT_EQ(scene.Visible[behind], isDense);
  }
}

TEST(PartCuller, DenseMeshesOfFewPointsAreHiddenAsOthersAre)
{
  PartScene scene;
  scene.Add(WallAt(-20.0));
  Random random(1);
  const auto addSpeck = [&](double z)
  {
    return scene.Add(coverage::BallOf(8, 6, 1.0, random),
      glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, z)), glm::dvec3(0.05)));
  };
  const std::uint32_t speck = addSpeck(-32.0);
  const std::uint32_t before = addSpeck(-12.0);
  const vitrine::CullCounts counts = CullAhead(scene, true);
  EXPECT_FALSE(scene.Visible[speck]);
  EXPECT_TRUE(scene.Visible[before]);
  EXPECT_EQ(counts.Inserted, 1u);
}

// The eye is within a closed box, of which it sees the inside.
TEST(PartCuller, DropsWhatIsOutsideOfABoxAroundTheEye)
{
  for (const bool isParallel : { false, true })
  {
    for (const bool hasBackFaces : { false, true })
    {
      SCOPED_TRACE(testing::PrintToString(std::make_pair(isParallel, hasBackFaces)));
      PartScene scene;
      const std::uint32_t around = scene.AddBox({ -40, -30, -35 }, { 40, 30, 9 });
      scene.Parts[around].HasBackFaces = hasBackFaces;
      const std::uint32_t inside = scene.AddBox({ -1, -1, -30 }, { 1, 1, -28 });
      const std::uint32_t outside = scene.AddBox({ -4, -4, -50 }, { 4, 4, -40 });
      CullAhead(scene, isParallel);
      EXPECT_TRUE(scene.Visible[around]);
      EXPECT_TRUE(scene.Visible[inside]);
      EXPECT_EQ(scene.Visible[outside] != 0, !hasBackFaces);
    }
  }
}

// A pixel that is cut into lines lies in one band.
TEST(PartCuller, CutsBandsBetweenPixels)
{
  for (const int pixels : { 1, 2, 3, 7, 75, 270 })
  {
    SCOPED_TRACE(pixels);
    const PartCuller culler(10, 4 * pixels, vitrine::SampleGrid::InCells(1, 4), 4);
    int lines = 0;
    for (std::size_t i = 0; i < culler.BandCount(); ++i)
    {
      EXPECT_GT(culler.Buffer(i).Lines(), 0);
      EXPECT_EQ(culler.Buffer(i).Lines() % 4, 0);
      lines += culler.Buffer(i).Lines();
    }
    EXPECT_EQ(lines, 4 * pixels);
    EXPECT_EQ(culler.LineCount(), lines);
    EXPECT_EQ(culler.BandCount(), static_cast<std::size_t>(std::min(pixels, 4)));
  }
}
