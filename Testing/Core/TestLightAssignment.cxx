// That no light is missing where it reaches, and few are listed where they do not, by brute force.

#include "ConvexCell.h"
#include "LightJudge.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{

using light_scenes::AllLitViews;
using light_scenes::BallAt;
using light_scenes::ConeAt;
using light_scenes::ExpectLit;
using light_scenes::ExpectNoneMissing;
using light_scenes::ExpectWellFormed;
using light_scenes::GridFor;
using light_scenes::IsListed;
using light_scenes::IsWithin;
using light_scenes::ListsOf;
using light_scenes::LitView;
using light_scenes::NearestWithin;
using light_scenes::RandomLights;
using light_scenes::SidesOf;
using light_scenes::SquareView;
using vitrine::Box;
using vitrine::ClusterGrid;
using vitrine::LightLists;
using vitrine::LightTest;
using vitrine::LightTree;
using vitrine::LightVolume;
using vitrine::WorldGrid;

/** In closed form where it is a ball: which clusters it reaches. */
std::vector<std::uint8_t> ClustersReached(const ClusterGrid& grid, const LightVolume& ball)
{
  std::vector<std::uint8_t> reached(grid.Count());
  const glm::dvec3 centre(ball.Position);
  for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
  {
    const std::vector<glm::dvec4> sides = SidesOf(grid, cluster);
    const glm::dvec3 nearest = NearestWithin(sides, centre);
    reached[cluster] =
      glm::length(nearest - centre) < 0.999 * ball.Range && IsWithin(sides, nearest);
  }
  return reached;
}

bool IsVeryWide(const LitView& view)
{
  return view.ToClip[0][0] < 0.5 && view.ToClip[3].w == 0.0;
}
}

TEST(LightAssignment, MissesNoLight)
{
  unsigned seed = 0;
  for (const LitView& view : AllLitViews())
  {
    std::mt19937 random(++seed);
    ExpectLit(view, RandomLights(view, 150, random));
  }
}

TEST(LightAssignment, ListsBallsWhereTheyReachAndHardlyAnywhereElse)
{
  unsigned seed = 0;
  for (const LitView& view : AllLitViews())
  {
    SCOPED_TRACE(view.Name);
    std::mt19937 random(++seed);
    const ClusterGrid grid = GridFor(view, { 128, 5 });
    std::vector<LightVolume> lights = RandomLights(view, 30, random);
    std::size_t reached = 0;
    for (LightVolume& light : lights)
    {
      light.ConeAngle = 180.0f;
      light.Range = std::min(light.Range, static_cast<float>(view.Far));
    }
    const LightLists lists = ListsOf(grid, lights);
    for (std::uint32_t light = 0; light < lights.size(); ++light)
    {
      const std::vector<std::uint8_t> expected = ClustersReached(grid, lights[light]);
      for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
      {
        reached += expected[cluster];
        EXPECT_LE(expected[cluster], IsListed(lists, cluster, light))
          << "light " << light << " cluster " << cluster;
      }
    }
    // Sides that meet at far more than 90 degrees cut less off a ball than they could.
    const double most = IsVeryWide(view) ? 3.0 : 1.15;
    EXPECT_LE(lists.Indices.size(), most * static_cast<double>(reached) + 2) << reached;
  }
}

TEST(LightAssignment, ListsASmallLightOnceInTheMidstOfACluster)
{
  const ClusterGrid grid = GridFor(SquareView());
  const double depth = std::sqrt(grid.EndOf(5) * grid.EndOf(6));
  const glm::vec3 centre(depth * glm::dvec3(0.125, 0.125, -1.0));
  const float toSide = static_cast<float>(0.5 * (grid.EndOf(6) - grid.EndOf(5)));
  const LightLists lists = ListsOf(
    grid, { BallAt(centre, 0.1f * toSide), ConeAt(centre, 0.1f * toSide, { 1, 0, 0 }, 30) });
  EXPECT_EQ(lists.Indices, (std::vector<std::uint32_t>{ 0, 1 }));
  EXPECT_EQ(lists.CountOf(grid.ClusterAt(4, 4, 5)), 2u);
}

TEST(LightAssignment, ConesLeaveOutWhatIsBesideThem)
{
  const LitView view = SquareView();
  const ClusterGrid grid = GridFor(view);
  const LightLists lists = ListsOf(grid,
    { BallAt({ 0, 10, -20 }, 15), ConeAt({ 0, 10, -20 }, 15, { 0, -1, 0 }, 20),
      ConeAt({ 0, 10, -20 }, 15, { 0, -1, 0 }, 89) });
  std::size_t counts[3] = {};
  for (const std::uint32_t light : lists.Indices)
  {
    ++counts[light];
  }
  EXPECT_LT(5 * counts[1], counts[0]);
  EXPECT_LT(counts[2], counts[0]);
}

TEST(LightAssignment, TestsBoxesLessTightly)
{
  const LitView view = SquareView();
  std::mt19937 random(3);
  const std::vector<LightVolume> lights = RandomLights(view, 200, random);
  const ClusterGrid grid = GridFor(view);
  EXPECT_LT(1.2 * static_cast<double>(ListsOf(grid, lights).Indices.size()),
    static_cast<double>(ListsOf(grid, lights, { LightTest::Box, 2 }).Indices.size()));
}

TEST(LightAssignment, OfNoLightsIsNoList)
{
  const ClusterGrid grid = GridFor(SquareView());
  const LightLists lists = ListsOf(grid, {});
  ExpectWellFormed(lists, grid.Count(), 0);
  EXPECT_TRUE(lists.Indices.empty());
}

TEST(LightAssignment, HasNoCap)
{
  for (const std::size_t count : { 255, 256, 257, 65535, 65536, 70000 })
  {
    const ClusterGrid grid = GridFor(SquareView(), { 512, 2 });
    const LightLists lists =
      ListsOf(grid, std::vector<LightVolume>(count, BallAt({ 0, 0, -5 }, 0.1f)));
    ExpectWellFormed(lists, grid.Count(), count);
    EXPECT_EQ(lists.CountOf(static_cast<std::uint32_t>(grid.ClusterOf({ 0, 0, -5 }))), count);
  }
}

TEST(LightAssignment, RefusesListsThatItCannotCount)
{
  const ClusterGrid grid = GridFor(SquareView(1, 100, 512), { 1, 1 });
  ASSERT_EQ(grid.Count(), 1u << 18);
  LightLists lists;
  const std::vector<LightVolume> lights(1u << 14);
  EXPECT_THROW(Assign(grid, lights, lists), std::length_error);
}

TEST(LightAssignment, IsTheSameWithAnyNumberOfThreads)
{
  const LitView view = SquareView();
  std::mt19937 random(5);
  const std::vector<LightVolume> lights = RandomLights(view, 17000, random);
  const ClusterGrid grid = GridFor(view, { 128, 4 });
  const LightLists one = ListsOf(grid, lights, { LightTest::Volume, 1 });
  ExpectWellFormed(one, grid.Count(), lights.size());
  for (const unsigned threads : { 0u, 2u, 3u, 8u })
  {
    const LightLists more = ListsOf(grid, lights, { LightTest::Volume, threads });
    EXPECT_TRUE(more.Offsets == one.Offsets && more.Indices == one.Indices) << threads;
  }
}

TEST(LightAssignment, IsTheSameAgainInMemoryThatWasUsed)
{
  const LitView view = SquareView();
  std::mt19937 random(6);
  const std::vector<LightVolume> many = RandomLights(view, 5000, random);
  const std::vector<LightVolume> few(many.begin(), many.begin() + 100);
  vitrine::LightAssigner assigner;
  LightLists lists;
  assigner.Assign(GridFor(view), many, lists);
  assigner.Assign(GridFor(view, { 128, 4 }), few, lists);
  const LightLists fresh = ListsOf(GridFor(view, { 128, 4 }), few);
  EXPECT_TRUE(lists.Offsets == fresh.Offsets && lists.Indices == fresh.Indices);
}

TEST(LightAssignment, LeavesListsOfUnusedClustersEmpty)
{
  const LitView view = SquareView();
  std::mt19937 random(8);
  const std::vector<LightVolume> lights = RandomLights(view, 500, random);
  const ClusterGrid grid = GridFor(view);
  std::vector<std::uint8_t> used(grid.Count());
  for (std::uint8_t& mark : used)
  {
    mark = random() % 3 == 0;
  }
  const LightLists all = ListsOf(grid, lights);
  LightLists some;
  Assign(grid, lights, some, &used);
  ExpectWellFormed(some, grid.Count(), lights.size());
  for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
  {
    const std::size_t expected = used[cluster] ? all.CountOf(cluster) : 0;
    ASSERT_EQ(some.CountOf(cluster), expected);
    EXPECT_TRUE(std::equal(some.BeginOf(cluster), some.EndOf(cluster), all.BeginOf(cluster)));
  }
}

TEST(LightAssignment, IsTheSameOfBallsThatATreeHasInView)
{
  for (const LitView& view : AllLitViews())
  {
    SCOPED_TRACE(view.Name);
    std::mt19937 random(9);
    std::vector<LightVolume> lights = RandomLights(view, 1000, random);
    for (LightVolume& light : lights)
    {
      light.ConeAngle = 180.0f;
    }
    const ClusterGrid grid = GridFor(view);
    const auto marks = LightTree(lights).Within(grid.OuterSides());
    EXPECT_LT(marks.Count(), lights.size());
    LightLists marked;
    vitrine::LightAssigner().Assign(grid, lights, marked, nullptr, &marks);
    const LightLists all = ListsOf(grid, lights);
    EXPECT_TRUE(marked.Offsets == all.Offsets && marked.Indices == all.Indices);
  }
}

TEST(LightAssignment, MissesNoLightThatATreeHasInView)
{
  const LitView view = SquareView();
  std::mt19937 random(9);
  const std::vector<LightVolume> lights = RandomLights(view, 5000, random);
  const ClusterGrid grid = GridFor(view);
  const auto marks = LightTree(lights).Within(grid.OuterSides());
  EXPECT_LT(marks.Count(), lights.size());
  LightLists lists;
  vitrine::LightAssigner().Assign(grid, lights, lists, nullptr, &marks);
  ExpectWellFormed(lists, grid.Count(), lights.size());
  ExpectNoneMissing(view, grid, lights, lists, random);
}

TEST(LightAssignment, MissesNoLightInAFixedGridOfTheWorld)
{
  const LitView view = SquareView(1, 50);
  std::mt19937 random(10);
  const std::vector<LightVolume> lights = RandomLights(view, 200, random);
  for (const glm::ivec3& cells : { glm::ivec3(8, 7, 6), glm::ivec3(1, 20, 0) })
  {
    for (const LightTest test : { LightTest::Volume, LightTest::Box })
    {
      const WorldGrid grid({ { -30, -30, -40 }, { 30, 30, -1 } }, cells); // less than what is seen
      const LightLists lists = ListsOf(grid, lights, { test, 2 });
      ExpectWellFormed(lists, grid.Count(), lights.size());
      ExpectNoneMissing(view, grid, lights, lists, random);
    }
  }
}

TEST(LightAssignment, OfAWorldGridWithoutLengthIsOneCell)
{
  for (const Box& bounds : { Box(), Box{ { 1, 1, 1 }, { 1, 1, 1 } }, Box::Everything(),
         Box{ glm::vec3(NotANumber), glm::vec3(1) } })
  {
    const WorldGrid grid(bounds, { 4, 4, 4 });
    EXPECT_EQ(grid.Count(), 1u);
    EXPECT_EQ(grid.ClusterOf({ 3, 4, 5 }), 0);
    EXPECT_EQ(ListsOf(grid, { BallAt({ 9, 9, 9 }, 1) }).Indices.size(), 1u);
  }
}
