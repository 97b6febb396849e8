// Tests how much of convex meshes of few facets is covered, and how near. Points are given as columns, lines and
// reversed depths.

#include "FewFacetsScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::FewOnScreen;
using coverage::Random;
using coverage::Triangles;

const double Hair = 1e-4; // columns and lines; some times what floats round

Triangles LevelQuad(const glm::dvec2& low, const glm::dvec2& high, double depth,
  double byColumn = 0.0, double byLine = 0.0)
{
  const auto at = [&](double x, double y)
  { return glm::dvec3(x, y, depth + byColumn * (x - 20.0) + byLine * (y - 10.0)); };
  Triangles quad;
  quad.AddQuad(at(low.x, low.y), at(high.x, low.y), at(high.x, high.y), at(low.x, high.y));
  return quad;
}

/** Expects it to be covered on lines all of whose rows of samples lie between, at samples that do. */
void ExpectWithin(const FewOnScreen& few, const glm::dvec2& low, const glm::dvec2& high)
{
  for (int line = 0; line < FewOnScreen::Lines; ++line)
  {
    const bool isLineIn = line + few.Inset() > low.y && line + 1 - few.Inset() < high.y;
    for (int i = 0; i < FewOnScreen::Columns * few.Pixels; ++i)
    {
      const double x = few.PlaceOf(i);
      ASSERT_EQ(few.DepthAt(line, i) >= 0.0, isLineIn && low.x < x && x < high.x)
        << "line " << line << ", column " << x;
    }
  }
}

}

class FewFacetsOnScreen : public ::testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Pixels, FewFacetsOnScreen, ::testing::Values(1, 2, 4));

// An edge on a row of samples does not cover it: a device may have it either way.
TEST_P(FewFacetsOnScreen, HaveTheRowsThatLieBetweenLevelEdges)
{
  const double pixel = 1.0 / GetParam();
  for (int row = 0; row < 3 * GetParam(); ++row)
  {
    for (const double below : { -Hair, 0.0, Hair })
    {
      for (const double above : { -Hair, 0.0, Hair })
      {
        SCOPED_TRACE(testing::Message() << row << " " << below << " " << above);
        const glm::dvec2 low(4.3, (row + 0.5) * pixel + below);
        const glm::dvec2 high(33.7, (row + 0.5) * pixel + 7.0 + above);
        FewOnScreen few(GetParam());
        ASSERT_TRUE(few.Insert(LevelQuad(low, high, 0.5)));
        ExpectWithin(few, low, high);
      }
    }
  }
}

TEST_P(FewFacetsOnScreen, HaveTheSamplesThatLieBetweenUprightEdges)
{
  const double pixel = 1.0 / GetParam();
  for (const double left : { -Hair, 0.0, Hair })
  {
    for (const double right : { -Hair, 0.0, Hair })
    {
      SCOPED_TRACE(testing::Message() << left << " " << right);
      const glm::dvec2 low(7.0 + 0.5 * pixel + left, -3.0);
      const glm::dvec2 high(29.0 + 0.5 * pixel + right, 23.0);
      FewOnScreen few(GetParam());
      ASSERT_TRUE(few.Insert(LevelQuad(low, high, 0.5)));
      // An edge on a sample may be had either way.
      ExpectWithin(few, low + glm::dvec2(left == 0.0 ? Hair : 0.0, 0.0),
        high - glm::dvec2(right == 0.0 ? Hair : 0.0, 0.0));
    }
  }
}

TEST_P(FewFacetsOnScreen, AreSmallerByTheMargin)
{
  const glm::dvec2 low(4.3, 2.35), high(33.7, 15.65);
  const glm::dvec2 margin(0.6, 0.8);
  FewOnScreen few(GetParam());
  ASSERT_TRUE(few.Insert(LevelQuad(low, high, 0.5), { 0.6f, 0.8f, 0.125f }));
  ExpectWithin(few, low + margin, high - margin);
  EXPECT_NEAR(few.DepthAt(9, 20 * GetParam()), 0.375, 1e-6);
}

TEST_P(FewFacetsOnScreen, EndAtTheScreensSides)
{
  for (const glm::dvec2& low : { glm::dvec2(-30.0, -30.0), { -1e4, 4.1 }, { 9.2, -1e4 } })
  {
    for (const glm::dvec2& high : { glm::dvec2(90.0, 80.0), { 1e4, 12.9 }, { 31.3, 1e4 } })
    {
      FewOnScreen few(GetParam());
      ASSERT_TRUE(few.Insert(LevelQuad(low, high, 0.5)));
      ExpectWithin(few, low, high);
    }
  }
}

TEST_P(FewFacetsOnScreen, AreSeenFromBehindAsBackFacesAlone)
{
  Triangles turned = LevelQuad({ 4.3, 2.2 }, { 33.7, 15.8 }, 0.5);
  for (std::size_t i = 0; i < turned.Corners.size(); i += 3)
  {
    std::swap(turned.Corners[i], turned.Corners[i + 1]);
  }
  FewOnScreen front(GetParam()), back(GetParam());
  ASSERT_TRUE(front.Insert(turned));
  ASSERT_TRUE(back.Insert(turned, {}, coverage::MeshProjection::Facing::Back));
  EXPECT_EQ(front.Count(), 0u);
  ExpectWithin(back, { 4.3, 2.2 }, { 33.7, 15.8 });
  EXPECT_EQ(back.Buffer.SpansOf(9)[0].Face, 7u);
}

// Of a line with several rows of samples the farthest of them counts.
TEST_P(FewFacetsOnScreen, AreAsNearAsTheirPlaneWhereItSlants)
{
  for (const auto& [byColumn, byLine] :
    { std::make_pair(0.01, 0.0), { -0.01, 0.005 }, { 0.0, -0.02 }, { 0.004, 0.015 } })
  {
    SCOPED_TRACE(testing::Message() << byColumn << " " << byLine);
    FewOnScreen few(GetParam());
    ASSERT_TRUE(few.Insert(LevelQuad({ 2.3, 1.2 }, { 37.7, 18.8 }, 0.5, byColumn, byLine)));
    const double half = 0.5 - few.Inset();
    for (int line = 2; line < 18; ++line)
    {
      for (int i = 3 * GetParam(); i < 37 * GetParam(); ++i)
      {
        const double plane =
          0.5 + byColumn * (few.PlaceOf(i) - 20.0) + byLine * (line + 0.5 - 10.0);
        ASSERT_NEAR(few.DepthAt(line, i), plane - std::abs(byLine) * half, 1e-4);
      }
    }
  }
}

TEST_P(FewFacetsOnScreen, AreFartherByWhatIsNotKnown)
{
  const coverage::Triangles quad = LevelQuad({ 2, 2 }, { 38, 18 }, 0.5, 1e-3);
  FewOnScreen known(GetParam()), unsteady(GetParam());
  ASSERT_TRUE(known.Insert(quad));
  ASSERT_TRUE(unsteady.Insert(quad, {}, coverage::MeshProjection::Facing::Front, { 2e-4f }));
  const int sample = 20 * GetParam();
  EXPECT_NEAR(unsteady.DepthAt(9, sample), known.DepthAt(9, sample) - 2e-4, 1e-6);
}

// Of the side that is seen with it, or that rounding has seem so, the farthest corner is far behind.
TEST_P(FewFacetsOnScreen, OfAThinPlateAreAsNearAsItsFace)
{
  const double byColumn = 0.05 / 30, byLine = (0.03 - 4 * byColumn) / 14;
  for (const double aside : { -0.5, -0.01, -1e-3, -1e-4, -3e-6, -1e-6, 0.0, 1e-6 })
  {
    for (const float margin : { 0.0f, 0.004f, 0.1f })
    {
      for (double left = 3.0; left < 4.0; left += 0.0937)
      {
        SCOPED_TRACE(testing::Message() << aside << " " << margin << " " << left);
        // Its side goes back along its edge, so that next to nothing is known of the side's slopes.
        const glm::dvec3 edge(4, 14, 0.03);
        const Triangles plate = coverage::BoxOf(
          { left, 3, 0.6 }, { 30, 0, 0.05 }, edge, 0.05 * edge + glm::dvec3(aside, 0, -0.5));
        FewOnScreen few(GetParam());
        coverage::ScreenMatrix matrix = FewOnScreen::AsItStands({ margin, margin, 0.0f });
        matrix.Rounding = glm::vec4(0.02f * margin, 0.02f * margin, 0.0f, 0.0f);
        ASSERT_TRUE(few.InsertIn(plate, matrix, coverage::MeshProjection::Facing::Front));
        const double x = few.PlaceOf(20 * GetParam()), half = 0.5 - few.Inset();
        const double plane = 0.6 + byColumn * (x - left) + byLine * (9.5 - 3);
        const double steep = byColumn * margin + byLine * (margin + half);
        ASSERT_NEAR(few.DepthAt(9, 20 * GetParam()), plane - steep, 1e-3);
      }
    }
  }
}

TEST_P(FewFacetsOnScreen, AreMostOfALargeBox)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const coverage::View view = coverage::WholeView(40, seed % 3 == 0, random);
    const coverage::OccluderMesh mesh =
      coverage::BoxBetween(glm::dvec3(-0.7), glm::dvec3(0.7)).Mesh();
    coverage::MeshProjection projection;
    ASSERT_TRUE(projection.Project(mesh, view.Projection(1.0).Of(glm::dmat4(1.0))));
    ASSERT_TRUE(mesh.Few());
    coverage::SBuffer buffer = coverage::SBuffer::WithFewSamples(
      view.Columns, view.Lines, coverage::SampleGrid::AtCentres(GetParam()));
    vitrine::FewFacetsCoverage::Insert(
      buffer, *mesh.Few(), projection, coverage::MeshProjection::Facing::Front, 0);

    const coverage::CoverageJudge judge(
      coverage::DrawnFaces(mesh, view, coverage::MeshProjection::Facing::Front,
        [&](std::uint32_t i)
        {
          const vitrine::ScreenPoint point = projection.Point(i);
          return glm::dvec3(point.Column, point.Line, point.Depth);
        }),
      0.0);
    const auto isIn = [&](double x, double y)
    {
      const std::vector<coverage::Stretch> stretches = judge.StretchesAt(y);
      return std::any_of(stretches.begin(), stretches.end(),
        [x](const coverage::Stretch& stretch) { return stretch.Left <= x && x <= stretch.Right; });
    };
    const double inset = 0.5 / GetParam();
    int within = 0, covered = 0;
    for (int line = 0; line < view.Lines; ++line)
    {
      covered += static_cast<int>(buffer.SpansOf(line).size());
      for (int i = 0; i < view.Columns * GetParam(); ++i)
      {
        const double x = (i + 0.5) / GetParam();
        within += isIn(x, line + inset) && isIn(x, line + 1 - inset);
      }
    }
    ASSERT_GT(within, 500 * GetParam());
    ASSERT_LE(covered, within);
    ASSERT_GT(covered, 0.98 * within);
  }
}
