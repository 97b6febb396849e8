// Whatever the mesh and the view: what an s-buffer says is covered is covered, and nowhere farther than it says.

#include "CoverageSubjects.h"
#include "CoverageWays.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::CoverageJudge;
using coverage::DrawnBy;
using coverage::ExactlyDrawn;
using coverage::FacesAsTheyStand;
using coverage::Facing;
using coverage::MostTestSpans;
using coverage::PlaceOfPoint;
using coverage::Random;
using coverage::ScreenFace;
using coverage::Subject;
using coverage::Triangles;
using coverage::View;
using coverage::Way;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::SBuffer;

Subject RandomSubject(Random& random)
{
  Triangles triangles = coverage::RandomTriangles(random);
  if (random.OneIn(3))
  {
    coverage::Damage(triangles, random);
  }
  return coverage::SubjectOf(triangles, random);
}

struct Tally
{
  int Covered = 0;
  int Wrong = 0;
};

/** Puts one side of a subject into an s-buffer and has it judged. */
void Judge(const Way& way, const Subject& subject, Facing facing, Random& random, Tally& tally)
{
  MeshProjection projection;
  projection.Project(subject.Mesh, subject.Seen.Projection(subject.Reach).Of(glm::dmat4(1.0)));
  projection.FindFacings();
  SBuffer buffer(subject.Seen.Columns, subject.Seen.Lines, way.Samples(), MostTestSpans);
  vitrine::FaceCoverage().Insert(buffer, projection, facing, 0);
  if (coverage::CoveredArea(buffer) == 0.0)
  {
    return;
  }
  ++tally.Covered;
  const auto drawn = [&]
  { return DrawnBy(projection, subject.Seen, subject.Reach, facing, random); };
  for (const std::vector<ScreenFace>& faces :
    { ExactlyDrawn(subject, facing, random), drawn(), drawn() })
  {
    const CoverageJudge judge(faces, way.Inset());
    const std::string wrong = judge.WhatIsWrong(buffer, random.Generator, 4);
    EXPECT_EQ(wrong, "");
    tally.Wrong += !wrong.empty();
  }
}

/** The corner of a convex mesh's outline is that of its faces in front: they overlap nowhere. */
double FrontArea(const Subject& subject)
{
  double area = 0.0;
  for (const ScreenFace& face : coverage::DrawnFaces(subject.Mesh, subject.Seen, Facing::Front,
         [&](std::uint32_t i)
         { return glm::dvec3(subject.Seen.OnScreen(PlaceOfPoint(subject.Mesh, i))); }))
  {
    area += 0.5 * coverage::TurnOf(face);
  }
  return area;
}

/** Of meshes whose points are columns, lines and depths themselves. */
const vitrine::ScreenMatrix PlainScreen{ glm::dmat4(1.0), glm::vec4(0.0f), {}, { 40, 20 } };

}

class CoverageIsTrue : public coverage::EachWay
{
};

INSTANTIATE_TEST_SUITE_P(
  Ways, CoverageIsTrue, ::testing::ValuesIn(coverage::AllWays), coverage::NameOfParameter);

TEST_P(CoverageIsTrue, OfRandomMeshesInRandomViews)
{
  Tally tally;
  for (unsigned seed = 1; seed <= 150 && tally.Wrong < 5; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Subject subject = RandomSubject(random);
    Judge(GetParam(), subject, Facing::Front, random, tally);
    Judge(GetParam(), subject, Facing::Back, random, tally);
  }
  EXPECT_GT(tally.Covered, 150);
}

// Several sheets behind each other, some of which are joined elsewhere.
TEST_P(CoverageIsTrue, OfShellsOpenAndClosed)
{
  Tally tally;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Triangles shell =
      coverage::ShellOf(1.0, std::pow(10.0, random.Between(-3.0, -0.3)), random.OneIn(2));
    const Subject subject{ shell.Mesh(), coverage::RandomView(glm::dvec3(0.0), random), 1.0 };
    Judge(GetParam(), subject, Facing::Front, random, tally);
    Judge(GetParam(), subject, Facing::Back, random, tally);
  }
  EXPECT_GT(tally.Covered, 60);
}

TEST_P(CoverageIsTrue, OfManyMeshesInOneBuffer)
{
  for (unsigned seed = 1; seed <= 25; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const View view = coverage::RandomView(glm::dvec3(0.0), random);
    SBuffer buffer(view.Columns, view.Lines, GetParam().Samples(), MostTestSpans);
    vitrine::FaceCoverage inserter;
    MeshProjection projection;
    std::vector<ScreenFace> faces;
    for (int i = 0; i < 12; ++i)
    {
      Triangles triangles = coverage::RandomTriangles(random);
      const glm::dvec3 place = random.Point(-2, 2);
      for (glm::dvec3& point : triangles.Points)
      {
        point = place + 0.5 * point;
      }
      const OccluderMesh mesh = triangles.Mesh();
      projection.Project(mesh, view.Projection(3.0).Of(glm::dmat4(1.0)));
      projection.FindFacings();
      for (const Facing facing : { Facing::Front, Facing::Back })
      {
        inserter.Insert(buffer, projection, facing, 0);
        const std::vector<ScreenFace> drawn = DrawnBy(projection, view, 3.0, facing, random);
        faces.insert(faces.end(), drawn.begin(), drawn.end());
      }
    }
    ASSERT_EQ(
      CoverageJudge(faces, GetParam().Inset()).WhatIsWrong(buffer, random.Generator, 2), "");
  }
}

// Planes of faces that reach far beyond the screen are known to a part of what their corners' depths differ by.
TEST_P(CoverageIsTrue, OfLongSlimFaces)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double length = std::pow(10.0, random.Between(1.0, 5.5));
    const double turn = random.Between(0.0, glm::two_pi<double>());
    const glm::dvec3 along(length * std::cos(turn), length * std::sin(turn), 0.0);
    const glm::dvec3 aside = random.Between(0.8, 6.0) * glm::dvec3(-along.y, along.x, 0.0) / length;
    const glm::dvec3 middle(20.0, 10.0, 0.5);
    const auto corner = [&](double a, double b)
    {
      return middle + (a + random.Between(-0.3, 0.3)) * along + b * aside +
        glm::dvec3(0, 0, random.Between(-0.5, 0.49));
    };
    Triangles plank;
    plank.AddQuad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    const OccluderMesh mesh = plank.Mesh();
    MeshProjection projection;
    projection.Project(mesh, PlainScreen);
    projection.FindFacings();
    SBuffer buffer(40, 20, GetParam().Samples(), MostTestSpans);
    vitrine::FaceCoverage().Insert(buffer, projection, Facing::Front, 0);
    covered += coverage::CoveredArea(buffer) > 0.0;
    const CoverageJudge judge(FacesAsTheyStand(projection), GetParam().Inset());
    ASSERT_EQ(judge.WhatIsWrong(buffer, random.Generator, 4), "");
  }
  EXPECT_GT(covered, 500);
}

// A steep face takes the bound of a cell far down on one side; its numbers must not be coarse on the other side.
TEST_P(CoverageIsTrue, OfFlatFacesBesideSteepOnes)
{
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double depth = random.Between(0.6, 0.95), edge = random.Between(9.0, 31.0);
    const double start = edge - std::pow(10.0, random.Between(-4.0, 0.0));
    const double low = depth - std::pow(10.0, random.Between(-3.0, -0.3));
    const bool isLeft = random.OneIn(2);
    const auto at = [&](double column, double line, double z)
    { return glm::dvec3(isLeft ? column : 40.0 - column, line, z); };
    Triangles step;
    step.AddQuad(at(start, -1, low), at(edge, -1, depth), at(edge, 21, depth), at(start, 21, low));
    step.AddQuad(at(edge, -1, depth), at(41, -1, depth), at(41, 21, depth), at(edge, 21, depth));
    const OccluderMesh mesh = step.Mesh();
    MeshProjection projection;
    projection.Project(mesh, PlainScreen);
    projection.FindFacings();
    SBuffer buffer(40, 20, GetParam().Samples(), MostTestSpans);
    const Facing facing = isLeft ? Facing::Front : Facing::Back;
    vitrine::FaceCoverage().Insert(buffer, projection, facing, 0);
    ASSERT_GT(coverage::CoveredArea(buffer), 0.0);
    const CoverageJudge judge(FacesAsTheyStand(projection), GetParam().Inset());
    ASSERT_EQ(judge.WhatIsWrong(buffer, random.Generator, 1), "");
  }
}

// What inserts nothing would be true as well.
TEST_P(CoverageIsTrue, AndMostOfIt)
{
  for (unsigned seed = 1; seed <= 120; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Triangles triangles = seed % 2 == 0
      ? coverage::BoxBetween(glm::dvec3(-0.7), glm::dvec3(0.7))
      : coverage::BallOf(6 + random.Below(30), 4 + random.Below(20), 1.0, random);
    const Subject subject{ triangles.Mesh(), coverage::WholeView(40, seed % 3 == 0, random), 1.0 };
    MeshProjection projection;
    EXPECT_TRUE(
      projection.Project(subject.Mesh, subject.Seen.Projection(subject.Reach).Of(glm::dmat4(1.0))));
    projection.FindFacings();
    SBuffer buffer(subject.Seen.Columns, subject.Seen.Lines, GetParam().Samples(), MostTestSpans);
    vitrine::FaceCoverage().Insert(buffer, projection, Facing::Front, 0);
    const double area = FrontArea(subject);
    EXPECT_GT(area, 700.0);
    EXPECT_GT(coverage::CoveredArea(buffer), 0.85 * area);
    if (GetParam().PixelsPerLine == 0)
    {
      EXPECT_LT(coverage::CoveredArea(buffer), area);
    }
  }
}
