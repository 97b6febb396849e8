// Tests parts whose boxes show and whose faces are all hidden: before the eye, around it, and found hidden at the end
// of a walk.
#include "NonFinite.h"
#include "PartScenes.h"

#include "Core/culling/hidden/HiddenFaces.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace
{

using coverage::AheadView;
using coverage::CullAhead;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::Triangles;
using coverage::View;
using coverage::WallAt;
using vitrine::HiddenFaces;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::PartCuller;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::ScreenMatrix;
using vitrine::ScreenProjection;

/** Columns and lines are those of the frame, and what is nearer than 0.5 hides nothing. */
ScreenProjection PlainView(const glm::vec2& growth = glm::vec2(0.0f))
{
  glm::dmat4 toClip(1.0); // from columns, lines and reversed depth
  toClip[0][0] = 2.0 / FrameColumns;
  toClip[1][1] = 2.0 / FrameLines;
  toClip[2][2] = -2.0;
  toClip[3] = { -1.0, -1.0, 1.0, 1.0 };
  return ScreenProjection(
    toClip, FrameColumns, FrameLines, glm::dvec3(FrameColumns), { 1e-3f, 1e-3f, 1e-6f }, growth);
}

/** What lies right of a slanted edge through the middle is covered: 1 column a line. */
SBuffer CoveredRightOfDiagonal()
{
  SBuffer lines(FrameColumns, FrameLines);
  for (int line = 0; line < FrameLines; ++line)
  {
    lines.Insert(line, { 21.0f + static_cast<float>(line), FrameColumns, 0.5f, 0.5f, 1 });
  }
  return lines;
}

SBuffer CoveredEverywhere()
{
  SBuffer lines(FrameColumns, FrameLines);
  for (int line = 0; line < FrameLines; ++line)
  {
    lines.Insert(line, { 0.0f, FrameColumns, 0.5f, 0.5f, 1 });
  }
  return lines;
}

/** A band along the edge, so far beside it. */
Triangles BandBeside(double distance, double depth)
{
  Triangles band;
  const double left = 22.0 + distance;
  band.AddQuad({ left + 5, 5, depth }, { left + 7, 5, depth }, { left + 47, 45, depth },
    { left + 45, 45, depth });
  return band;
}

bool AreHidden(const Triangles& triangles, const SBuffer& lines, const ScreenProjection& view)
{
  const OccluderMesh mesh = triangles.Mesh();
  MeshProjection projection;
  projection.Project(mesh, view.Of(glm::dmat4(1.0)));
  projection.FindFacings();
  HiddenFaces faces(lines, view);
  return faces.AreAll(projection) && !projection.MayShowBeforeNear();
}

/** A tube along z, from the farther to the nearer end. */
Triangles TubeOf(double radius, double from, double to)
{
  return coverage::GridOf(24, 1,
    [&](double u, double v)
    {
      const double angle = glm::two_pi<double>() * u;
      return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), from + v * (to - from));
    });
}

}

TEST(HiddenFaces, BehindASlantedEdgeAreFoundLineByLine)
{
  const SBuffer lines = CoveredRightOfDiagonal();
  EXPECT_TRUE(AreHidden(BandBeside(0.01, 0.4), lines, PlainView()));
  EXPECT_TRUE(AreHidden(BandBeside(-0.99, 0.4), lines, PlainView())) << "at the foot of a line";
  EXPECT_FALSE(AreHidden(BandBeside(-1.01, 0.4), lines, PlainView()));
  EXPECT_FALSE(AreHidden(BandBeside(0.01, 0.6), lines, PlainView())) << "nearer";
}

// Floats are off by up to 1.7e-4 columns here, and corners that are found in doubles by 0.6e-4.
TEST(HiddenFaces, AreFoundInDoublesWhereFloatsTellNothing)
{
  const SBuffer lines = CoveredEverywhere();
  const auto isHidden = [&](double thickness)
  {
    Triangles sliver;
    sliver.Add({ 20, 10, 0.3 }, { 20, 15, 0.301 }, { 20 + thickness, 12, 0.3 });
    const OccluderMesh mesh = sliver.Mesh();
    const ScreenProjection view = PlainView();
    MeshProjection projection;
    projection.Project(mesh, view.Of(glm::dmat4(1.0)));
    EXPECT_GT(vitrine::FaceBlock(projection, { 0 }, 0).RectangleOf(0).Nearest, 1.0f) << "in floats";
    return HiddenFaces(lines, view).AreAllOfAnyThickness(projection);
  };
  EXPECT_TRUE(isHidden(2.2e-4));
  EXPECT_FALSE(isHidden(5e-5));
}

// In a picture of 100,000 parts such a sliver of a gear of 2,448 faces was drawn before what hides all of the gear.
TEST(HiddenFaces, OfWhichNothingIsKnownShowHoweverManyThereAre)
{
  const SBuffer lines = CoveredEverywhere();
  const ScreenProjection view = PlainView();
  for (const int count : { 1, 8, 1024, 5000 })
  {
    SCOPED_TRACE(count);
    Triangles faces;
    for (int i = 1; i < count; ++i)
    {
      faces.Add({ 10, 5, 0.3 }, { 14, 5, 0.3 }, { 10, 8, 0.3 });
    }
    const auto areHidden = [&]
    {
      const OccluderMesh mesh = faces.Mesh();
      MeshProjection projection;
      projection.Project(mesh, view.Of(glm::dmat4(1.0)));
      return HiddenFaces(lines, view).AreAllOfAnyThickness(projection);
    };
    EXPECT_TRUE(areHidden());
    faces.Add({ 20, 10, 0.3 }, { 20 + 1e-6, 12, 0.3 - 1e-6 }, { 20 - 1e-6, 12, 0.3 });
    EXPECT_FALSE(areHidden());
  }
}

// Corners of what is cut there are no points of the mesh.
TEST(HiddenFaces, ThatReachBeforeTheNearPlaneAreFoundAsFloatsTell)
{
  const SBuffer lines = CoveredEverywhere();
  const ScreenProjection view = PlainView();
  const OccluderMesh tube = TubeOf(20.0, 0.3, 1.2).Mesh();
  MeshProjection projection;
  ASSERT_FALSE(projection.Project(tube, view.Of(glm::dmat4(1.0))));
  ASSERT_GT(projection.Faces().size(), 24u);
  EXPECT_FALSE(HiddenFaces(lines, view).AreAllOfAnyThickness(projection));
}

TEST(HiddenFaces, AreAsFarAsTheirPlane)
{
  const SBuffer lines = CoveredRightOfDiagonal();
  Triangles slanted; // its nearest corners lie beside the screen
  slanted.Add({ 60, 20, 0.1 }, { 150, 15, 0.9 }, { 150, 25, 0.9 });
  EXPECT_TRUE(AreHidden(slanted, lines, PlainView()));
  slanted.Points[0].z = 0.3; // 0.54 at the side of the screen
  EXPECT_FALSE(AreHidden(slanted, lines, PlainView()));
}

TEST(HiddenFaces, ThatSlantAsWhatStandsBeforeThemDoesAreHidden)
{
  for (const SampleGrid& samples : { SampleGrid(), SampleGrid::AtCentres(1) })
  {
    SBuffer lines(FrameColumns, FrameLines, samples);
    for (int line = 0; line < FrameLines; ++line)
    {
      lines.Insert(line, { 0.0f, 60.0f, 0.1f, 0.7f, 1 }); // 0.01 a column
    }
    const auto behind = [](double distance)
    {
      Triangles face;
      face.AddQuad({ 10, 5, 0.2 - distance }, { 50, 5, 0.6 - distance }, { 50, 15, 0.6 - distance },
        { 10, 15, 0.2 - distance });
      return face;
    };
    EXPECT_TRUE(AreHidden(behind(0.02), lines, PlainView()));
    EXPECT_FALSE(AreHidden(behind(-0.02), lines, PlainView()));
    Triangles passing; // it comes to the front at column 46
    passing.Add({ 10, 5, 0.1 }, { 50, 15, 0.61 }, { 10, 15, 0.1 });
    EXPECT_FALSE(AreHidden(passing, lines, PlainView()));
    EXPECT_TRUE(AreHidden(behind(0.002), lines, PlainView()));
    EXPECT_FALSE(AreHidden(behind(-0.002), lines, PlainView()));
  }
}

TEST(HiddenFaces, ThatAreDrawnWiderHaveTheirRectangles)
{
  const SBuffer lines = CoveredRightOfDiagonal();
  EXPECT_FALSE(AreHidden(BandBeside(0.01, 0.4), lines, PlainView(glm::vec2(1e-3f))));
}

TEST(HiddenFaces, AreThoseThatLookAwayToo)
{
  const SBuffer lines = CoveredRightOfDiagonal();
  Triangles two = BandBeside(0.01, 0.4);
  two.Add({ 2, 5, 0.4 }, { 2, 15, 0.4 }, { 10, 5, 0.4 });
  EXPECT_FALSE(AreHidden(two, lines, PlainView()));
}

TEST(HiddenFaces, OfWhichACornerIsNoNumberShow)
{
  const SBuffer lines = CoveredRightOfDiagonal();
  const OccluderMesh mesh = BandBeside(5.0, 0.4).Mesh();
  for (int element = 0; element < 16; ++element)
  {
    ScreenMatrix matrix = PlainView().Of(glm::dmat4(1.0));
    matrix.Matrix[element / 4][element % 4] = NotANumber;
    MeshProjection projection;
    projection.Project(mesh, matrix);
    projection.FindFacings();
    const ScreenProjection view = PlainView();
    HiddenFaces faces(lines, view);
    EXPECT_FALSE(faces.AreAll(projection) && !projection.MayShowBeforeNear()) << element;
  }
}

// The box of the outer one is around the eye as that of the inner one is.
TEST(HiddenFaces, OfATubeAroundTheEyeBehindAnother)
{
  for (const double end :
    { 30.0, -1.5 }) // of the inner one: behind the eye, or before the near plane
  {
    SCOPED_TRACE(end);
    PartScene scene;
    const std::uint32_t outer = scene.Add(TubeOf(20.0, -60.0, 30.0));
    const std::uint32_t inner = scene.Add(TubeOf(8.0, -60.0, end));
    scene.Add(WallAt(-15.0));
    for (int i = 0; i < 40; ++i) // beside the view, so that there is enough to spend
    {
      scene.AddBox({ 200 + i, 0, -30 }, { 200.5 + i, 1, -29 });
    }
    CullAhead(scene, false);
    EXPECT_FALSE(scene.Visible[outer]);
    EXPECT_TRUE(scene.Visible[inner]);
  }
}

TEST(HiddenFaces, DoNotHideWhatIsCutAtTheNearPlaneInTheView)
{
  PartScene scene;
  const std::uint32_t wall = scene.Add(WallAt(-1.2));
  Triangles floor; // from behind the eye to behind the wall
  floor.AddQuad({ -3, -0.2, 20 }, { 3, -0.2, 20 }, { 3, -0.2, -50 }, { -3, -0.2, -50 });
  const std::uint32_t cut = scene.Add(floor);
  Triangles below = floor; // it leaves the view before it reaches the near plane
  for (glm::dvec3& point : below.Points)
  {
    point.y = -5.0;
  }
  const std::uint32_t beside = scene.Add(below);
  CullAhead(scene, false);
  EXPECT_TRUE(scene.Visible[wall]);
  EXPECT_TRUE(scene.Visible[cut]);
  EXPECT_FALSE(scene.Visible[beside]);
}

// All that shows of it lies so near to the eye that it is cut off.
TEST(HiddenFaces, ThatShowWhereDevicesRoundMuchAreNotHidden)
{
  PartScene scene;
  Triangles floor;
  floor.AddQuad({ -1, -0.02, 1001 }, { 1, -0.02, 1001 }, { 1, -0.02, 999.9 }, { -1, -0.02, 999.9 });
  const glm::dmat4 back = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -1000));
  const std::uint32_t cut = scene.Add(floor, back); // sums of coordinates are large
  scene.Add(WallAt(-20.0));
  View view = AheadView(false);
  view.ToClip = glm::perspective(glm::radians(60.0), 16.0 / 9.0, 1e-3, 100.0);
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, view);
  EXPECT_TRUE(scene.Visible[cut]);
}

// What hides its upper half is farther than its nearest corner.
TEST(HiddenFaces, AreLookedForAgainOnceAllStandsInTheBuffer)
{
  for (const bool isOfFacesAlone : { true, false })
  {
    PartScene scene;
    Triangles slanted;
    slanted.AddQuad({ -2, -2, -20 }, { 2, -2, -20 }, { 1, 2, -30 }, { -2, 2, -30 });
    const std::uint32_t hidden = scene.Add(slanted);
    scene.Parts[hidden].IsOfFacesAlone = isOfFacesAlone;
    Triangles lower, upper;
    lower.AddQuad({ -8, -8, -19.5 }, { 8, -8, -19.5 }, { 8, 0.5, -19.5 }, { -8, 0.5, -19.5 });
    upper.AddQuad({ -8, -0.5, -23.5 }, { 8, -0.5, -23.5 }, { 8, 8, -23.5 }, { -8, 8, -23.5 });
    const std::uint32_t first = scene.Add(lower), last = scene.Add(upper);
    const vitrine::CullCounts counts = CullAhead(scene, true);
    EXPECT_EQ(scene.Visible[hidden], !isOfFacesAlone);
    EXPECT_TRUE(scene.Visible[first]);
    EXPECT_TRUE(scene.Visible[last]);
    EXPECT_EQ(counts.Inserted, 3u) << "it was shown when it came";
  }
}

TEST(HiddenFaces, OfPartsThatAreSeenAreNone)
{
  int culled = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = coverage::HeapOf(150, random);
    for (int i = 0; i < 12; ++i) // around the eye, or near it
    {
      const double radius = random.Between(0.5, 12.0);
      scene.Add(TubeOf(radius, -radius * random.Between(1, 3), radius * random.Between(0.0, 3)),
        glm::rotate(glm::translate(glm::dmat4(1.0), random.Point(-2, 2)), random.Between(0, 6),
          random.Point(-1, 1) + glm::dvec3(1.01)));
    }
    View view = coverage::ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    PartCuller culler(view.Columns, view.Lines);
    scene.Cull(culler, view);
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      if (drawn[i] && !scene.Visible[i])
      {
        ASSERT_FALSE(sight.Sees(i, 150, random)) << "part " << i;
        ++culled;
      }
    }
  }
  EXPECT_GT(culled, 800);
}
