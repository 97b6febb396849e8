// How near what is covered face by face is, known without computing.

#include "CoveredScreen.h"

#include "BoxPlaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using coverage::AddRectangle;
using coverage::Covered;
using coverage::Facing;
using coverage::MeshProjection;
using coverage::OccluderMesh;
using coverage::Random;
using coverage::SBuffer;
using coverage::Triangles;
using coverage::View;
using coverage::Way;

}

class FaceCoverage : public coverage::EachWay
{
};

INSTANTIATE_TEST_SUITE_P(Ways, FaceCoverage,
  ::testing::Values(Way{ 0 }, Way{ 1 }, Way{ 2 }, Way{ 4 }), coverage::NameOfParameter);

TEST_P(FaceCoverage, OfOverlappingSheetsIsTheirUnionAtTheNearerDepth)
{
  Triangles sheets;
  AddRectangle(sheets, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  AddRectangle(sheets, { 12.5, 1.5 }, { 37.5, 18.5 }, 0.4);
  const Covered covered(GetParam(), sheets);
  EXPECT_TRUE(covered.IsAt(9, 3.0));
  EXPECT_TRUE(covered.IsAt(9, 12.0));
  EXPECT_TRUE(covered.IsAt(9, 16.0));
  EXPECT_TRUE(covered.IsAt(9, 37.0));
  EXPECT_NEAR(covered.DepthAt(9, 4.0), 0.7, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 36.0), 0.4, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 18.0), 0.7, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 20.4), 0.7, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 20.6), 0.4, 1e-6);
}

TEST_P(FaceCoverage, FollowsTheDepthOfAPlane)
{
  Triangles slanted;
  slanted.AddQuad({ 0.5, -4, 0.2 }, { 39.5, -4, 0.8 }, { 39.5, 24, 0.8 }, { 0.5, 24, 0.2 });
  const Covered covered(GetParam(), slanted);
  for (double column = 1.0; column < 39.0; column += 0.37)
  {
    const double depth = 0.2 + 0.6 * (column - 0.5) / 39.0;
    EXPECT_NEAR(covered.DepthAt(7, column), depth, 1e-4);
    EXPECT_LE(covered.DepthAt(7, column), depth + 1e-7);
  }
}

TEST_P(FaceCoverage, TakesTheFarEndOfALine)
{
  for (const double top : { 0.1, 0.9 })
  {
    Triangles slanted;
    const double step = (top - 0.5) / 20.0, below = 0.5 - step, above = top + step;
    slanted.AddQuad({ -1, -1, below }, { 41, -1, below }, { 41, 21, above }, { -1, 21, above });
    const Covered covered(GetParam(), slanted);
    for (int line = 1; line < 19; ++line)
    {
      const double inset = GetParam().Inset();
      const double farEnd = line + (top < 0.5 ? 1.0 - inset : inset);
      const double depth = 0.5 + (top - 0.5) * farEnd / 20.0;
      EXPECT_NEAR(covered.DepthAt(line, 20.0), depth, 1e-4);
      EXPECT_LE(covered.DepthAt(line, 20.0), depth + 1e-7);
    }
  }
}

TEST_P(FaceCoverage, OfASteepFaceIsNoFartherThanItsFarthestCorner)
{
  Triangles step;
  AddRectangle(step, { 2.5, -1 }, { 10, 21 }, 0.5);
  step.AddQuad({ 10, -1, 0.5 }, { 10.2, -1, 0.3 }, { 10.2, 21, 0.3 }, { 10, 21, 0.5 });
  AddRectangle(step, { 10.2, -1 }, { 37.5, 21 }, 0.3);
  const Covered covered(GetParam(), step);
  EXPECT_NEAR(covered.DepthAt(9, 5.0), 0.5, 1e-4);
  EXPECT_NEAR(covered.DepthAt(9, 15.5), 0.3, 1e-4);
}

TEST_P(FaceCoverage, IsNearThePlaneOfAWallInAnyView)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    View view = coverage::WholeView(40, seed % 2 == 0, random);
    Triangles wall;
    const glm::dvec3 side = glm::normalize(glm::cross(view.Eye, random.Point(-1, 1)));
    const glm::dvec3 up = glm::normalize(glm::cross(view.Eye, side)) + 0.1 * view.Eye;
    wall.AddQuad(-side - up, side - up, side + up, up - side);
    const OccluderMesh mesh = wall.Mesh();
    MeshProjection projection;
    projection.Project(mesh, view.Projection(3.0).Of(glm::dmat4(1.0)));
    projection.FindFacings();
    SBuffer buffer(view.Columns, view.Lines, GetParam().Samples(), coverage::MostTestSpans);
    vitrine::FaceCoverage().Insert(buffer, projection, Facing::Front, 0);
    vitrine::FaceCoverage().Insert(buffer, projection, Facing::Back, 0);
    // Depths of the wall's corners differ by more than those of a line's lower and upper side.
    double least = 1.0, greatest = 0.0;
    for (std::uint32_t i = 0; i < mesh.PointCount(); ++i)
    {
      const vitrine::ScreenPoint point = projection.Point(i);
      least = std::min(least, double{ point.Depth });
      greatest = std::max(greatest, double{ point.Depth });
    }
    double farthest = 1.0, nearest = 0.0;
    for (int line = 0; line < view.Lines; ++line)
    {
      for (const vitrine::Span& span : buffer.SpansOf(line))
      {
        for (const float depth : { span.Depth, span.DepthAt(span.Right) })
        {
          farthest = std::min(farthest, double{ depth });
          nearest = std::max(nearest, double{ depth });
        }
      }
    }
    EXPECT_GT(greatest - least, 1e-3);
    EXPECT_GT(nearest, greatest - 0.2 * (greatest - least));
    EXPECT_GT(farthest, least - 0.05 * (greatest - least));
  }
}

// A box with thick walls: the far wall's inside faces the view as well.
TEST_P(FaceCoverage, OfAShellHasTheDepthOfItsNearWall)
{
  for (const bool isOpen : { false, true })
  {
    SCOPED_TRACE(isOpen);
    const View view = coverage::WholeView(40, true, glm::dvec3(0.2, 0.1, 6.0));
    const OccluderMesh mesh = coverage::ShellOf(1.2, 0.1, isOpen).Mesh();
    EXPECT_TRUE(mesh.IsClosed());
    MeshProjection projection;
    EXPECT_TRUE(projection.Project(mesh, view.Projection(2.0).Of(glm::dmat4(1.0))));
    projection.FindFacings();
    SBuffer buffer(view.Columns, view.Lines, GetParam().Samples(), coverage::MostTestSpans);
    vitrine::FaceCoverage().Insert(buffer, projection, Facing::Front, 0);
    const vitrine::ScreenProjection toScreen = view.Projection(2.0);
    vitrine::ScreenRectangle inside;
    const glm::dvec3 half(0.7, 0.7, 0.05);
    const glm::dvec3 middle(0.0, 0.0, 1.0); // 1.1 is where the near wall ends
    ASSERT_EQ(
      coverage::PlaceOf(toScreen, vitrine::Box::Around(middle - half, middle + half), inside),
      coverage::Place::Before);
    EXPECT_TRUE(buffer.Hides(inside));
    vitrine::ScreenRectangle before;
    const glm::dvec3 nearer(0.0, 0.0, 1.4);
    ASSERT_EQ(
      coverage::PlaceOf(toScreen, vitrine::Box::Around(nearer - half, nearer + half), before),
      coverage::Place::Before);
    EXPECT_FALSE(buffer.Hides(before));
  }
}

TEST_P(FaceCoverage, LeavesOutWhatIsCoveredByWhatIsNearer)
{
  SBuffer buffer(
    coverage::WideColumns, coverage::WideLines, GetParam().Samples(), coverage::MostTestSpans);
  vitrine::FaceCoverage inserter;
  std::uint64_t inserted = 0;
  for (const double depth : { 0.5, 0.3, 0.7, 0.5 })
  {
    SCOPED_TRACE(depth);
    const OccluderMesh mesh = coverage::RectangleOf({ -3, -3 }, { 45, 26 }, depth).Mesh();
    MeshProjection projection;
    projection.Project(mesh, coverage::AsItStands());
    projection.FindFacings();
    inserter.Insert(buffer, projection, Facing::Front, 0);
    const bool isNearest = depth == 0.7 || inserted == 0;
    EXPECT_EQ(buffer.Counts().Inserted > inserted, isNearest);
    inserted = buffer.Counts().Inserted;
  }
  for (int line = 0; line < coverage::WideLines; ++line)
  {
    for (const vitrine::Span& span : buffer.SpansOf(line))
    {
      EXPECT_NEAR(span.Depth, 0.7f, 1e-6f);
    }
  }
}

// However many faces a wall is made of, a line of it is one span.
TEST_P(FaceCoverage, OfAFlatSheetIsOneSpanALine)
{
  Triangles sheet = coverage::GridOf(12, 7,
    [](double u, double v)
    { return glm::dvec3(2 + 36 * u, -1 + 22 * v, 0.2 + 0.3 * u + 0.1 * v); });
  const Covered covered(GetParam(), sheet);
  EXPECT_EQ(covered.Buffer.Counts().Inserted, static_cast<std::uint64_t>(coverage::WideLines));
  EXPECT_NEAR(covered.DepthAt(9, 20.0), 0.2 + 0.15 + 0.1 * 10.0 / 22, 5e-3);
}

// A near wall stands before a far wall of the same part and is joined with it at the side. Where the near wall has
// edges, the far wall's depth does not count.
TEST_P(FaceCoverage, OfAFoldedSheetHasTheNearerDepth)
{
  Triangles fold;
  fold.AddQuad({ 5, -1, 0.3 }, { 38, -1, 0.3 }, { 38, 21, 0.3 }, { 5, 21, 0.3 });
  fold.AddQuad({ 38, -1, 0.3 }, { 39, -1, 0.8 }, { 39, 21, 0.8 }, { 38, 21, 0.3 });
  const Covered behind(GetParam(), fold);
  EXPECT_NEAR(behind.DepthAt(9, 20.0), 0.3, 1e-3);
  AddRectangle(fold, { 10, -1 }, { 20, 21 }, 0.7);
  AddRectangle(fold, { 20, -1 }, { 30, 21 }, 0.6);
  const Covered covered(GetParam(), fold);
  EXPECT_NEAR(covered.DepthAt(9, 15.0), 0.7, 1e-3);
  EXPECT_NEAR(covered.DepthAt(9, 25.0), 0.6, 1e-3);
  EXPECT_NEAR(covered.DepthAt(9, 34.0), 0.3, 1e-3);
  EXPECT_GE(covered.DepthAt(9, 20.0), 0.3 - 1e-3) << "covered by the wall behind all the same";
  EXPECT_LE(covered.DepthAt(9, 20.0), 0.7);
}

// The faces look into all directions, and are hardly wider than what their edges touch. A line of them is one cluster
// of edges.
TEST_P(FaceCoverage, OfManyNarrowFacesIsAllBetweenTheirOutline)
{
  Triangles crumpled = coverage::GridOf(300, 30,
    [](double u, double v)
    {
      const double x = 300 * u, y = 30 * v;
      return glm::dvec3(2 + 36 * u, -1 + 22 * v, 0.5 + 0.01 * std::sin(37.0 * x * x + 11.0 * y));
    });
  const Covered covered(GetParam(), crumpled, Facing::Front, { 0.03f, 0.03f, 1e-6f });
  for (int line = 0; line < coverage::WideLines; ++line)
  {
    for (const double column : { 2.5, 3.9, 8.1, 19.9, 20.1, 30.3, 37.5 })
    {
      EXPECT_GT(covered.DepthAtSample(line, column), 0.0) << line << ", " << column;
    }
    EXPECT_FALSE(covered.IsAt(line, 1.9));
    EXPECT_FALSE(covered.IsAt(line, 38.1));
  }
}

TEST_P(FaceCoverage, LeavesNoSlitsBesideANarrowFace)
{
  Triangles stairs;
  stairs.AddQuad({ 2, -1, 0.3 }, { 15.05, -1, 0.5 }, { 15.05, 21, 0.5 }, { 2, 21, 0.3 });
  stairs.AddQuad({ 15.05, -1, 0.5 }, { 15.112, -1, 0.4 }, { 15.112, 21, 0.4 }, { 15.05, 21, 0.5 });
  stairs.AddQuad({ 15.112, -1, 0.4 }, { 38, -1, 0.2 }, { 38, 21, 0.2 }, { 15.112, 21, 0.4 });
  const Covered covered(GetParam(), stairs, Facing::Front, { 0.03f, 0.03f, 1e-5f });
  for (int line = 1; line < coverage::WideLines - 1; ++line)
  {
    covered.ExpectFromTo(line, 2.03, 37.97);
    for (const double column : { 15.04, 15.06, 15.08, 15.1 })
    {
      EXPECT_GT(covered.DepthAtSample(line, column), 0.3) << column;
    }
  }
}

TEST_P(FaceCoverage, LeavesNoSlitAtTheSideOfTheScreen)
{
  Triangles roof;
  roof.AddQuad({ -3, -1, 0.1 }, { 39.99, -1, 0.9 }, { 39.99, 21, 0.9 }, { -3, 21, 0.1 });
  roof.AddQuad({ 39.99, -1, 0.9 }, { 45, -1, 0.1 }, { 45, 21, 0.1 }, { 39.99, 21, 0.9 });
  const Covered covered(GetParam(), roof, Facing::Front, { 0.03f, 0.03f, 1e-5f });
  for (int line = 0; line < coverage::WideLines; ++line)
  {
    EXPECT_TRUE(covered.IsAt(line, GetParam().Samples().UpTo(39.999f))) << line;
  }
}
