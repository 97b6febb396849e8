// Which meshes have few facets that are looked at together, and what is told of those.

#include "FewFacetsScenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace
{

using coverage::Random;
using coverage::Triangles;
using vitrine::FewFacets;
using vitrine::LaneCount;
using vitrine::OccluderMesh;

const glm::dvec3 Corner(0.5, -0.25, 1.0);

Triangles BoxMesh()
{
  return coverage::BoxBetween({ -1, -2, -3 }, { 1, 2, 3 });
}

Triangles WedgeMesh()
{
  return coverage::WedgeOf({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0, 0, 3 });
}

Triangles TetrahedronMesh()
{
  return coverage::TetrahedronOf({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0, 0, 3 });
}

Triangles PyramidMesh()
{
  return coverage::PyramidOf({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.2, 0.1, 1.5 });
}

bool AreFewOf(const Triangles& triangles)
{
  return triangles.Mesh().Few() != nullptr;
}

glm::dvec3 PointOf(const OccluderMesh& mesh, std::int32_t i)
{
  return { mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i] };
}

glm::dvec3 OutwardsOfFew(const OccluderMesh& mesh, int facet)
{
  const auto& corners = mesh.Few()->Corners;
  const glm::dvec3 first = PointOf(mesh, corners[0][facet]);
  return glm::cross(
    PointOf(mesh, corners[1][facet]) - first, PointOf(mesh, corners[2][facet]) - first);
}

std::set<std::int32_t> CornersOf(const FewFacets& few, int facet)
{
  std::set<std::int32_t> corners;
  for (const auto& ofFacets : few.Corners)
  {
    corners.insert(ofFacets[facet]);
  }
  return corners;
}

/** Expects the facets of a mesh to have so many corners each, in any order, and edges on both sides. */
void ExpectFacets(const Triangles& triangles, std::vector<std::size_t> corners)
{
  const OccluderMesh mesh = triangles.Mesh();
  ASSERT_TRUE(mesh.Few());
  const FewFacets& few = *mesh.Few();
  const int facets = static_cast<int>(corners.size());
  glm::dvec3 inside(0.0);
  for (std::uint32_t i = 0; i < mesh.PointCount(); ++i)
  {
    inside += PointOf(mesh, static_cast<std::int32_t>(i)) / static_cast<double>(mesh.PointCount());
  }
  std::vector<std::size_t> found;
  std::size_t sum = 0;
  for (int facet = 0; facet < facets; ++facet)
  {
    found.push_back(CornersOf(few, facet).size());
    sum += found.back();
    const glm::dvec3 outwards = OutwardsOfFew(mesh, facet);
    EXPECT_GT(glm::dot(outwards, PointOf(mesh, few.Corners[0][facet]) - inside), 0.0);
    for (const std::int32_t corner : CornersOf(few, facet))
    {
      EXPECT_NEAR(glm::dot(outwards, PointOf(mesh, corner) - PointOf(mesh, few.Corners[0][facet])),
        0.0, 1e-5);
    }
  }
  std::sort(found.begin(), found.end());
  std::sort(corners.begin(), corners.end());
  EXPECT_EQ(found, corners);
  for (int facet = facets; facet < LaneCount; ++facet)
  {
    EXPECT_EQ(CornersOf(few, facet).size(), 1u) << "without extent";
  }

  std::size_t edges = 0;
  for (int i = 0; i < FewFacets::MostEdges; ++i)
  {
    if (few.Left[i] == 0 && few.Right[i] == 0)
    {
      continue;
    }
    ++edges;
    EXPECT_NE(few.Left[i], few.Right[i]);
    const glm::dvec3 from = PointOf(mesh, few.From[i]), along = PointOf(mesh, few.To[i]) - from;
    for (const auto& [bits, way] : { std::make_pair(few.Left[i], 1.0), { few.Right[i], -1.0 } })
    {
      const auto bit = static_cast<unsigned>(bits);
      ASSERT_EQ(vitrine::CountBits(bit), 1);
      const int facet = vitrine::LowestBit(bit);
      ASSERT_LT(facet, facets);
      const std::set<std::int32_t> own = CornersOf(few, facet);
      EXPECT_EQ(own.count(few.From[i]) + own.count(few.To[i]), 2u);
      glm::dvec3 middle(0.0);
      for (const std::int32_t corner : own)
      {
        middle += PointOf(mesh, corner) / static_cast<double>(own.size());
      }
      const glm::dvec3 turn = glm::cross(along, middle - from);
      EXPECT_GT(way * glm::dot(turn, OutwardsOfFew(mesh, facet)), 0.0) << "edge " << i;
    }
  }
  EXPECT_EQ(2 * edges, sum) << "each edge stands between two facets";
}

}

TEST(FewFacets, AreThoseOfConvexMeshesOfFewPoints)
{
  EXPECT_TRUE(AreFewOf(BoxMesh()));
  EXPECT_TRUE(AreFewOf(WedgeMesh()));
  EXPECT_TRUE(AreFewOf(TetrahedronMesh()));
  EXPECT_TRUE(AreFewOf(PyramidMesh()));
  Triangles triangle;
  triangle.Add(Corner, { 2, 0, 0 }, { 0, 3, 1 });
  EXPECT_TRUE(AreFewOf(triangle));
  EXPECT_TRUE(AreFewOf(coverage::QuadOf(Corner, { 1, 0, 1 }, { 0, 1, 0.5 }, 0.3)));
}

TEST(FewFacets, HaveCornersAndTheEdgesBetweenThem)
{
  ExpectFacets(BoxMesh(), { 4, 4, 4, 4, 4, 4 });
  ExpectFacets(WedgeMesh(), { 3, 3, 4, 4, 4 });
  ExpectFacets(TetrahedronMesh(), { 3, 3, 3, 3 });
  ExpectFacets(PyramidMesh(), { 4, 3, 3, 3, 3 });
}

TEST(FewFacets, OfOneFacetHaveEdgesWithNothingOnTheirRight)
{
  for (const bool isQuad : { false, true })
  {
    Triangles one = coverage::QuadOf(Corner, { 1, 0, 1 }, { 0, 1, 0.5 }, 0.3);
    one.Corners.resize(isQuad ? 6 : 3);
    one.Points.resize(one.Corners.size());
    const OccluderMesh mesh = one.Mesh();
    ASSERT_TRUE(mesh.Few());
    const FewFacets& few = *mesh.Few();
    EXPECT_EQ(CornersOf(few, 0).size(), isQuad ? 4u : 3u);
    std::set<std::int32_t> starts, ends;
    for (int i = 0; i < FewFacets::MostEdges; ++i)
    {
      EXPECT_EQ(few.Right[i], 0);
      if (few.Left[i] != 0)
      {
        EXPECT_EQ(few.Left[i], 1);
        starts.insert(few.From[i]);
        ends.insert(few.To[i]);
      }
    }
    EXPECT_EQ(starts, CornersOf(few, 0)) << "goes around it once";
    EXPECT_EQ(ends, starts);
  }
}

TEST(FewFacets, AreNotThoseOfOpenMeshes)
{
  Triangles open = BoxMesh();
  open.Corners.resize(open.Corners.size() - 6);
  EXPECT_FALSE(AreFewOf(open));
  open = BoxMesh();
  open.Corners.resize(open.Corners.size() - 3);
  EXPECT_FALSE(AreFewOf(open));
  Triangles apart;
  apart.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  apart.AddQuad({ 2, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 2, 1, 0 });
  EXPECT_FALSE(AreFewOf(apart)) << "two rectangles in a plane";
  Triangles book;
  book.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  book.AddQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 1 }, { 1, 1, 0 });
  EXPECT_FALSE(AreFewOf(book)) << "two that meet in an edge";
}

TEST(FewFacets, AreNotThoseOfWhatIsNotConvex)
{
  Triangles bracket;
  bracket.AddQuad({ 0, 0, 0 }, { 3, 0, 0 }, { 1, 1, 0 }, { 0, 3, 0 });
  EXPECT_FALSE(AreFewOf(bracket)) << "a quad with a corner inside";
  Triangles angle;
  angle.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 });
  angle.AddQuad({ 0, 0, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 });
  EXPECT_FALSE(AreFewOf(angle)) << "an L";
  Triangles dart; // a tetrahedron of which another one is taken out from below
  const glm::dvec3 a(1, 0, 0), b(-0.5, 0.9, 0), c(-0.5, -0.9, 0), tip(0, 0, 1), inner(0, 0, 0.4);
  for (const auto& [from, to] : { std::make_pair(a, b), { b, c }, { c, a } })
  {
    dart.Add(from, to, tip);
    dart.Add(to, from, inner);
  }
  EXPECT_FALSE(AreFewOf(dart));
  Triangles twisted = BoxMesh();
  for (glm::dvec3& point : twisted.Points)
  {
    point.x *= point.z > 0.0 ? 1.0 : -1.0; // two sides go through each other
  }
  EXPECT_FALSE(AreFewOf(twisted));
}

TEST(FewFacets, AreNotThoseOfFacetsThatAreCutIntoMoreThanTwoFaces)
{
  const glm::dvec3 a(-0.5, 0, 0), b(0.5, 0, 0), c(0, 1, 0), inside(0, 1e-5, 0);
  Triangles fan;
  fan.Add(inside, c, a);
  fan.Add(inside, b, c);
  EXPECT_TRUE(AreFewOf(fan)) << "two, and next to nothing is missing";
  fan.Add(a, b, inside);
  EXPECT_FALSE(AreFewOf(fan));
}

TEST(FewFacets, AreNotThoseOfMeshesThatAreTurnedInsideOut)
{
  Triangles box = BoxMesh();
  for (std::size_t i = 0; i < box.Corners.size(); i += 3)
  {
    std::swap(box.Corners[i], box.Corners[i + 1]);
  }
  EXPECT_FALSE(AreFewOf(box));
}

TEST(FewFacets, AreNotThoseOfMeshesOfMorePointsOrFacets)
{
  Triangles house = BoxMesh(); // with a roof in place of its top
  house.Corners.erase(house.Corners.begin() + 6, house.Corners.begin() + 12);
  const glm::dvec3 roof[] = { { -1, -2, 3 }, { 1, -2, 3 }, { 1, 2, 3 }, { -1, 2, 3 } };
  for (int i = 0; i < 4; ++i)
  {
    house.Add(roof[i], roof[(i + 1) % 4], { 0, 0, 4 });
  }
  const OccluderMesh mesh = house.Mesh();
  EXPECT_EQ(mesh.PointCount(), 9u);
  EXPECT_TRUE(mesh.IsClosed());
  EXPECT_FALSE(mesh.Few());
  Random random(1);
  EXPECT_FALSE(AreFewOf(coverage::BallOf(12, 8, 1.0, random)));
  EXPECT_FALSE(AreFewOf(coverage::BallOf(6, 2, 1.0, random))) << "eight points, twelve facets";
  Triangles hexagon;
  for (int i = 1; i + 1 < 6; ++i)
  {
    const auto at = [](int k) {
      return glm::dvec3(
        std::cos(k * glm::pi<double>() / 3), std::sin(k * glm::pi<double>() / 3), 0);
    };
    hexagon.Add(at(0), at(i), at(i + 1));
  }
  EXPECT_FALSE(AreFewOf(hexagon)) << "a facet of six corners";
  EXPECT_FALSE(OccluderMesh().Few());
}

TEST(FewFacets, AreThereOfMostThatAreConvex)
{
  int few = 0;
  for (unsigned seed = 1; seed <= 500; ++seed)
  {
    Random random(seed);
    few += AreFewOf(coverage::RandomFewFacets(random));
  }
  EXPECT_GT(few, 350);
}
