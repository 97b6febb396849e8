// What deferred shading makes of lists of clusters: lists of tiles, and rectangles of lights.

#include "Core/lighting/LightRectangles.h"
#include "Core/lighting/TileLists.h"

#include "LightScenes.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::SquareView;
using vitrine::ClusterGrid;
using vitrine::LightLists;
using vitrine::LightRectangle;
using Numbers = std::vector<std::uint32_t>;

/** 3 columns, 2 rows and so many slices. */
ClusterGrid SmallGrid(int slices)
{
  return { SquareView().ToClip, 30, 20, { 10, slices, vitrine::SliceLaw::Uniform } };
}

LightLists ListsOf(const std::vector<Numbers>& lists)
{
  LightLists joined;
  joined.Offsets = { 0 };
  for (const Numbers& list : lists)
  {
    joined.Indices.insert(joined.Indices.end(), list.begin(), list.end());
    joined.Offsets.push_back(static_cast<std::uint32_t>(joined.Indices.size()));
  }
  return joined;
}

std::vector<Numbers> Apart(const LightLists& lists)
{
  std::vector<Numbers> apart;
  for (std::uint32_t i = 0; i + 1 < lists.Offsets.size(); ++i)
  {
    apart.emplace_back(lists.BeginOf(i), lists.EndOf(i));
  }
  return apart;
}

TEST(TileLists, HaveEachLightOfTheTilesClustersOnceInOrder)
{
  const ClusterGrid grid = SmallGrid(3);
  ASSERT_EQ(grid.Count(), 18u);
  std::vector<Numbers> lists(18);
  lists[grid.ClusterAt(0, 0, 0)] = { 2, 7 };
  lists[grid.ClusterAt(0, 0, 1)] = { 1, 7, 9 };
  lists[grid.ClusterAt(0, 0, 2)] = { 2 };
  lists[grid.ClusterAt(2, 1, 1)] = { 4 };
  const std::vector<Numbers> expected = { { 1, 2, 7, 9 }, {}, {}, {}, {}, { 4 } };
  EXPECT_EQ(Apart(vitrine::JoinSlices(grid, ListsOf(lists))), expected);
}

TEST(TileLists, OfOneSliceAreThoseOfItsClusters)
{
  const std::vector<Numbers> lists = { { 1 }, {}, { 0, 2 }, {}, { 5 }, { 0 } };
  EXPECT_EQ(Apart(vitrine::JoinSlices(SmallGrid(1), ListsOf(lists))), lists);
}

TEST(TileLists, GoFromTheFirstToTheLastClusterThatIsMarked)
{
  const ClusterGrid grid = SmallGrid(5);
  std::vector<std::uint8_t> marks(grid.Count(), 0), expected(grid.Count(), 0);
  for (const int slice : { 1, 4 })
  {
    marks[grid.ClusterAt(1, 0, slice)] = 1;
  }
  marks[grid.ClusterAt(2, 1, 3)] = 1; // alone
  for (const int slice : { 1, 2, 3, 4 })
  {
    expected[grid.ClusterAt(1, 0, slice)] = 1;
  }
  expected[grid.ClusterAt(2, 1, 3)] = 1;
  vitrine::MarkBetween(grid, marks);
  EXPECT_EQ(marks, expected);
  EXPECT_EQ(vitrine::JoinMarks(grid, marks), (std::vector<std::uint8_t>{ 0, 1, 0, 0, 0, 1 }));
  std::vector<std::uint8_t> none;
  vitrine::MarkBetween(grid, none); // not known
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(vitrine::JoinMarks(grid, none).empty());
}

TEST(LightRectangles, HoldAllTilesOfEachLight)
{
  const ClusterGrid grid = SmallGrid(2);
  std::vector<Numbers> lists(12);
  lists[grid.ClusterAt(0, 1, 0)] = { 3 };
  lists[grid.ClusterAt(2, 0, 1)] = { 3, 8 };
  const std::vector<LightRectangle> rectangles = vitrine::RectanglesOf(grid, ListsOf(lists), 0);
  ASSERT_EQ(rectangles.size(), 2u);
  EXPECT_EQ(rectangles[0].Light, 3u);
  EXPECT_EQ(rectangles[0].First, glm::ivec2(0, 0));
  EXPECT_EQ(rectangles[0].Last, glm::ivec2(2, 1));
  EXPECT_EQ(rectangles[1].Light, 8u);
  EXPECT_EQ(rectangles[1].First, glm::ivec2(2, 0));
  EXPECT_EQ(rectangles[1].Last, glm::ivec2(2, 0));
  EXPECT_TRUE(vitrine::RectanglesOf(grid, ListsOf(std::vector<Numbers>(12)), 1).empty());
}

TEST(LightRectangles, HaveTilesAroundThatAreInTheGrid)
{
  const ClusterGrid grid = SmallGrid(2);
  std::vector<Numbers> lists(12);
  lists[grid.ClusterAt(2, 0, 1)] = { 5 };
  const std::vector<LightRectangle> rectangles = vitrine::RectanglesOf(grid, ListsOf(lists), 1);
  ASSERT_EQ(rectangles.size(), 1u);
  EXPECT_EQ(rectangles[0].First, glm::ivec2(1, 0));
  EXPECT_EQ(rectangles[0].Last, glm::ivec2(2, 1));
}

TEST(LightRectangles, AreInTheListsOfTilesThatTheyCover)
{
  const std::vector<LightRectangle> rectangles = { { 3, { 0, 0 }, { 1, 1 } },
    { 8, { 1, 0 }, { 2, 0 } } };
  const std::vector<Numbers> expected = { { 3 }, { 3, 8 }, { 8 }, { 3 }, { 3 }, {} };
  EXPECT_EQ(Apart(vitrine::CoveredTiles(SmallGrid(1), rectangles)), expected);
}

}
