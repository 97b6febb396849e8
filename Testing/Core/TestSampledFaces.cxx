// Which faces may have samples, held to a look at each sample.
#include "NonFinite.h"
#include "OccluderScenes.h"

#include "Core/culling/hidden/SampledFaces.h"
#include "Core/culling/steady/FaceBlock.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::PlainMatrix;
using coverage::Random;
using coverage::Triangles;
using vitrine::MeshFace;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::SampledFaces;
using vitrine::SampleGrid;
using vitrine::ScreenMatrix;

const glm::vec2 NoGrowth(0.0f);

// Within so much of a sample either answer will do.
const double Nearly = 1.0 / 512.0;

/** Small faces on and beside a screen of 40 columns and 20 lines. */
Triangles SmallFaces(int count, Random& random)
{
  Triangles faces;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 middle =
      glm::dvec3(44.0, 24.0, 1.0) * random.Point(0.0, 1.0) - glm::dvec3(2.0, 2.0, 0.0);
    const auto corner = [&]()
    { return middle + glm::dvec3(0.7, 0.7, 0.0) * random.Point(-1.0, 1.0); };
    const glm::dvec3 a = corner(), b = corner(), c = corner();
    faces.Add(a, b, c);
  }
  return faces;
}

/** Whether a place from one to another that lies on the screen has samples, of which a column has so many. */
bool HasAny(double from, double to, int perColumn)
{
  return std::floor(to * perColumn - 0.5) >= std::ceil(std::max(from, 0.0) * perColumn - 0.5);
}

/** The same of a face that reaches so much farther than its corners. */
bool HasAny(const MeshProjection& projection, const MeshFace& face, double farther, int perColumn)
{
  double low[2] = { 1e300, 1e300 }, high[2] = { -1e300, -1e300 };
  for (const std::uint32_t corner : face)
  {
    const double place[2] = { projection.Point(corner).Column, projection.Point(corner).Line };
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], place[axis] - farther);
      high[axis] = std::max(high[axis], place[axis] + farther);
    }
  }
  return HasAny(low[0], high[0], perColumn) && HasAny(low[1], high[1], perColumn);
}

std::vector<std::uint32_t> AllSampled(
  const MeshProjection& projection, const SampleGrid& grid, const glm::vec2& growth = NoGrowth)
{
  SampledFaces sampled;
  sampled.Begin(projection, grid, growth);
  std::vector<std::uint32_t> found;
  sampled.Add(0, projection.Faces().size(), found);
  return found;
}

}

TEST(SampledFaces, AreThoseThatTouchColumnsAndLinesOfSamples)
{
  Random random(31);
  int none = 0, some = 0;
  for (const int perColumn : { 1, 2, 3, 4 })
  {
    for (const double growth : { 0.0, 0.25 })
    {
      const OccluderMesh mesh = SmallFaces(2000, random).Mesh();
      MeshProjection projection;
      ASSERT_TRUE(projection.Project(mesh, PlainMatrix()));
      const std::vector<std::uint32_t> found =
        AllSampled(projection, SampleGrid::AtCentres(perColumn), glm::vec2(growth));
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      const double farther = growth + double{ projection.Margin().Column };
      for (std::uint32_t i = 0; i < projection.Faces().size(); ++i)
      {
        const MeshFace& face = projection.Faces()[i];
        const bool isFound = std::binary_search(found.begin(), found.end(), i);
        EXPECT_TRUE(isFound || !HasAny(projection, face, farther, perColumn)) << i;
        EXPECT_TRUE(!isFound || HasAny(projection, face, farther + Nearly, perColumn)) << i;
        ++(isFound ? some : none);
      }
    }
  }
  EXPECT_GT(none, 2000);
  EXPECT_GT(some, 2000);
}

// Of meshes that are cut at the near plane, too, in views of some lines, and one after the other.
TEST(SampledFaces, AreAllThatAnyBlockOfFacesHas)
{
  Random random(36);
  SampledFaces sampled;
  MeshProjection projection;
  int none = 0, odd = 0;
  for (int round = 0; round < 1500; ++round)
  {
    const double columns = std::pow(10.0, random.Between(1.2, 3.5)), lines = 0.6 * columns;
    const glm::dmat4 toClip = random.OneIn(4)
      ? glm::ortho(-2.0, 2.0, -1.2, 1.2, 0.05, 40.0)
      : glm::perspective(
          random.Between(0.4, 1.9), 1.0 / 0.6, std::pow(10.0, random.Between(-3, 0)), 60.0);
    const vitrine::ScreenProjection whole(toClip, columns, lines,
      glm::dvec3(random.OneIn(3) ? 1000.0 : 10.0), { 0.002f, 0.02f, 0x1p-21f });
    const vitrine::ScreenProjection view = random.OneIn(2)
      ? whole
      : whole.OfLines(static_cast<int>(0.25 * lines), static_cast<int>(0.5 * lines));
    Triangles faces;
    for (std::uint32_t i = 1 + random.Below(60); i > 0; --i)
    {
      const glm::dvec3 middle(random.Between(-8, 8), random.Between(-5, 5), random.Between(-20, 1));
      const double size = std::pow(10.0, random.Between(-3, 0.5));
      const auto corner = [&]() { return middle + size * random.Point(-1.0, 1.0); };
      const glm::dvec3 a = corner(), b = corner(), c = corner();
      faces.Add(a, b, c);
    }
    const OccluderMesh mesh = faces.Mesh();
    const ScreenMatrix toScreen = view.Of(glm::dmat4(1.0));
    if (!projection.Project(mesh, toScreen) && random.OneIn(2))
    {
      projection.ClipFarther(toScreen);
    }
    odd += projection.ColumnsOfPoints().size() % vitrine::LaneCount != 0;
    const SampleGrid grid = random.OneIn(2)
      ? SampleGrid::AtCentres(static_cast<int>(1 + random.Below(8)))
      : SampleGrid::InCells(1 << random.Below(5), 4);
    const glm::vec2 growth(random.OneIn(2) ? 0.0 : random.Between(0.0, 0.2),
      random.OneIn(2) ? 0.0 : random.Between(0.0, 0.8));
    sampled.Begin(projection, grid, growth);
    std::vector<std::uint32_t> found;
    sampled.Add(0, projection.Faces().size(), found);
    for (std::uint32_t i = 0; i < projection.Faces().size(); ++i)
    {
      const bool isFound = std::binary_search(found.begin(), found.end(), i);
      const bool may = vitrine::FaceBlock(projection, { i }, 0).MayHaveAny(grid, growth) != 0;
      ASSERT_TRUE(isFound || !may) << "seed 36, round " << round << ", face " << i;
      none += !isFound;
    }
  }
  EXPECT_GT(none, 10000);
  EXPECT_GT(odd, 100);
}

TEST(SampledFaces, OfAListAreInItsOrder)
{
  Random random(32);
  const OccluderMesh mesh = SmallFaces(100, random).Mesh();
  MeshProjection projection;
  ASSERT_TRUE(projection.Project(mesh, PlainMatrix()));
  const SampleGrid grid = SampleGrid::AtCentres(1);
  SampledFaces sampled;
  sampled.Begin(projection, grid, NoGrowth);
  std::vector<std::uint32_t> backwards, found;
  for (std::uint32_t i = 0; i < 50; ++i)
  {
    backwards.push_back(49 - i);
  }
  sampled.Add(backwards, found);
  std::reverse(found.begin(), found.end());
  std::vector<std::uint32_t> first;
  sampled.Add(0, 50, first);
  EXPECT_EQ(found, first);
  sampled.Add(50, 100, first);
  EXPECT_EQ(first, AllSampled(projection, grid)) << "what was found is kept";
}

TEST(SampledFaces, AreAllWhereSamplesMayBeAnywhere)
{
  Random random(33);
  const OccluderMesh mesh = SmallFaces(20, random).Mesh();
  MeshProjection projection;
  ASSERT_TRUE(projection.Project(mesh, PlainMatrix()));
  EXPECT_EQ(AllSampled(projection, SampleGrid()).size(), 20u);
}

TEST(SampledFaces, AreThoseThatHaveNoPlaceOrReachFarOff)
{
  Random random(34);
  for (int element = 0; element < 16; ++element)
  {
    for (const float value : { NotANumber, Infinity, -Infinity, 1e30f })
    {
      const OccluderMesh mesh = SmallFaces(12, random).Mesh();
      ScreenMatrix matrix = PlainMatrix();
      matrix.Matrix[element / 4][element % 4] = value;
      MeshProjection projection;
      projection.Project(mesh, matrix);
      const std::vector<std::uint32_t> found = AllSampled(projection, SampleGrid::AtCentres(1));
      for (std::uint32_t i = 0; i < projection.Faces().size(); ++i)
      {
        const MeshFace& face = projection.Faces()[i];
        const bool isPlaced = std::all_of(face.begin(), face.end(),
          [&](std::uint32_t corner)
          {
            return std::isfinite(projection.Point(corner).Column) &&
              std::isfinite(projection.Point(corner).Line);
          });
        EXPECT_TRUE(isPlaced || std::binary_search(found.begin(), found.end(), i)) << element;
      }
    }
  }
}

// One object serves mesh after mesh.
TEST(SampledFaces, OfASmallerMeshKnowNothingOfALargerOne)
{
  Random random(35);
  const OccluderMesh large = SmallFaces(100, random).Mesh(), small = SmallFaces(10, random).Mesh();
  MeshProjection projection;
  SampledFaces sampled;
  ASSERT_TRUE(projection.Project(large, PlainMatrix()));
  sampled.Begin(projection, SampleGrid::AtCentres(1), NoGrowth);
  ASSERT_TRUE(projection.Project(small, PlainMatrix()));
  sampled.Begin(projection, SampleGrid::AtCentres(1), NoGrowth);
  std::vector<std::uint32_t> found;
  sampled.Add(0, 10, found);
  EXPECT_EQ(found, AllSampled(projection, SampleGrid::AtCentres(1)));
}
