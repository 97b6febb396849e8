// For any convex mesh and view, what an s-buffer of samples reports as covered is covered, and nowhere farther than
// reported.

#include "CoverageSubjects.h"
#include "FewFacetsScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::CoverageJudge;
using coverage::FewOnScreen;
using coverage::MeshProjection;
using coverage::OccluderMesh;
using coverage::Random;
using coverage::ScreenFace;
using coverage::ScreenMargin;
using coverage::Subject;
using coverage::Triangles;
using vitrine::SampleGrid;
using vitrine::SBuffer;

using FewFacing = MeshProjection::Facing;

/** What a device draws that snaps the corners that it covers with, and takes depths from those that are not snapped. */
std::vector<ScreenFace> SnappedAndDrawn(
  const MeshProjection& projection, FewFacing facing, Random& random)
{
  const ScreenMargin &margin = projection.Margin(), &snapping = projection.Snapping();
  const auto off = [&](float most) { return (random.OneIn(2) ? 1.0 : -1.0) * most; };
  const double shift = off(snapping.Depth);
  std::vector<glm::dvec3> drawn, snapped;
  for (std::uint32_t i = 0; i < projection.Mesh().PointCount(); ++i)
  {
    const vitrine::ScreenPoint point = projection.Point(i);
    drawn.push_back({ point.Column + 0.999 * off(margin.Column - snapping.Column),
      point.Line + 0.999 * off(margin.Line - snapping.Line),
      point.Depth + shift + 0.999 * off(margin.Depth - snapping.Depth) });
    snapped.push_back(
      drawn.back() + 0.999 * glm::dvec3(off(snapping.Column), off(snapping.Line), 0.0));
  }
  std::vector<ScreenFace> faces;
  for (const OccluderMesh::Face& face : projection.Mesh().Faces())
  {
    ScreenFace onScreen{ snapped[face[0]], snapped[face[1]], snapped[face[2]] };
    const ScreenFace corners{ drawn[face[0]], drawn[face[1]], drawn[face[2]] };
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (glm::dvec3& corner : onScreen)
    {
      const glm::dvec3 away = corner - corners[0];
      const double depth = corners[0].z - (normal.x * away.x + normal.y * away.y) / normal.z;
      corner.z = std::isfinite(depth) ? depth : -1e9; // how far that is cannot be told
    }
    if (facing == FewFacing::Front ? coverage::TurnOf(onScreen) > 0.0
                                   : coverage::TurnOf(onScreen) < 0.0)
    {
      faces.push_back(onScreen);
    }
  }
  return faces;
}

ScreenMargin RandomMargin(Random& random)
{
  const double most = random.OneIn(3) ? 0.0 : std::pow(10.0, random.Between(-5.0, -0.3));
  return { static_cast<float>(most), static_cast<float>(random.Between(0.0, 1.5) * most),
    static_cast<float>(random.Between(0.0, 0.1) * most) };
}

/** To columns, lines and depths around the middle of the screen, so much larger. */
Triangles OnScreenOf(Triangles triangles, const glm::dvec3& size)
{
  for (glm::dvec3& point : triangles.Points)
  {
    point = glm::dvec3(20.0, 10.0, 0.5) + size * point;
  }
  return triangles;
}

}

class FewFacetsCoverage : public ::testing::TestWithParam<int>
{
protected:
  static double InsetOf(int pixels) { return 0.5 / pixels; }

  /** Puts one side of a subject into an s-buffer and has it judged; returns whether it covers anything. */
  static bool Judge(const Subject& subject, FewFacing facing, Random& random)
  {
    const int pixels = GetParam();
    MeshProjection projection;
    if (!subject.Mesh.Few() || !projection.Project(subject.Mesh, subject.ToScreen()))
    {
      return false;
    }
    SBuffer buffer = SBuffer::WithFewSamples(
      subject.Seen.Columns, subject.Seen.Lines, SampleGrid::AtCentres(pixels));
    vitrine::FewFacetsCoverage::Insert(buffer, *subject.Mesh.Few(), projection, facing, 0);
    if (buffer.Counts().Inserted == 0)
    {
      return false;
    }
    const auto moved = [&]
    { return coverage::DrawnBy(projection, subject.Seen, subject.Reach, facing, random); };
    for (const std::vector<ScreenFace>& faces :
      { coverage::ExactlyDrawn(subject, facing, random), moved(), moved(), moved(),
        SnappedAndDrawn(projection, facing, random), SnappedAndDrawn(projection, facing, random) })
    {
      EXPECT_EQ(CoverageJudge(faces, InsetOf(pixels)).WhatIsWrong(buffer, random.Generator, 3), "");
    }
    return true;
  }

  /** The same of a mesh whose points are columns, lines and depths themselves. */
  static bool JudgeOnScreen(
    const Triangles& triangles, const ScreenMargin& margin, FewFacing facing, Random& random)
  {
    return JudgeIn(FewOnScreen::AsItStands(margin), triangles, facing, random);
  }

  static bool JudgeIn(const coverage::ScreenMatrix& toScreen, const Triangles& triangles,
    FewFacing facing, Random& random)
  {
    FewOnScreen few(GetParam());
    if (!few.InsertIn(triangles, toScreen, facing) || few.Count() == 0)
    {
      return false;
    }
    for (int i = 0; i < 4; ++i)
    {
      const std::vector<glm::dvec3> places = coverage::MovedPoints(few.Projected, random);
      std::vector<ScreenFace> faces;
      for (const OccluderMesh::Face& face : few.Mesh.Faces())
      {
        const ScreenFace drawn{ places[face[0]], places[face[1]], places[face[2]] };
        const double turn = coverage::TurnOf(drawn);
        if (facing == FewFacing::Front ? turn > 0.0 : turn < 0.0)
        {
          faces.push_back(drawn);
        }
      }
      EXPECT_EQ(CoverageJudge(faces, few.Inset()).WhatIsWrong(few.Buffer, random.Generator, 3), "");
    }
    return true;
  }
};

INSTANTIATE_TEST_SUITE_P(Pixels, FewFacetsCoverage, ::testing::Values(1, 2, 4));

TEST_P(FewFacetsCoverage, IsTrueOfRandomMeshesInRandomViews)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Subject subject = coverage::SubjectOf(coverage::RandomFewFacets(random), random);
    covered += Judge(subject, FewFacing::Front, random);
    covered += Judge(subject, FewFacing::Back, random);
  }
  EXPECT_GT(covered, 500);
}

TEST_P(FewFacetsCoverage, IsTrueOfWhatIsThinOrSmallOnTheScreen)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 4000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double size = std::pow(10.0, random.Between(-0.3, 1.3));
    const Triangles triangles = OnScreenOf(coverage::RandomFewFacets(random),
      { size, random.Between(0.1, 1.0) * size, random.Between(0.0, 0.3) });
    const ScreenMargin margin = RandomMargin(random);
    covered += JudgeOnScreen(triangles, margin, FewFacing::Front, random);
    covered += JudgeOnScreen(triangles, margin, FewFacing::Back, random);
  }
  EXPECT_GT(covered, 1500);
}

TEST_P(FewFacetsCoverage, IsTrueOfWhatReachesFarBeyondTheScreen)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double size = std::pow(10.0, random.Between(1.3, 7.0));
    const Triangles triangles = OnScreenOf(coverage::RandomFewFacets(random),
      { size, std::pow(10.0, random.Between(0.0, 1.0)) * size, random.Between(0.0, 0.3) });
    const ScreenMargin margin = RandomMargin(random);
    covered += JudgeOnScreen(triangles, margin, FewFacing::Front, random);
    covered += JudgeOnScreen(triangles, margin, FewFacing::Back, random);
  }
  EXPECT_GT(covered, 500);
}

// Where an edge is nearly level, a device that moves its corners has it pass other lines.
TEST_P(FewFacetsCoverage, IsTrueOfNearlyLevelEdges)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto row = [&]
    { return (random.Below(20u * unsigned(GetParam())) + 0.5) / double(GetParam()); };
    const auto nearly = [&](double line)
    {
      const double away = random.OneIn(4) ? 0.0 : std::pow(10.0, random.Between(-8.0, -1.0));
      return line + (random.OneIn(2) ? away : -away);
    };
    const double low = row(), high = low + random.Between(0.0, 9.0) + 1.0;
    const double wide = std::pow(10.0, random.Between(0.5, 4.0));
    Triangles quad;
    quad.AddQuad({ 20.0 - wide, nearly(low), 0.5 }, { 20.0 + wide, nearly(low), 0.5 },
      { 20.0 + wide, nearly(high), 0.5 }, { 20.0 - wide, nearly(high), 0.5 });
    covered += JudgeOnScreen(quad, RandomMargin(random), FewFacing::Front, random);
  }
  EXPECT_GT(covered, 1500);
}

// Of a quad that is nearly flat one plane stands for both of its triangles.
TEST_P(FewFacetsCoverage, IsTrueOfBentFacets)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 1000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double size = random.Between(3.0, 60.0);
    const auto corner = [&](double x, double y)
    {
      return glm::dvec3(20.0 + size * (x + random.Between(-0.2, 0.2)),
        10.0 + size * (y + random.Between(-0.2, 0.2)), 0.5 + random.Between(-0.002, 0.002) * size);
    };
    Triangles quad;
    quad.AddQuad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    covered += JudgeOnScreen(quad, RandomMargin(random), FewFacing::Front, random);
  }
  EXPECT_GT(covered, 200);
}

TEST_P(FewFacetsCoverage, IsTrueOfWhatIsHugeOrHasNoPlace)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 4000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    coverage::ScreenMatrix matrix = FewOnScreen::AsItStands(RandomMargin(random));
    for (int axis = 0; axis < 2; ++axis)
    {
      matrix.Matrix[axis][axis] =
        std::pow(10.0, random.Between(random.OneIn(2) ? 36.0 : 0.0, 38.7));
      matrix.Matrix[3][axis] = axis == 0 ? 20.0 : 10.0;
    }
    matrix.Matrix[2][2] = 0.3;
    matrix.Matrix[3][2] = 0.5;
    covered += JudgeIn(matrix, coverage::RandomFewFacets(random), FewFacing::Front, random);
  }
  EXPECT_GT(covered, 20);
}

TEST_P(FewFacetsCoverage, OfNumbersThatAreNoneIsNothing)
{
  const Triangles box = coverage::BoxBetween({ 2.5, 2.5, 0.2 }, { 30, 15, 0.5 });
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { std::nan(""), infinity, -infinity })
  {
    for (int i = 0; i < 16; ++i)
    {
      coverage::ScreenMatrix matrix = FewOnScreen::AsItStands();
      matrix.Matrix[i / 4][i % 4] = bad;
      for (const FewFacing facing : { FewFacing::Front, FewFacing::Back })
      {
        FewOnScreen few(GetParam());
        few.InsertIn(box, matrix, facing);
        EXPECT_EQ(few.Count(), 0u) << bad << " " << i;
      }
    }
  }
}
