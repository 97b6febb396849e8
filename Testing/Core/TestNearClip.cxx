// What the near plane leaves of a mesh, and what that covers.

#include "CoveredScreen.h"
#include "DeviceFaces.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace
{

using coverage::AsItStands;
using coverage::CoveredArea;
using coverage::DeviceFaces;
using coverage::Facing;
using coverage::MostTestSpans;
using coverage::Random;
using coverage::SBuffer;
using coverage::ScreenMatrix;
using coverage::Span;
using coverage::Triangles;
using coverage::View;
using coverage::Way;
using coverage::WideColumns;
using coverage::WideLines;
using vitrine::MeshEdge;
using vitrine::MeshFace;
using vitrine::MeshProjection;
using vitrine::NearClip;
using vitrine::OccluderMesh;

const double Nearest = 0.1, Farthest = 100.0; // planes

/** From the origin along -z; what is as far to the side as ahead is at half the width of the screen from its middle. */
View FromTheOrigin(double nearest)
{
  View view;
  view.Columns = WideColumns;
  view.Lines = WideLines;
  view.IsParallel = false;
  view.Eye = glm::dvec3(0.0);
  view.ToClip = glm::perspective(glm::half_pi<double>(), 2.0, nearest, Farthest);
  return view;
}

double ReversedDepth(double ahead, double nearest)
{
  return nearest * (Farthest - ahead) / (ahead * (Farthest - nearest));
}

/** What stands around the eye covers of the screen. */
class Within
{
public:
  Within(const Way& way, const Triangles& triangles, Facing facing, double reach,
    double nearest = Nearest)
    : NearPlane(nearest)
    , Buffer(WideColumns, WideLines, way.Samples(), MostTestSpans)
  {
    const OccluderMesh mesh = triangles.Mesh();
    EXPECT_FALSE(
      this->Projection.Project(mesh, FromTheOrigin(nearest).Projection(reach).Of(glm::dmat4(1.0))));
    this->Projection.FindFacings();
    vitrine::FaceCoverage().Insert(this->Buffer, this->Projection, facing, 7);
    this->WidestMargin = this->Projection.Margin().Depth;
    this->IsCutFarther =
      this->Projection.ClipFarther(FromTheOrigin(nearest).Projection(reach).Of(glm::dmat4(1.0)));
    this->Projection.FindFacings();
    vitrine::FaceCoverage().Insert(this->Buffer, this->Projection, facing, 7);
  }

  double Area() const { return CoveredArea(this->Buffer); }

  void ExpectFromTo(int line, double left, double right) const
  {
    SCOPED_TRACE(line);
    const std::vector<Span> spans = this->Buffer.SpansOf(line);
    ASSERT_FALSE(spans.empty());
    EXPECT_NEAR(spans.front().Left, left, 0.1);
    EXPECT_NEAR(spans.back().Right, right, 0.1);
    for (std::size_t i = 0; i + 1 < spans.size(); ++i)
    {
      EXPECT_GE(this->Buffer.Samples().From(spans[i].Right), spans[i + 1].Left);
    }
  }

  /** At most the plane's depth, and no less than that by more than a few of the widest margins. */
  void ExpectDepth(int line, double column, double ahead) const
  {
    const double depth = ReversedDepth(ahead, this->NearPlane);
    EXPECT_LE(this->DepthAt(line, column), depth);
    EXPECT_NEAR(this->DepthAt(line, column), depth, 3.0 * this->WidestMargin);
  }

  /** Or -1 where nothing is covered. */
  double DepthAt(int line, double column) const
  {
    for (const Span& span : this->Buffer.SpansOf(line))
    {
      if (span.Left <= column && column < span.Right)
      {
        return span.DepthAt(static_cast<float>(column));
      }
    }
    return -1.0;
  }

  double NearPlane;
  double WidestMargin = 0.0;
  bool IsCutFarther = false;
  MeshProjection Projection;
  SBuffer Buffer;
};

/** Level, below the eye, from behind it to so far ahead; it looks upwards. */
Triangles Floor(double below, double ahead)
{
  Triangles floor;
  floor.AddQuad(
    { -90, -below, 20 }, { 90, -below, 20 }, { 90, -below, -ahead }, { -90, -below, -ahead });
  return floor;
}

/** The one face of a mesh whose points are columns, lines and depths, the near plane at 1. */
OccluderMesh FaceOfDepths(double a, double b, double c)
{
  Triangles triangle;
  triangle.Add({ 4, 4, a }, { 12, 4, b }, { 4, 12, c });
  return triangle.Mesh();
}

double AreaOf(const MeshProjection& projection)
{
  double area = 0.0;
  for (const MeshFace& face : projection.Faces())
  {
    const auto place = [&](int i)
    {
      const vitrine::ScreenPoint point = projection.Point(face[i]);
      return glm::dvec3(point.Column, point.Line, point.Depth);
    };
    EXPECT_LE(std::max({ place(0).z, place(1).z, place(2).z }), 1.0);
    area += 0.5 * coverage::TurnOf({ place(0), place(1), place(2) });
  }
  return area;
}

int PlaceIn(const MeshFace& face, std::uint32_t point)
{
  return static_cast<int>(std::find(face.begin(), face.end(), point) - face.begin());
}

}

TEST(NearClip, KeepsWhatIsBehind)
{
  const struct
  {
    double A, B, C;
    std::size_t Faces;
    double Area;
  } cases[] = {
    { 1.25, 1.5, 2.0, 0, 0.0 }, { 0.5, 1.5, 1.5, 1, 8.0 }, // half of each side from a
    { 1.5, 0.5, 1.5, 1, 8.0 }, { 1.5, 1.5, 0.5, 1, 8.0 }, { 1.5, 0.5, 0.5, 2, 24.0 },
    { 0.5, 1.5, 0.5, 2, 24.0 }, { 0.5, 0.5, 1.5, 2, 24.0 },
    { 0.5, 0.75, 1.25, 2,
      32.0 * (1.0 - 0.5 / 3.0) }, // cuts 1/2 of one side off and 1/3 of the other
  };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(testing::PrintToString(std::vector<double>{ one.A, one.B, one.C }));
    const OccluderMesh mesh = FaceOfDepths(one.A, one.B, one.C);
    MeshProjection projection;
    EXPECT_FALSE(projection.Project(mesh, AsItStands()));
    projection.FindFacings();
    EXPECT_EQ(projection.Faces().size(), one.Faces);
    EXPECT_NEAR(AreaOf(projection), one.Area, 1e-4);
    for (std::uint32_t i = 0; i < one.Faces; ++i)
    {
      EXPECT_EQ(projection.FacingOf(i), Facing::Front);
    }
  }
}

TEST(NearClip, HasARectangleAroundWhatIsLeft)
{
  MeshProjection projection;
  const OccluderMesh mesh = FaceOfDepths(0.5, 1.5, 1.5);
  projection.Project(mesh, AsItStands({ 0.5f, 0.25f, 0.125f }));
  EXPECT_NEAR(projection.Rectangle().Left, 3.5, 1e-4);
  EXPECT_NEAR(projection.Rectangle().Right, 8.5, 1e-4);
  EXPECT_NEAR(projection.Rectangle().Bottom, 3.75, 1e-4);
  EXPECT_NEAR(projection.Rectangle().Top, 8.25, 1e-4);
  EXPECT_NEAR(projection.Rectangle().Nearest, 1.125, 1e-4);
}

// Each side of each face belongs to one edge, whose faces go through it in opposite directions. Only a cut opens edges.
TEST(NearClip, KeepsNeighbours)
{
  int cut = 0;
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Triangles triangles = coverage::RandomTriangles(random);
    if (random.OneIn(2))
    {
      coverage::Damage(triangles, random);
    }
    const OccluderMesh mesh = triangles.Mesh();
    const View view = coverage::RandomView(random.Point(-0.5, 0.5), random);
    const ScreenMatrix matrix = view.Projection(2.0).Of(glm::dmat4(1.0));
    NearClip clip;
    clip.Clip(mesh, matrix, 1.0);
    cut += !clip.Cuts().empty();
    const std::uint32_t firstCut = static_cast<std::uint32_t>(mesh.Coordinates(0).size());
    std::vector<std::array<int, 3>> sides(clip.Faces().size(), { 0, 0, 0 });
    std::size_t borders = 0;
    for (const MeshEdge& edge : clip.Edges())
    {
      const MeshFace& left = clip.Faces().at(edge.Left);
      const int place = PlaceIn(left, edge.From);
      ASSERT_LT(place, 3);
      EXPECT_EQ(left[(place + 1) % 3], edge.To);
      ++sides[edge.Left][place];
      if (edge.Right == OccluderMesh::NoFace)
      {
        borders += edge.From < firstCut || edge.To < firstCut;
        continue;
      }
      const MeshFace& right = clip.Faces().at(edge.Right);
      const int back = PlaceIn(right, edge.To);
      ASSERT_LT(back, 3);
      EXPECT_EQ(right[(back + 1) % 3], edge.From);
      ++sides[edge.Right][back];
    }
    for (const auto& ofFace : sides)
    {
      EXPECT_EQ(ofFace, (std::array<int, 3>{ 1, 1, 1 }));
    }
    EXPECT_TRUE(borders == 0 || !mesh.IsClosed());
  }
  EXPECT_GT(cut, 50);
}

TEST(NearClip, KnowsWhatFacesAreLeftOf)
{
  for (unsigned seed = 1; seed <= 100; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const OccluderMesh mesh = coverage::RandomTriangles(random).Mesh();
    const View view = coverage::RandomView(random.Point(-0.5, 0.5), random);
    NearClip clip;
    clip.Clip(mesh, view.Projection(2.0).Of(glm::dmat4(1.0)), 1.0);
    ASSERT_EQ(clip.Sources().size(), clip.Faces().size());
    for (std::size_t i = 0; i < clip.Faces().size(); ++i)
    {
      const MeshFace& source = mesh.Faces().at(clip.Sources()[i]);
      int behind = 0;
      for (const std::uint32_t corner : clip.Faces()[i])
      {
        behind += PlaceIn(source, corner) < 3;
        EXPECT_TRUE(PlaceIn(source, corner) < 3 || corner >= mesh.Coordinates(0).size());
      }
      EXPECT_GE(behind, 1);
    }
  }
}

TEST(NearClip, OfNoPointsOrNumbersThatAreNoneIsNothing)
{
  NearClip clip;
  clip.Clip(OccluderMesh(), AsItStands(), 1.0);
  EXPECT_TRUE(clip.Faces().empty());
  EXPECT_TRUE(clip.Edges().empty());
  ScreenMatrix broken = AsItStands();
  broken.Matrix[3] = glm::dvec4(std::nan(""));
  clip.Clip(FaceOfDepths(0.5, 1.5, 1.5), broken, 1.0);
  EXPECT_TRUE(clip.Faces().empty());
  EXPECT_TRUE(clip.Cuts().empty());
}

class CoverageWithin : public coverage::EachWay
{
};

INSTANTIATE_TEST_SUITE_P(Ways, CoverageWithin,
  ::testing::Values(Way{ 0 }, Way{ 1 }, Way{ 2 }, Way{ 4 }), coverage::NameOfParameter);

TEST_P(CoverageWithin, OfAFloorUnderTheEyeIsAllBelowItsFarEnd)
{
  const Within within(GetParam(), Floor(1.0, 50.0), Facing::Front, 100.0);
  const auto ahead = [](double line) { return 10.0 / (10.0 - line); };
  for (int line = 0; line < WideLines; ++line)
  {
    if (line + 1 - GetParam().Inset() < 9.7)
    {
      within.ExpectFromTo(line, 0.0, WideColumns);
      within.ExpectDepth(line, 13.0, ahead(line + 1 - GetParam().Inset()));
    }
    else if (line + 1 - GetParam().Inset() > 9.8)
    {
      EXPECT_TRUE(within.Buffer.SpansOf(line).empty()) << line;
    }
  }
  EXPECT_EQ(Within(GetParam(), Floor(1.0, 50.0), Facing::Back, 100.0).Area(), 0.0);
}

// Right at the eye next to nothing is known of where a device draws: it does not spoil the rest.
TEST_P(CoverageWithin, IsKnownWhereTheNearPlaneIsCloseToTheEye)
{
  const double nearest = 0.01;
  const Within within(GetParam(), Floor(1.0, 50.0), Facing::Front, 100.0, nearest);
  const double ahead = 10.0 / (1.0 + GetParam().Inset());
  within.ExpectFromTo(8, 0.0, WideColumns);
  within.ExpectDepth(8, 13.0, ahead);
  EXPECT_TRUE(within.IsCutFarther);
  EXPECT_GT(within.DepthAt(8, 13.0), 0.8 * ReversedDepth(ahead, nearest));
}

TEST_P(CoverageWithin, OfAWallBesideTheEyeIsAllUpToItsFarEnd)
{
  Triangles wall;
  wall.AddQuad({ 1, -90, 20 }, { 1, 90, 20 }, { 1, 90, -50 }, { 1, -90, -50 });
  const Within within(GetParam(), wall, Facing::Front, 100.0);
  for (int line = 0; line < WideLines; ++line)
  {
    within.ExpectFromTo(line, 20.2, WideColumns);
    within.ExpectDepth(line, 30.0, 1.0);
  }
}

TEST_P(CoverageWithin, OfABoxAroundTheEyeIsEverything)
{
  const Triangles box = coverage::BoxBetween({ -3, -2.1, -9 }, { 4, 5, 7 });
  const Within within(GetParam(), box, Facing::Back, 9.0);
  for (int line = 0; line < WideLines; ++line)
  {
    within.ExpectFromTo(line, 0.0, WideColumns);
  }
  within.ExpectDepth(10, 20.0, 9.0);
  within.ExpectDepth(10, 1.0, 30.0 / 19.0);
  within.ExpectDepth(10, 38.0, 40.0 / 18.0);
  EXPECT_EQ(Within(GetParam(), box, Facing::Front, 9.0).Area(), 0.0);
}

TEST_P(CoverageWithin, OfABoxWithAWindowLeavesThatOpen)
{
  Triangles box = coverage::BoxBetween({ -3, -2, -9 }, { 4, 5, 7 });
  box.Corners.erase(box.Corners.begin(), box.Corners.begin() + 6); // the side ahead
  const Within within(GetParam(), box, Facing::Back, 9.0);
  EXPECT_GT(within.Area(), 100.0);
  for (const Span& span : within.Buffer.SpansOf(10))
  {
    EXPECT_TRUE(span.Right <= 20.0 - 10.0 * 3.0 / 9.0 || span.Left >= 20.0 + 10.0 * 4.0 / 9.0);
  }
}

TEST_P(CoverageWithin, OfRandomMeshesAroundTheEyeIsTrue)
{
  int covered = 0;
  for (unsigned seed = 1; seed <= 250; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Triangles triangles = coverage::RandomTriangles(random);
    if (random.OneIn(3))
    {
      coverage::Damage(triangles, random);
    }
    const OccluderMesh mesh = triangles.Mesh();
    View view = coverage::RandomView(random.Point(-0.3, 0.3), random);
    const double reach = std::pow(10.0, random.Between(0.0, 4.0)); // the larger, the wider margins
    const ScreenMatrix matrix = view.Projection(reach).Of(glm::dmat4(1.0));
    MeshProjection projection;
    if (projection.Project(mesh, matrix))
    {
      continue;
    }
    for (const Facing facing : { Facing::Front, Facing::Back })
    {
      SBuffer buffer(view.Columns, view.Lines, GetParam().Samples(), MostTestSpans);
      projection.Project(mesh, matrix);
      projection.FindFacings();
      vitrine::FaceCoverage().Insert(buffer, projection, facing, 0);
      projection.ClipFarther(matrix);
      projection.FindFacings();
      vitrine::FaceCoverage().Insert(buffer, projection, facing, 0);
      covered += CoveredArea(buffer) > 0.0;
      for (const bool isMoved : { false, true, true })
      {
        const DeviceFaces drawn(mesh, matrix, isMoved, random.Generator);
        ASSERT_EQ(coverage::CoverageJudge(drawn.Facing(facing), GetParam().Inset())
                    .WhatIsWrong(buffer, random.Generator, 3),
          "");
      }
    }
  }
  EXPECT_GT(covered, 60);
}
