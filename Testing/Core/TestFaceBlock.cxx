// Where blocks of faces are on the screen, held to what is known of each face by itself.
#include "NonFinite.h"
#include "OccluderScenes.h"

#include "Core/culling/steady/DepthPlane.h"
#include "Core/culling/steady/FaceBlock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using coverage::PlainMatrix;
using coverage::Random;
using coverage::Triangles;
using vitrine::DepthPlane;
using vitrine::FaceBlock;
using vitrine::LaneCount;
using vitrine::MeshFace;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::ScreenMatrix;
using vitrine::ScreenRectangle;

const unsigned AllFaces = (1u << LaneCount) - 1u;

/** Some faces of any shape, and some as thin as slivers. */
Triangles RandomFaces(int count, Random& random)
{
  Triangles faces;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 a = random.Point(0.1, 0.9), b = random.Point(0.1, 0.9);
    const glm::dvec3 c =
      random.OneIn(3) ? 0.5 * (a + b) + 1e-4 * random.Point(-1.0, 1.0) : random.Point(0.1, 0.9);
    const glm::dvec3 toScreen(40.0, 20.0, 1.0);
    faces.Add(toScreen * a, toScreen * b, toScreen * c);
  }
  return faces;
}

ScreenRectangle Union(const ScreenRectangle& a, const ScreenRectangle& b)
{
  return { std::min(a.Left, b.Left), std::max(a.Right, b.Right), std::min(a.Bottom, b.Bottom),
    std::max(a.Top, b.Top), std::max(a.Nearest, b.Nearest) };
}

void ExpectSame(const ScreenRectangle& a, const ScreenRectangle& b)
{
  EXPECT_EQ(a.Left, b.Left);
  EXPECT_EQ(a.Right, b.Right);
  EXPECT_EQ(a.Bottom, b.Bottom);
  EXPECT_EQ(a.Top, b.Top);
  EXPECT_EQ(a.Nearest, b.Nearest);
}

}

TEST(FaceBlock, IsWhereItsFacesAre)
{
  Random random(11);
  for (int round = 0; round < 500; ++round)
  {
    const int count = static_cast<int>(1 + random.Below(20));
    const OccluderMesh mesh = RandomFaces(count, random).Mesh();
    MeshProjection projection;
    ASSERT_TRUE(projection.Project(mesh, PlainMatrix()));
    std::vector<std::uint32_t> numbers(projection.Faces().size());
    std::iota(numbers.rbegin(), numbers.rend(), 0u);
    for (int first = 0; first < count; first += LaneCount)
    {
      const FaceBlock block(projection, numbers, static_cast<std::size_t>(first));
      const int faces = std::min(count - first, LaneCount);
      EXPECT_EQ(block.All(), (1u << faces) - 1u);
      const unsigned some = random.Below(1u << faces);
      ScreenRectangle around{ 3e38f, -3e38f, 3e38f, -3e38f, -3e38f };
      for (int lane = 0; lane < faces; ++lane)
      {
        const MeshFace& face = projection.Faces()[numbers[static_cast<std::size_t>(first + lane)]];
        EXPECT_EQ(&block.Face(lane), &face);
        const DepthPlane plane(projection, face);
        ScreenRectangle own = projection.RectangleOf(face);
        own.Nearest = plane.NearestSegment(0.0f, 0.0f, 0.0f, 0.0f).Nearest;
        ExpectSame(block.RectangleOf(lane), own);
        around = (some >> lane & 1u) != 0 ? Union(around, own) : around;
      }
      ExpectSame(block.RectangleAround(some), around);
    }
  }
}

TEST(FaceBlock, WithACornerThatIsNoNumberIsHiddenByNothing)
{
  Random random(12);
  const OccluderMesh mesh = RandomFaces(LaneCount, random).Mesh();
  for (int element = 0; element < 12; ++element)
  {
    ScreenMatrix matrix = PlainMatrix();
    matrix.Matrix[element / 3][element % 3] = NotANumber;
    MeshProjection projection;
    projection.Project(mesh, matrix);
    if (projection.Faces().size() != LaneCount)
    {
      continue;
    }
    const FaceBlock block(projection, { 0, 1, 2, 3, 4, 5, 6, 7 }, 0);
    const ScreenRectangle around = block.RectangleAround(block.All());
    EXPECT_LT(around.Left, -1e38f) << element;
    EXPECT_GT(around.Right, 1e38f) << element;
    EXPECT_LT(around.Bottom, -1e38f) << element;
    EXPECT_GT(around.Top, 1e38f) << element;
    EXPECT_GT(around.Nearest, 1e38f) << element;
  }
}
