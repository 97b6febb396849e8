// Convex faces in an s-buffer at the screen's own resolution, and what is asked of them and of boxes.

#include "BoxPlaces.h"
#include "FaceScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using namespace faces;
using vitrine::Box;
using vitrine::HidesBox;
using vitrine::HidesFace;
using vitrine::InsertFace;
using vitrine::NoNeighbour;
using vitrine::ScreenProjection;

ConvexFace FaceNumber5(const Polygon& polygon)
{
  return { polygon.data(), polygon.size(), 5 };
}

SBuffer BufferOfFaces(const std::vector<Polygon>& polygons)
{
  SBuffer buffer(Columns, Lines, {}, 1u << 14);
  for (const Polygon& polygon : polygons)
  {
    InsertFace(buffer, FaceNumber5(polygon));
  }
  return buffer;
}

/** Of 0 to 8 in x and 0 to 8 in y, seen from z = 1 towards -z; depth is 1 there and 0 at z = -1. */
ScreenProjection StraightView()
{
  return ScreenProjection(glm::ortho(0.0, 8.0, 0.0, 8.0, -1.0, 1.0), 8.0, 8.0, glm::dvec3(8.0), {});
}

const glm::dvec3 AlongZ(0.0, 0.0, -1.0);

}

TEST(FaceScan, CoversOfAMiddleWhatLiesBetweenItsSides)
{
  const Polygon triangle{ At(2, 0, 0.25), At(10, 0, 0.75), At(2, 4, 0.25) };
  const SBuffer buffer = BufferOfFaces({ triangle });
  for (int line = 0; line < 4; ++line)
  {
    SCOPED_TRACE(line);
    const std::vector<Span> spans = buffer.SpansOf(line);
    ASSERT_FALSE(spans.empty());
    EXPECT_EQ(spans.front().Left, 2.0f);
    EXPECT_EQ(spans.front().Depth, 0.25f);
    EXPECT_EQ(spans.front().Face, 5u);
    const float right = 10.0f - 2.0f * (static_cast<float>(line) + 0.5f);
    EXPECT_EQ(spans.back().Right, right);
    EXPECT_FLOAT_EQ(spans.back().DepthAt(right), 0.25f + 0.5f * (right - 2.0f) / 8.0f);
  }
  EXPECT_TRUE(buffer.SpansOf(4).empty());
}

TEST(FaceScan, GoesAroundEitherWay)
{
  const Polygon there{ At(1, 1, 0.1), At(20, 3, 0.2), At(9, 11, 0.3) };
  const Polygon back(there.rbegin(), there.rend());
  for (int line = 0; line < Lines; ++line)
  {
    const vitrine::Segment a =
      vitrine::FaceScan(FaceNumber5(there), Columns, Lines).At(line).Covered;
    const vitrine::Segment b =
      vitrine::FaceScan(FaceNumber5(back), Columns, Lines).At(line).Covered;
    EXPECT_EQ(a.Left, b.Left) << line;
    EXPECT_EQ(a.Right, b.Right) << line;
    EXPECT_EQ(a.LeftDepth, b.LeftDepth) << line;
    EXPECT_EQ(a.RightDepth, b.RightDepth) << line;
  }
}

TEST(FaceScan, TellsWhichFacesAreAcrossTheSidesThatItEndsAt)
{
  const Polygon quad{ At(2, 0, 0), At(8, 0, 0), At(9, 6, 0), At(1, 6, 0) };
  const std::uint32_t across[] = { 10, 11, 12, 13 }; // bottom, right, top, left
  const ConvexFace face{ quad.data(), quad.size(), 5, across };
  EXPECT_EQ(vitrine::FaceScan(face, Columns, Lines).At(3).LeftNeighbour, 13u);
  EXPECT_EQ(vitrine::FaceScan(face, Columns, Lines).At(3).RightNeighbour, 11u);
  EXPECT_EQ(vitrine::FaceScan(FaceNumber5(quad), Columns, Lines).At(3).LeftNeighbour, NoNeighbour);
  EXPECT_EQ(vitrine::FaceScan(face, Columns, Lines).At(7).LeftNeighbour, NoNeighbour) << "above it";
}

TEST(FaceScan, LeavesNoGapBetweenFacesThatShareASide)
{
  Random random(3);
  for (int i = 0; i < 200; ++i)
  {
    SCOPED_TRACE(i);
    const auto corner = [&](double left, double right, double bottom, double top)
    { return At(random.Between(left, right), random.Between(bottom, top), random.Between(0, 1)); };
    const ScreenPoint low = corner(15, 25, -2, 3), high = corner(15, 25, 9, 14);
    const Polygon left{ low, high, corner(-5, 5, -2, 14) };
    const Polygon right{ high, low, corner(35, 45, -2, 14) };
    for (int line = 0; line < Lines; ++line)
    {
      const vitrine::Segment a =
        vitrine::FaceScan(FaceNumber5(left), Columns, Lines).At(line).Covered;
      const vitrine::Segment b =
        vitrine::FaceScan(FaceNumber5(right), Columns, Lines).At(line).Covered;
      const double middle = line + 0.5;
      if (low.Line <= middle && middle < high.Line)
      {
        EXPECT_EQ(a.Right, b.Left) << line;
        EXPECT_EQ(a.RightDepth, b.LeftDepth) << line;
      }
    }
  }
}

TEST(FaceScan, OfWhatIsNoFaceCoversNothingAndIsNotHidden)
{
  SBuffer buffer(Columns, Lines, {}, 1u << 14);
  const Polygon good{ At(1, 1, 0.5), At(30, 1, 0.5), At(1, 10, 0.5) };
  for (const float bad : { NotANumber, Infinity, -Infinity })
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      for (float ScreenPoint::*part :
        { &ScreenPoint::Column, &ScreenPoint::Line, &ScreenPoint::Depth })
      {
        Polygon polygon = good;
        polygon[corner].*part = bad;
        InsertFace(buffer, FaceNumber5(polygon));
        EXPECT_FALSE(
          HidesFace(BufferOfFaces({ LevelFace(-9, 99, -9, 99, 0.9) }), FaceNumber5(polygon), 0.0f));
      }
    }
  }
  InsertFace(buffer, FaceNumber5({}));
  InsertFace(buffer, FaceNumber5({ At(1, 1, 0.5), At(30, 10, 0.5) }));
  InsertFace(buffer, FaceNumber5({ At(1, 1, 0.5), At(30, 10, 0.5), At(1, 1, 0.5) }));
  InsertFace(buffer, FaceNumber5(LevelFace(3, 9, 4.6, 5.4, 0.5))); // between two middles
  InsertFace(buffer, FaceNumber5(LevelFace(3, 9, 4.5, 4.5, 0.5)));
  for (int line = 0; line < Lines; ++line)
  {
    EXPECT_TRUE(buffer.SpansOf(line).empty()) << line;
  }
}

TEST(FaceScan, OfHugeFacesEndsWithTheScreen)
{
  const SBuffer buffer = BufferOfFaces({ LevelFace(-1e30, 1e30, -1e30, 1e30, 0.5) });
  for (int line = 0; line < Lines; ++line)
  {
    ASSERT_FALSE(buffer.SpansOf(line).empty()) << line;
    EXPECT_EQ(buffer.SpansOf(line).front().Left, 0.0f);
    EXPECT_EQ(buffer.SpansOf(line).back().Right, float(Columns));
  }
}

TEST(FaceScan, OfFacesThatReachFarBeyondTheScreenHasTheDepthThere)
{
  // 0.25 at column 0 and 0.65 at column 40.
  const Polygon wide = UprightFace(-1e6, 1e6, 0, 2, 0.25 - 1e4, 0.25 + 1e4);
  const std::uint32_t across[] = { 10, 11, 12, 13 };
  const vitrine::FaceSegment segment =
    vitrine::FaceScan({ wide.data(), wide.size(), 5, across }, Columns, Lines).At(1);
  EXPECT_EQ(segment.Covered.Left, 0.0f);
  EXPECT_EQ(segment.Covered.Right, float(Columns));
  EXPECT_NEAR(segment.Covered.LeftDepth, 0.25, 1e-3); // the corners' depths are floats
  EXPECT_NEAR(segment.Covered.RightDepth - segment.Covered.LeftDepth, 0.4, 1e-6);
  EXPECT_EQ(segment.LeftNeighbour, NoNeighbour) << "no neighbour begins there";
  EXPECT_EQ(segment.RightNeighbour, NoNeighbour);
}

TEST(FaceScan, InsertsWhatIsSeenOfFacesAtAllMiddles)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const FaceScene& scene : { FacesApart(25, random), FacesThatCross(25, random) })
    {
      const SBuffer buffer = BufferOfFaces(scene.Polygons);
      const Differences differences = Compare(buffer, scene.Polygons);
      EXPECT_GT(differences.Places, 200);
      EXPECT_EQ(differences.Nearer, 0);
      EXPECT_EQ(differences.Uncovered, 0);
      EXPECT_LE(
        differences.Farther, differences.Places / 100); // where pieces beside a crossing are short
    }
  }
}

TEST(HidesFace, WhatIsBehindAllAlongItsLines)
{
  const SBuffer buffer =
    BufferOfFaces({ LevelFace(4, 20, 2, 8, 0.5), LevelFace(20, 30, 2, 8, 0.7) });
  EXPECT_TRUE(HidesFace(buffer, FaceNumber5(LevelFace(4, 30, 2, 8, 0.4)), 0.0f));
  EXPECT_TRUE(HidesFace(buffer, FaceNumber5(UprightFace(10, 30, 3, 7, 0.39, 0.59)), 0.0f));
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(UprightFace(10, 30, 3, 7, 0.59, 0.39)), 0.0f));
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(3.9, 30, 2, 8, 0.4)), 0.0f));
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(4, 30.1, 2, 8, 0.4)), 0.0f));
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(5, 9, 2, 9, 0.4)), 0.0f)) << "a line more";
  EXPECT_TRUE(HidesFace(buffer, FaceNumber5(LevelFace(5, 9, 2, 8.4, 0.4)), 0.0f))
    << "but not its middle";
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(5, 9, 3, 6, 0.5)), 0.0f))
    << "equal is visible";
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(5, 9, 3, 6, 0.45)), 0.06f))
    << "within the margin";
  EXPECT_TRUE(HidesFace(buffer, FaceNumber5(LevelFace(-9, -1, 3, 6, 0.9)), 0.0f))
    << "beside the screen";
  EXPECT_FALSE(HidesFace(buffer, FaceNumber5(LevelFace(30.5, 31, 3, 6, 0.1)), 0.0f))
    << "beside the spans";
}

TEST(HidesFace, SaysOfRandomFacesWhatBruteForceDoes)
{
  int hidden = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FaceScene scene = FacesApart(40, random);
    const SBuffer buffer = BufferOfFaces(scene.Polygons);
    for (int i = 0; i < 30; ++i)
    {
      const double base = random.Between(0.2, 0.5);
      const Polygon asked =
        RandomPolygon(random, [&](double x, double) { return base + 0.002 * x; });
      double least = 2.0; // by what the nearest is nearer than the face
      for (int line = 0; line < Lines; ++line)
      {
        std::vector<Stretch> stretches = StretchesOf(scene.Polygons, line);
        const Stretch own = StretchOf(asked, line + 0.5);
        std::vector<Stretch> withOwn = stretches;
        withOwn.push_back(own);
        for (const double x : PlacesBetween(withOwn, Columns))
        {
          if (own.Left < x && x < own.Right)
          {
            least = std::min(least, NearestAt(stretches, x).DepthAt(x) - own.DepthAt(x));
          }
        }
      }
      if (HidesFace(buffer, FaceNumber5(asked), 0.0f))
      {
        EXPECT_GT(least, -1e-5) << i;
        hidden += least < 2.0;
      }
      EXPECT_FALSE(HidesFace(buffer, FaceNumber5(asked), 0.0f) && least < -1e-5) << i;
    }
  }
  EXPECT_GT(hidden, 20);
}

TEST(HidesBox, ByTheFacesThatLookTowardsTheEye)
{
  const Box box{ { 2, 2, -0.5f }, { 5, 6, 0.0f } }; // its front at a depth of 0.5
  const auto bufferWith = [](const Polygon& polygon)
  {
    SBuffer buffer(8, 8, {}, 1024);
    InsertFace(buffer, FaceNumber5(polygon));
    return buffer;
  };
  const auto hides = [&](const Polygon& polygon)
  { return HidesBox(bufferWith(polygon), StraightView(), box, AlongZ, true, 0.0f); };
  EXPECT_TRUE(hides(LevelFace(2, 5, 2, 6, 0.6)));
  EXPECT_FALSE(hides(LevelFace(2, 5, 2, 6, 0.4))) << "before its back alone";
  EXPECT_FALSE(hides(LevelFace(2, 4.9, 2, 6, 0.6)));
  EXPECT_FALSE(hides(LevelFace(2, 5, 2, 5, 0.6)));
}

TEST(HidesBox, BehindTheFacesOfALargerOneThatItsRectangleLooksPast)
{
  const coverage::Triangles outer = coverage::BoxBetween(glm::dvec3(-1.0), glm::dvec3(1.0));
  const Box inner{ glm::vec3(-0.9f), glm::vec3(0.9f) };
  for (const double side : { -1.0, 1.0 })
  {
    const glm::dvec3 eye = side * glm::dvec3(5, 4, 6);
    const ScreenProjection view(glm::perspective(0.6, 1.0, 0.5, 20.0) *
        glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0)),
      64, 64, glm::dvec3(1.0), {});
    const std::size_t towardsX = side > 0.0 ? 30 : 24; // corners of the face that looks to the eye
    for (const bool isWhole : { true, false })
    {
      SBuffer buffer(64, 64, {}, 1u << 14);
      for (std::size_t i = 0; i < outer.Corners.size(); i += 3)
      {
        Polygon polygon;
        for (std::size_t j = i; j < i + 3; ++j)
        {
          const glm::dvec4 place = view.ToScreen(outer.Points[outer.Corners[j]]);
          polygon.push_back(At(place.x / place.w, place.y / place.w, place.z / place.w));
        }
        if (isWhole || i < towardsX || i >= towardsX + 6)
        {
          InsertFace(buffer, FaceNumber5(polygon));
        }
      }
      vitrine::ScreenRectangle rectangle;
      ASSERT_EQ(coverage::PlaceOf(view, inner, rectangle), coverage::Place::Before);
      EXPECT_FALSE(buffer.Hides(rectangle));
      EXPECT_EQ(HidesBox(buffer, view, inner, eye, false, 0.0f), isWhole) << side;
    }
  }
}

TEST(HidesBox, NotWhereTheEyeIsInItOrItReachesBehindTheEyeOrTheNearPlane)
{
  SBuffer full(8, 8, {}, 1024);
  InsertFace(full, FaceNumber5(LevelFace(0, 8, 0, 8, 1.0)));
  const auto hides = [&](const Box& box)
  { return HidesBox(full, StraightView(), box, AlongZ, true, 0.0f); };
  EXPECT_TRUE(hides({ { 2, 2, -0.5f }, { 5, 6, 0.5f } }));
  EXPECT_FALSE(hides({ { 2, 2, -0.5f }, { 5, 6, 1.5f } }));
  EXPECT_FALSE(hides({ { 2, 2, -0.5f }, { 5, 6, NotANumber } }));
  EXPECT_FALSE(hides({ { 2, 2, -0.5f }, { Infinity, 6, 0.5f } }));
  const Box box{ { 2, 2, -0.5f }, { 5, 6, 0.5f } };
  EXPECT_FALSE(HidesBox(full, StraightView(), box, { 3, 3, 0 }, false, 0.0f)) << "eye inside";
  EXPECT_FALSE(HidesBox(full, StraightView(), box, glm::dvec3(NotANumber), false, 0.0f));

  const ScreenProjection fromOrigin(
    glm::perspective(1.0, 1.0, 0.5, 20.0), 8, 8, glm::dvec3(5.0), {});
  const glm::dvec3 origin(0.0);
  EXPECT_TRUE(HidesBox(full, fromOrigin, { { 1, -1, -5 }, { 2, 1, -3 } }, origin, false, 0.0f));
  EXPECT_FALSE(HidesBox(full, fromOrigin, { { 1, -1, -5 }, { 2, 1, 3 } }, origin, false, 0.0f))
    << "from ahead to behind the eye, beside it";
}
