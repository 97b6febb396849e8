// Parts that were found hidden where they are, and are drawn beside that.
#include "PartScenes.h"
#include "SnappedFaces.h"

#include "Core/culling/walk/HiddenVerifier.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace
{

using coverage::AheadView;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::PartScene;
using coverage::Random;
using coverage::ScreenCorners;
using coverage::Triangles;
using coverage::View;
using vitrine::BandTools;
using vitrine::HiddenVerifier;
using vitrine::SampleGrid;
using vitrine::SBuffer;
using vitrine::ScreenProjection;

/** An s-buffer in which something hides what is farther than a depth, up to a line. */
BandTools WallToolsOf(float depth, int lines = FrameLines, const SampleGrid& samples = SampleGrid())
{
  BandTools tools{ SBuffer(FrameColumns, FrameLines, samples) };
  for (int line = 0; line < lines; ++line)
  {
    tools.Lines.Insert(line, { 0.0f, float(FrameColumns), depth, depth, 1 });
  }
  return tools;
}

bool StaysHidden(PartScene& scene, std::uint32_t part, BandTools& tools, const View& view)
{
  if (tools.States.Count() == 0)
  {
    tools.States.Begin(scene.Visible);
  }
  const ScreenProjection projection = view.Projection(scene.Reach);
  std::vector<std::uint8_t> hidden(1, 1);
  HiddenVerifier(tools, scene, projection).Verify({ { part, scene.Bounds[part] } }, 0, hidden);
  return hidden[0] != 0;
}

double NearestOf(const PartScene& scene, std::uint32_t part, const View& view)
{
  double nearest = 0.0;
  for (const glm::dvec3& corner : scene.Parts[part].Corners)
  {
    nearest = std::max(nearest, view.OnScreen(corner).z);
  }
  return nearest;
}

View SnappingView(bool isParallel, double pixels)
{
  View view = AheadView(isParallel);
  view.Snapping = { static_cast<float>(pixels), static_cast<float>(pixels), 0x1p-21f };
  return view;
}

/** Of a face, what a device may have of it at its nearest, that moves corners by half of a step. */
double NearestDrawn(
  const glm::dvec3* corners, const View& view, double off, double snapped, Random& random)
{
  ScreenCorners drawn, covering;
  for (int i = 0; i < 3; ++i)
  {
    drawn[i] = coverage::Moved(glm::dvec3(view.OnScreen(corners[i])), off, 0x1p-23, random);
    covering[i] = coverage::Moved(drawn[i], 0.5 * snapped, 0.0, random);
  }
  double nearest = 0.0;
  for (const glm::dvec3& place : covering)
  {
    nearest = std::max(nearest, coverage::DepthAt(drawn, place));
  }
  return nearest;
}

/**
 * Returns a transform to a place ahead and nearly along the view from x = y = 0, so that planes there are seen nearly
 * edge-on.
 */
glm::dmat4 NearlyAlong(bool isParallel, Random& random)
{
  const glm::dvec3 place(random.Between(-8, 8), random.Between(-4, 4), random.Between(-60, -15));
  const auto alittle = [&]
  { return std::pow(10.0, random.Between(-5, -0.5)) * (random.OneIn(2) ? 1.0 : -1.0); };
  const glm::dmat4 along = isParallel
    ? glm::translate(glm::dmat4(1.0), place)
    : glm::inverse(glm::lookAt(place, 2.0 * place, glm::dvec3(0.0, 1.0, 0.0)));
  return glm::rotate(
    glm::rotate(along, alittle(), { 0.0, 1.0, 0.0 }), alittle(), { 1.0, 0.0, 0.0 });
}

}

TEST(HiddenVerifier, AsksNoFacesOfWhatLiesFarBehind)
{
  PartScene scene;
  const std::uint32_t box = scene.AddBox({ -1, -2, -32 }, { 2, 1, -30 });
  const View view = SnappingView(false, 1.0 / 256.0);
  BandTools wall = WallToolsOf(static_cast<float>(NearestOf(scene, box, view)) + 0.01f);
  EXPECT_TRUE(StaysHidden(scene, box, wall, view));
  EXPECT_EQ(scene.Asked(), 0);
  BandTools nothing = WallToolsOf(1.0f, 10);
  EXPECT_FALSE(StaysHidden(scene, box, nothing, view));
}

TEST(HiddenVerifier, AsksNothingOfWhatIsKnownFaceByFace)
{
  PartScene scene;
  const std::uint32_t box = scene.AddBox({ -1, -2, -32 }, { 2, 1, -30 });
  const View view = SnappingView(false, 1.0 / 256.0);
  BandTools nothing = WallToolsOf(1.0f, 10);
  nothing.States.Begin(scene.Visible);
  nothing.States.Set(box, vitrine::PartStates::AreFacesHidden);
  EXPECT_TRUE(StaysHidden(scene, box, nothing, view));
  nothing.States.Begin(scene.Visible);
  EXPECT_FALSE(StaysHidden(scene, box, nothing, view)) << "in the next frame it is not known";
}

// Whatever is drawn of a part that stays hidden is hidden, snapped and rounded as it may be.
TEST(HiddenVerifier, ShowsWhatMayBeDrawnNearerThanItIs)
{
  Random random(31);
  const double snapped = 1.0 / 64.0;
  int hidden = 0, shown = 0, nearer = 0;
  for (int round = 0; round < 2000; ++round)
  {
    PartScene scene;
    const bool isParallel = random.OneIn(2);
    const std::uint32_t box = scene.Add(
      coverage::BoxBetween({ 0, 0, -4 }, { 0.5, 0.7, 4 }), NearlyAlong(isParallel, random));
    const View view = SnappingView(isParallel, snapped);
    const double nearest = NearestOf(scene, box, view);
    const double before = std::pow(10.0, random.Between(-6, -1));
    const double wall = std::nextafter(static_cast<float>(nearest + before), 1.0f);
    BandTools tools = WallToolsOf(static_cast<float>(wall));
    const bool isHidden = StaysHidden(scene, box, tools, view);
    ++(isHidden ? hidden : shown);
    const double off = 0x1p-24 * FrameColumns;
    const std::vector<glm::dvec3>& corners = scene.Parts[box].Corners;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const double drawn = NearestDrawn(&corners[i], view, off, snapped, random);
      nearer += drawn > nearest + 1e-6;
      ASSERT_FALSE(isHidden && drawn > wall)
        << "seed 31, round " << round << ", drawn at " << drawn - nearest << " of " << before;
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(shown, 100);
  EXPECT_GT(nearer, 100);
}

TEST(HiddenVerifier, AsksThinFacesOneByOne)
{
  // Depths of a sliver differ by less than those of what stands before it.
  PartScene scene;
  const auto addSlivers = [&](double left, double top, int count)
  {
    Triangles slivers;
    for (int i = 0; i < count; ++i)
    {
      slivers.Add({ left, -3, -31 }, { left, top, -31 }, { left + 1e-5, top, -31 });
    }
    return scene.Add(slivers);
  };
  const View view = SnappingView(false, 1.0 / 64.0); // slivers are 1e-5 columns wide
  const double centre = 1.657; // of pixels, two and a half columns from the middle of the screen
  const std::uint32_t high = addSlivers(centre - 3e-6, 10, 1), low = addSlivers(4, 1, 1);
  const std::uint32_t many = addSlivers(-centre - 3e-6, 10, 200),
                      between = addSlivers(-2.65, 10, 1);
  const std::uint32_t thousands = addSlivers(-centre - 3e-6, 10, 1100);
  for (const bool isAtCentres : { false, true })
  {
    const SampleGrid samples = isAtCentres ? SampleGrid::AtCentres(1) : SampleGrid();
    BandTools half = WallToolsOf(0.9f, 31, samples); // up to where y is about 2
    EXPECT_FALSE(StaysHidden(scene, high, half, view));
    EXPECT_FALSE(StaysHidden(scene, many, half, view));
    EXPECT_FALSE(StaysHidden(scene, thousands, half, view));
    EXPECT_EQ(StaysHidden(scene, between, half, view), isAtCentres) << "slivers between samples";
    EXPECT_EQ(StaysHidden(scene, low, half, view), isAtCentres) << "likewise";
  }
}

TEST(HiddenVerifier, AsksThinFacesBehindWhatHidesTheirBox)
{
  const View view = SnappingView(false, 1.0 / 64.0);
  const double centre = 1.657; // of pixels, as above
  for (const bool isAtCentres : { false, true })
  {
    BandTools wall =
      WallToolsOf(0.9f, FrameLines, isAtCentres ? SampleGrid::AtCentres(1) : SampleGrid());
    const auto staysHidden = [&](double left, double aside)
    {
      PartScene scene; // of a triangle that reaches away from the eye
      Triangles away;
      away.Add({ left, -3, -31 }, { 1.2 * left + aside, -3.6, -37.2 }, { left, 1, -31 });
      return StaysHidden(scene, scene.Add(away), wall, view);
    };
    EXPECT_FALSE(staysHidden(centre, 2e-5));
    EXPECT_EQ(staysHidden(2.65, 2e-5), isAtCentres) << "between samples";
    EXPECT_TRUE(staysHidden(centre, 0.5)) << "it is not thin";
  }
}

// Places in the world are the same, so what a device draws is, too, but for what is rounded.
TEST(HiddenVerifier, TellsTheSameOfPartsInWhateverUnits)
{
  Random random(32);
  const View view = SnappingView(false, 1.0 / 4096.0); // less than floats are off by
  int hidden = 0, shown = 0, differ = 0, asked = 0, askedDiffer = 0;
  for (int round = 0; round < 300; ++round)
  {
    const glm::dmat4 place = NearlyAlong(false, random);
    const double before = std::pow(10.0, random.Between(-5, -1));
    std::vector<bool> found, askFaces;
    for (const double scale : { 1.0, 1e-3, 1e3, -1.0 })
    {
      PartScene scene;
      const glm::dvec3 low(0, 0, -4), high(0.5, 0.7, 4);
      const std::uint32_t box = scene.Add(coverage::BoxBetween(glm::min(low / scale, high / scale),
                                            glm::max(low / scale, high / scale)),
        glm::scale(place, glm::dvec3(scale)));
      BandTools wall = WallToolsOf(static_cast<float>(NearestOf(scene, box, view) + before));
      scene.Reach = 100.0;
      found.push_back(StaysHidden(scene, box, wall, view));
      askFaces.push_back(scene.Asked() > 0);
    }
    differ += found != std::vector<bool>(4, found[0]);
    askedDiffer += askFaces != std::vector<bool>(4, askFaces[0]);
    asked += askFaces[0];
    ++(found[0] ? hidden : shown);
  }
  EXPECT_GT(hidden, 20);
  EXPECT_GT(shown, 20);
  EXPECT_LT(differ, 6); // of those at the thickness that tells
  EXPECT_GT(asked, 20);
  EXPECT_LT(asked, 280);
  EXPECT_LT(askedDiffer, 6);
}

TEST(HiddenVerifier, TellsNoMoreOfPartsThatAreFlattened)
{
  Random random(33);
  int hidden = 0;
  for (int round = 0; round < 300; ++round)
  {
    const bool isParallel = random.OneIn(2);
    const View view = SnappingView(isParallel, 1.0 / 64.0);
    const glm::dmat4 place = NearlyAlong(isParallel, random);
    const double before = std::pow(10.0, random.Between(-5, -1));
    const auto isHiddenOf = [&](const glm::dvec3& scale)
    {
      PartScene scene;
      const std::uint32_t box = scene.Add(
        coverage::BoxBetween(glm::dvec3(0, 0, -4) / scale, glm::dvec3(0.5, 0.7, 4) / scale),
        glm::scale(place, scale));
      BandTools wall = WallToolsOf(static_cast<float>(NearestOf(scene, box, view) + before));
      scene.Reach = 100.0;
      return StaysHidden(scene, box, wall, view);
    };
    const bool isHidden = isHiddenOf(glm::dvec3(1.0));
    hidden += isHidden;
    for (const double flat : { 1e-2, 1e-5 })
    {
      ASSERT_TRUE(isHidden || !isHiddenOf({ 1.0, 1.0, flat })) << "seed 33, round " << round;
      ASSERT_TRUE(isHidden || !isHiddenOf({ flat, 1.0, 1.0 })) << "seed 33, round " << round;
    }
  }
  EXPECT_GT(hidden, 20);
}

TEST(HiddenVerifier, AsksAllFacesWhereTheBoxShows)
{
  // A slope whose box looks out above the wall, and no face of it.
  PartScene scene;
  Triangles slope;
  slope.AddQuad({ -3, 0.4, -30 }, { 3, 0.4, -30 }, { 3, 1, -60 }, { -3, 1, -60 });
  const std::uint32_t part = scene.Add(slope);
  const View view = SnappingView(false, 1.0 / 64.0);
  BandTools wall = WallToolsOf(0.9f, 28);
  EXPECT_TRUE(StaysHidden(scene, part, wall, view));
  EXPECT_EQ(scene.Asked(), 1);
  scene.Parts[part].IsOfFacesAlone = false;
  EXPECT_FALSE(StaysHidden(scene, part, wall, view)) << "more is drawn than faces";
  scene.Parts[part].IsOfFacesAlone = true;
  scene.Parts[part].Hides = false;
  EXPECT_FALSE(StaysHidden(scene, part, wall, view)) << "its faces are not known";
}

// What is translucent may be drawn at the centre of a pixel by the depth of any of its samples.
TEST(HiddenVerifier, AsksForWholePixelsOfWhatIsDrawnApart)
{
  PartScene scene;
  const std::uint32_t part = scene.AddBox({ -1, -2, -32 }, { 2, 1, -30 });
  const View view = SnappingView(false, 1.0 / 256.0);
  double top = 0.0;
  for (const glm::dvec3& corner : scene.Parts[part].Corners)
  {
    top = std::max(top, view.OnScreen(corner).y);
  }
  const float depth = static_cast<float>(NearestOf(scene, part, view)) + 0.01f;
  for (const SampleGrid& samples : { SampleGrid(), SampleGrid::InCells(1, 4) })
  {
    const int lines = static_cast<int>(std::ceil(top));
    BandTools narrow = WallToolsOf(depth, lines + samples.LinesPerPixel() - 1, samples);
    BandTools wide = WallToolsOf(depth, lines + samples.LinesPerPixel(), samples);
    scene.Parts[part].IsDrawnApart = false;
    scene.Parts[part].Lines.clear();
    EXPECT_TRUE(StaysHidden(scene, part, narrow, view));
    scene.Parts[part].IsDrawnApart = true;
    EXPECT_FALSE(StaysHidden(scene, part, narrow, view)) << "less than a pixel around it hides it";
    EXPECT_TRUE(StaysHidden(scene, part, wide, view));
    narrow.States.Set(part, vitrine::PartStates::AreFacesHidden);
    EXPECT_FALSE(StaysHidden(scene, part, narrow, view)) << "they are so at their own places";
    scene.Parts[part].Lines = { { { 0, 0, -30 }, { 1, 0, -32 } } };
    EXPECT_FALSE(StaysHidden(scene, part, wide, view)) << "lines reach farther";
  }
}

// Of round parts some face is seen nearly from its edge.
TEST(HiddenVerifier, AsksThinFacesOneByOneOfWhatIsDrawnApart)
{
  Random random(5);
  const Triangles pipe = coverage::GridOf(48, 1,
    [](double u, double v)
    {
      const double angle = glm::two_pi<double>() * u;
      return glm::dvec3(0.6 * std::cos(angle), 0.6 * std::sin(angle), 2.0 * v - 1.0);
    });
  const View view = SnappingView(false, 0.6 / 256.0);
  BandTools whole = WallToolsOf(1.0f, FrameLines, SampleGrid::InCells(1, 4));
  BandTools half = WallToolsOf(1.0f, FrameLines / 2, SampleGrid::InCells(1, 4));
  int behindWhole = 0, behindHalf = 0;
  for (int i = 0; i < 400; ++i)
  {
    PartScene scene;
    const glm::dvec3 place(
      random.Between(-4, 4), random.Between(-10, 10), random.Between(-40, -20));
    const std::uint32_t part = scene.Add(pipe,
      glm::rotate(glm::translate(glm::dmat4(1.0), place), random.Between(0, 6.28),
        glm::normalize(random.Point(-1, 1))));
    scene.Parts[part].IsDrawnApart = true;
    behindWhole += StaysHidden(scene, part, whole, view);
    behindHalf += StaysHidden(scene, part, half, view);
  }
  EXPECT_GT(behindWhole, 390);
  EXPECT_GT(behindHalf, 100);
  EXPECT_LT(behindHalf, 300);
}

TEST(HiddenVerifier, ShowsThinFacesOfWhatIsDrawnApart)
{
  PartScene scene;
  Triangles edgeOn;
  edgeOn.Add({ 0, -3, -31 }, { 0, 3, -31 }, { 0, 0, -33 });
  const std::uint32_t part = scene.Add(edgeOn);
  scene.Parts[part].IsDrawnApart = true;
  const View view = SnappingView(false, 1.0 / 64.0);
  const float nearest = static_cast<float>(NearestOf(scene, part, view));
  BandTools close = WallToolsOf(nearest + 1e-3f, FrameLines, SampleGrid::InCells(1, 4));
  EXPECT_FALSE(StaysHidden(scene, part, close, view)) << "its depth may be any";
}

TEST(HiddenVerifier, AsksForLines)
{
  PartScene scene;
  const std::uint32_t part = scene.AddBox({ -1, -2, -32 }, { 2, 1, -30 });
  const View view = SnappingView(false, 1.0 / 64.0);
  BandTools wall = WallToolsOf(static_cast<float>(NearestOf(scene, part, view)) + 0.01f);
  scene.Parts[part].Lines = { { { 0, 0, -30 }, { 1, 0, -32 } } };
  EXPECT_TRUE(StaysHidden(scene, part, wall, view));
  scene.Parts[part].Lines.push_back({ { 0, 0, -30 }, { 0, 0, -32 } });
  EXPECT_FALSE(StaysHidden(scene, part, wall, view)) << "seen from its end";
}
