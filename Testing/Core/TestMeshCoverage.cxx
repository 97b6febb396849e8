// What single meshes cover in whatever way they are inserted, known without computing.

#include "CoveredScreen.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using coverage::AddRectangle;
using coverage::AsItStands;
using coverage::Covered;
using coverage::Facing;
using coverage::MeshProjection;
using coverage::OccluderMesh;
using coverage::RectangleOf;
using coverage::SBuffer;
using coverage::ScreenMatrix;
using coverage::Triangles;
using coverage::WideColumns;
using coverage::WideLines;

/** From 2.5 to 37.5 and lines 1 .. 18, in so many columns and lines of quads of two triangles. */
Triangles FineGrid(int columns, int lines)
{
  return coverage::GridOf(columns, lines,
    [](double u, double v)
    { return glm::dvec3(2.5 + 35.0 * u + std::sin(60 * v), 0.9 + 18.2 * v, 0.5); });
}

}

class MeshCoverage : public coverage::EachWay
{
};

INSTANTIATE_TEST_SUITE_P(
  Ways, MeshCoverage, ::testing::ValuesIn(coverage::AllWays), coverage::NameOfParameter);

TEST_P(MeshCoverage, OfTwoTrianglesThatFillTheScreenIsAllOfIt)
{
  Covered covered(GetParam(), RectangleOf({ -3, -3 }, { 45, 26 }));
  for (int line = 0; line < WideLines; ++line)
  {
    covered.ExpectFromTo(line, 0.0, WideColumns);
  }
  EXPECT_TRUE(covered.Buffer.Hides({ 0, WideColumns, 0, WideLines, 0.499f }));
  EXPECT_FALSE(covered.Buffer.Hides({ 0, WideColumns, 0, WideLines, 0.5f }));
}

TEST_P(MeshCoverage, OfARectangleIsTheLinesWhoseSamplesAreAllInIt)
{
  for (double low = 1.03; low < 2.0; low += 0.1)
  {
    SCOPED_TRACE(low);
    const double high = low + 11.24;
    const Covered covered(GetParam(), RectangleOf({ 3.25, low }, { 30.5, high }));
    for (int line = 0; line < WideLines; ++line)
    {
      const bool isIn = GetParam().IsBetween(line, low, high);
      covered.ExpectFromTo(line, isIn ? 3.25 : 0.0, isIn ? 30.5 : 0.0);
    }
    EXPECT_NEAR(covered.DepthAt(5, 17.0), 0.5, 1e-6);
  }
}

TEST_P(MeshCoverage, IsSmallerByTheMargin)
{
  const Covered covered(
    GetParam(), RectangleOf({ 3.25, 1.5 }, { 30.5, 12.5 }), Facing::Front, { 0.5f, 0.7f, 0.125f });
  for (int line = 0; line < WideLines; ++line)
  {
    const bool isIn = GetParam().IsBetween(line, 2.2, 11.8);
    covered.ExpectFromTo(line, isIn ? 3.75 : 0.0, isIn ? 30.0 : 0.0);
  }
  EXPECT_NEAR(covered.DepthAt(5, 17.0), 0.375, 1e-6);
}

TEST_P(MeshCoverage, OfATriangleIsWhatIsCoveredFromTheBottomToTheTopOfALine)
{
  Triangles triangle;
  triangle.Add({ 5, 0, 0.5 }, { 35, 0, 0.5 }, { 5, 15, 0.5 }); // its slanted side falls by 1 in 2
  const Covered covered(GetParam(), triangle);
  for (int line = 0; line < 16; ++line)
  {
    const bool isIn = GetParam().IsBetween(line, 0.0, 15.0);
    const double right = 35.0 - 2.0 * (line + 1 - GetParam().Inset());
    covered.ExpectFromTo(line, 5.0, isIn ? right : 5.0);
  }
}

TEST_P(MeshCoverage, LeavesAHoleOpen)
{
  Triangles frame;
  AddRectangle(frame, { 2, 1.5 }, { 12.5, 18.5 }, 0.5);
  AddRectangle(frame, { 20.25, 1.5 }, { 38, 18.5 }, 0.5);
  AddRectangle(frame, { 12.5, 1.5 }, { 20.25, 6.5 }, 0.5);
  AddRectangle(frame, { 12.5, 11.5 }, { 20.25, 18.5 }, 0.5);
  const Covered covered(GetParam(), frame);
  for (int line = 2; line < 18; ++line)
  {
    EXPECT_TRUE(covered.IsAt(line, 12.0));
    EXPECT_TRUE(covered.IsAt(line, 21.0));
    EXPECT_EQ(covered.IsAt(line, 16.0), line < 6 || line > 11) << line;
  }
}

TEST_P(MeshCoverage, LeavesASlitOpen)
{
  for (const double slant : { 0.0, 4.0, -9.0 })
  {
    Triangles halves;
    halves.AddQuad({ 1, -1, 0.5 }, { 19.5, -1, 0.5 }, { 19.5 + slant, 21, 0.5 }, { 1, 21, 0.5 });
    halves.AddQuad({ 19.8, -1, 0.5 }, { 39, -1, 0.5 }, { 39, 21, 0.5 }, { 19.8 + slant, 21, 0.5 });
    const Covered covered(GetParam(), halves);
    for (int line = 0; line < WideLines; ++line)
    {
      SCOPED_TRACE(line);
      for (const double y : { GetParam().Inset(), 0.5, 1.0 - GetParam().Inset() })
      {
        const double slit = 19.5 + slant * (line + y + 1) / 22.0;
        EXPECT_FALSE(covered.IsAt(line, slit + 0.01));
        EXPECT_FALSE(covered.IsAt(line, slit + 0.29));
        EXPECT_TRUE(covered.IsAt(line, slit - std::abs(slant) / 22.0 - 0.01));
        EXPECT_TRUE(covered.IsAt(line, slit + std::abs(slant) / 22.0 + 0.31));
      }
    }
  }
}

TEST_P(MeshCoverage, LeavesASlitOpenThatIsAsWideAsAFloat)
{
  Triangles halves;
  AddRectangle(halves, { 1, -1 }, { 19.5, 21 }, 0.5);
  AddRectangle(halves, { std::nextafter(19.5, 20.0), -1 }, { 39, 21 }, 0.5);
  const Covered covered(GetParam(), halves);
  EXPECT_FALSE(covered.IsAt(9, 19.5));
  EXPECT_TRUE(covered.IsAt(9, 19.4));
}

TEST_P(MeshCoverage, HasNoGapsWithinAMesh)
{
  const double area = Covered(GetParam(), FineGrid(1, 30)).Area();
  EXPECT_GT(area, 580.0);
  for (const int columns : { 7, 40, 400 })
  {
    EXPECT_NEAR(Covered(GetParam(), FineGrid(columns, 30)).Area(), area, 0.01) << columns;
  }
}

TEST_P(MeshCoverage, OfSliversIsThatOfTheirUnion)
{
  Triangles fan;
  const int count = 500;
  for (int i = 0; i < count; ++i)
  {
    const auto rim = [](int k) { return glm::dvec3(2.5 + 35.0 * k / count, 19.5, 0.5); };
    fan.Add({ 20, 0.5, 0.5 }, rim(i + 1), rim(i));
  }
  Triangles whole;
  whole.Add({ 20, 0.5, 0.5 }, { 37.5, 19.5, 0.5 }, { 2.5, 19.5, 0.5 });
  const Covered covered(GetParam(), fan);
  EXPECT_NEAR(covered.Area(), Covered(GetParam(), whole).Area(), 0.2); // tips of slivers
  EXPECT_NEAR(covered.DepthAt(9, GetParam().Samples().From(21.0f)), 0.5, 1e-4);
}

TEST_P(MeshCoverage, OfWhatIsSeenFromBehindIsThatOfBackFaces)
{
  const Triangles turned = coverage::GridOf(
    5, 4, [](double u, double v) { return glm::dvec3(37.5 - 35.0 * u, 1.5 + 17.0 * v, 0.5); });
  EXPECT_EQ(Covered(GetParam(), turned, Facing::Front).Area(), 0.0);
  const Covered covered(GetParam(), turned, Facing::Back);
  for (int line = 2; line < 18; ++line)
  {
    covered.ExpectFromTo(line, 2.5, 37.5);
  }
  EXPECT_NEAR(covered.Area(), 16 * 35.0, 0.1);
  EXPECT_NEAR(covered.DepthAt(9, 20.0), 0.5, 1e-6);
}

TEST_P(MeshCoverage, OfAFoldedSheetIsThatOfEitherSide)
{
  Triangles sheet; // goes right to 30.5 and comes back behind
  sheet.AddQuad({ 5.5, 1.5, 0.6 }, { 30.5, 1.5, 0.6 }, { 30.5, 18.5, 0.6 }, { 5.5, 18.5, 0.6 });
  sheet.AddQuad({ 30.5, 1.5, 0.6 }, { 9.5, 1.5, 0.3 }, { 9.5, 18.5, 0.3 }, { 30.5, 18.5, 0.6 });
  Covered(GetParam(), sheet, Facing::Front).ExpectFromTo(9, 5.5, 30.5);
  const Covered back(GetParam(), sheet, Facing::Back);
  back.ExpectFromTo(9, 9.5, 30.5);
  EXPECT_NEAR(back.DepthAt(9, 20.0), 0.45, 1e-4);
}

// Else a corner that lies in a line's middle would count for both of its edges.
TEST_P(MeshCoverage, EndsWhereACornerIsInTheMiddleOfALine)
{
  Triangles shapes;
  shapes.AddQuad({ 2, 9.5, 0.5 }, { 9, 2.1, 0.5 }, { 16, 9.2, 0.5 }, { 9, 17.3, 0.5 });
  AddRectangle(shapes, { 24, -1 }, { 37.5, 21 }, 0.5);
  const Covered covered(GetParam(), shapes);
  EXPECT_TRUE(covered.IsAt(9, 9.0));
  EXPECT_FALSE(covered.IsAt(9, 20.0));
  EXPECT_TRUE(covered.IsAt(9, 30.0));
}

TEST_P(MeshCoverage, OfNeighboursThatTurnDifferentlyIsThatOfEachAlone)
{
  Triangles mixed;
  mixed.Add({ 1, -1, 0.5 }, { 39, -1, 0.5 }, { 1, 21, 0.5 });
  mixed.Add({ 39, -1, 0.5 }, { 1, 21, 0.5 }, { 39, 21, 0.5 });
  Triangles first, second;
  first.Add({ 1, -1, 0.5 }, { 39, -1, 0.5 }, { 1, 21, 0.5 });
  second.Add({ 39, -1, 0.5 }, { 1, 21, 0.5 }, { 39, 21, 0.5 });
  EXPECT_NEAR(Covered(GetParam(), mixed).Area(), Covered(GetParam(), first).Area(), 1e-3);
  EXPECT_NEAR(Covered(GetParam(), mixed, Facing::Back).Area(),
    Covered(GetParam(), second, Facing::Back).Area(), 1e-3);
}

TEST_P(MeshCoverage, OfThreeFacesAtOneEdgeIsThatOfEachAlone)
{
  Triangles book;
  AddRectangle(book, { 2.5, -1 }, { 20, 21 }, 0.5);
  AddRectangle(book, { 20, -1 }, { 37.5, 21 }, 0.5);
  book.Add({ 20, -1, 0.5 }, { 30, 10, 0.6 }, { 20, 21, 0.5 });
  const Covered covered(GetParam(), book);
  EXPECT_TRUE(covered.IsAt(9, 19.9));
  EXPECT_TRUE(covered.IsAt(9, 20.1));
  EXPECT_TRUE(covered.IsAt(9, 25.0));
  EXPECT_NEAR(covered.Area(), 20 * 35.0, 30.0);
}

TEST_P(MeshCoverage, EndsAtTheScreensSides)
{
  const struct
  {
    glm::dvec2 Low, High;
    double Area;
  } cases[] = {
    { { -30, 2.5 }, { 10.5, 9.5 }, 6 * 10.5 },   // left
    { { 10.5, 2.5 }, { 100, 9.5 }, 6 * 29.5 },   // right
    { { 10.5, -50 }, { 20.5, 9.5 }, 9 * 10.0 },  // below
    { { 10.5, 2.5 }, { 20.5, 99.5 }, 17 * 10.0 } // above
  };
  for (const auto& one : cases)
  {
    EXPECT_NEAR(Covered(GetParam(), RectangleOf(one.Low, one.High)).Area(), one.Area, 0.02);
  }
}

TEST_P(MeshCoverage, OfPointsFarOutsideIsStillThatOnTheScreen)
{
  EXPECT_NEAR(Covered(GetParam(), RectangleOf({ -1e4, -2e4 }, { 1e4, 1e4 })).Area(),
    WideColumns * WideLines, 0.1);
  for (const double far : { 1e7, 1e15, 1e30, 3e38 })
  {
    EXPECT_LE(Covered(GetParam(), RectangleOf({ -far, -far }, { far, far })).Area(),
      WideColumns * WideLines);
    EXPECT_EQ(Covered(GetParam(), RectangleOf({ far, far }, { 1.1 * far, 1.1 * far })).Area(), 0.0);
    EXPECT_EQ(Covered(GetParam(), RectangleOf({ -1.1 * far, 2 }, { -far, 9 })).Area(), 0.0);
  }
}

TEST_P(MeshCoverage, OfNumbersThatAreNoneIsNothing)
{
  const OccluderMesh mesh = RectangleOf({ 2.5, 2.5 }, { 30, 15 }).Mesh();
  for (const double bad : { double{ NotANumber }, double{ Infinity }, -double{ Infinity } })
  {
    for (int i = 0; i < 16; ++i)
    {
      ScreenMatrix matrix = AsItStands();
      matrix.Matrix[i / 4][i % 4] = bad;
      SBuffer buffer(WideColumns, WideLines, GetParam().Samples(), coverage::MostTestSpans);
      MeshProjection projection;
      projection.Project(mesh, matrix);
      projection.FindFacings();
      vitrine::FaceCoverage inserter;
      inserter.Insert(buffer, projection, Facing::Front, 0);
      inserter.Insert(buffer, projection, Facing::Back, 0);
      EXPECT_EQ(coverage::CoveredArea(buffer), 0.0) << bad << " " << i;
    }
  }
}

// The corner is one of two sides that go the same way, and counts for one.
TEST_P(MeshCoverage, IsOpenBesideACornerInTheMiddleOfALine)
{
  Triangles arms; // two, on a base
  arms.AddQuad({ 5, 2, 0.5 }, { 10, 2, 0.5 }, { 10, 5, 0.5 }, { 5, 5, 0.5 });
  arms.AddQuad({ 10, 2, 0.5 }, { 30, 2, 0.5 }, { 30, 5, 0.5 }, { 10, 5, 0.5 });
  arms.AddQuad({ 30, 2, 0.5 }, { 35, 2, 0.5 }, { 35, 5, 0.5 }, { 30, 5, 0.5 });
  arms.AddQuad({ 30, 5, 0.5 }, { 35, 5, 0.5 }, { 35, 16, 0.5 }, { 30, 16, 0.5 });
  arms.Add({ 5, 5, 0.5 }, { 10, 5, 0.5 }, { 7, 10.5, 0.5 });
  arms.Add({ 10, 5, 0.5 }, { 10, 16, 0.5 }, { 7, 10.5, 0.5 });
  arms.Add({ 7, 10.5, 0.5 }, { 10, 16, 0.5 }, { 5, 16, 0.5 });
  const Covered covered(GetParam(), arms);
  EXPECT_TRUE(covered.Buffer.Hides({ 8, 9, 10, 11, 0.49f }));
  EXPECT_FALSE(covered.Buffer.Hides({ 14, 26, 10, 11, 0.49f }));
  EXPECT_TRUE(covered.Buffer.Hides({ 31, 34, 10, 11, 0.49f }));
}

TEST_P(MeshCoverage, EndsAtTheNearPlane)
{
  Triangles sheet;
  AddRectangle(sheet, { 2.5, -1 }, { 20.5, 21 }, 0.5);
  sheet.AddQuad({ 20.5, -1, 0.5 }, { 37.5, -1, 1.01 }, { 37.5, 21, 1.01 }, { 20.5, 21, 0.5 });
  const Covered covered(GetParam(), sheet);
  for (int line = 0; line < WideLines; ++line)
  {
    covered.ExpectFromTo(line, 2.5, 20.5 + 17.0 * 0.5 / 0.51);
  }
}
