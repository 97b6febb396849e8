// Which faces are one polygon.

#include "OccluderScenes.h"

#include "Core/culling/mesh/MeshFacets.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

using coverage::BoxBetween;
using coverage::OccluderMesh;
using coverage::Triangles;
using vitrine::MeshEdge;
using vitrine::MeshFacets;

std::size_t CornersOf(const MeshFacets& facets, std::size_t facet)
{
  return facets.CornerEnds()[facet] - (facet == 0 ? 0 : facets.CornerEnds()[facet - 1]);
}

/** A tube of so many sides around z. */
Triangles Tube(int sides)
{
  Triangles tube;
  for (int i = 0; i < sides; ++i)
  {
    const double a = 2.0 * glm::pi<double>() * i / sides;
    const double b = 2.0 * glm::pi<double>() * ((i + 1) % sides) / sides;
    tube.AddQuad({ std::cos(a), std::sin(a), 0 }, { std::cos(b), std::sin(b), 0 },
      { std::cos(b), std::sin(b), 1 }, { std::cos(a), std::sin(a), 1 });
  }
  return tube;
}

MeshFacets FacetsOf(const OccluderMesh& mesh)
{
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    points.emplace_back(mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i]);
  }
  return MeshFacets(points, mesh.Faces(), mesh.Edges());
}

}

TEST(MeshFacets, OfABoxAreItsSides)
{
  const OccluderMesh mesh = BoxBetween({ -1, -2, -3 }, { 1, 2, 3 }).Mesh();
  const MeshFacets facets = FacetsOf(mesh);
  ASSERT_EQ(facets.Count(), 6u);
  EXPECT_EQ(facets.Edges().size(), 12u);
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(CornersOf(facets, i), 4u);
  }
  for (const MeshEdge& edge : facets.Edges())
  {
    EXPECT_NE(edge.Left, edge.Right);
    EXPECT_LT(edge.Right, 6u);
  }
}

TEST(MeshFacets, OfASheetEndAtItsBorder)
{
  Triangles sheet;
  sheet.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 });
  const OccluderMesh mesh = sheet.Mesh();
  ASSERT_EQ(FacetsOf(mesh).Count(), 1u);
  ASSERT_EQ(FacetsOf(mesh).Edges().size(), 4u);
  const MeshFacets sides = FacetsOf(mesh);
  for (const MeshEdge& edge : sides.Edges())
  {
    EXPECT_EQ(edge.Right, 1u);
  }
}

TEST(MeshFacets, DoNotGoAroundWhatBendsLittleByLittle)
{
  // 0.5 degrees from side to side: less than what a facet may have, but not three times.
  const OccluderMesh mesh = Tube(720).Mesh();
  EXPECT_GT(FacetsOf(mesh).Count(), 720u / 4);
  EXPECT_LE(FacetsOf(mesh).Count(), 720u / 2);
  EXPECT_EQ(FacetsOf(Tube(360).Mesh()).Count(), 360u);
}

TEST(MeshFacets, FacesWithoutExtentBelongToTheirNeighbours)
{
  // Three points in a row on the edge between two halves of a square.
  Triangles square;
  square.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  square.Corners = { 0, 1, 2, 0, 4, 3, 4, 2, 3, 0, 2, 4 };
  const OccluderMesh mesh = square.Mesh();
  EXPECT_EQ(FacetsOf(mesh).Count(), 1u);
  EXPECT_EQ(FacetsOf(mesh).Edges().size(), 4u);
}

TEST(MeshFacets, OfFacesWithoutExtentAlone)
{
  Triangles line;
  line.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  line.Corners = { 0, 1, 2 };
  const OccluderMesh mesh = line.Mesh();
  EXPECT_EQ(FacetsOf(mesh).Count(), 1u);
  EXPECT_EQ(FacetsOf(OccluderMesh()).Count(), 0u);
}

TEST(MeshFacets, AreShownByTheirLargestFace)
{
  Triangles fan;
  fan.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.01, 0 }, { 0, 5, 0 } };
  fan.Corners = { 0, 1, 2, 0, 2, 3 };
  const OccluderMesh mesh = fan.Mesh();
  ASSERT_EQ(FacetsOf(mesh).Count(), 1u);
  const vitrine::MeshFace largest = FacetsOf(mesh).LargestFaces()[0];
  const std::set<std::uint32_t> corners(largest.begin(), largest.end());
  EXPECT_EQ(std::set<std::uint32_t>(mesh.Faces()[1].begin(), mesh.Faces()[1].end()), corners);
}
