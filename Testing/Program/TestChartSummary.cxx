#include "chart/ChartSummary.h"

#include <gtest/gtest.h>

namespace
{

using program::AddRatios;
using program::Json;
using program::SummariseGrowth;
using program::SummariseScenes;

Json Row(const std::string& part, int step, const std::string& method, double milliseconds)
{
  return { { "part", part }, { "step", step }, { "scene", "stack" }, { "method", method },
    { "width", 10 }, { "height", 10 }, { "frame_ms", { { "median", milliseconds } } } };
}

Json Skipped(const std::string& part, int step, const std::string& method)
{
  return { { "part", part }, { "step", step }, { "scene", "stack" }, { "method", method },
    { "width", 10 }, { "height", 10 }, { "skipped", "too slow" } };
}

Json With(Json row, const Json& more)
{
  row.update(more);
  return row;
}

Json Error(double largest)
{
  return { { "error", { { "max", largest } } } };
}
}

TEST(ChartSummary, RatiosAreToVTKsOwnMethod)
{
  const Json rows = AddRatios({ Row("scenes", 0, "blend", 2.0), Row("scenes", 0, "vtk-oit", 4.0),
    Row("scenes", 1, "blend", 3.0), Row("scenes", 1, "linked-list", 6.0) });
  EXPECT_EQ(rows[0]["ratio"], 0.5);
  EXPECT_EQ(rows[1]["ratio"], 1.0);
  EXPECT_EQ(rows[0]["ratio_to"], "vtk-oit");
  EXPECT_EQ(rows[0]["family"], "blend");
  EXPECT_EQ(rows[3]["ratio"], 2.0); // to the first that ran
  EXPECT_EQ(rows[3]["ratio_to"], "blend");
}

TEST(ChartSummary, WhatDidNotRunHasNoRatioAndIsNoReference)
{
  const Json rows = AddRatios({ Skipped("scenes", 0, "vtk-oit"), Row("scenes", 0, "blend", 2.0) });
  EXPECT_FALSE(rows[0].contains("ratio"));
  EXPECT_EQ(rows[1]["ratio"], 1.0);
}

TEST(ChartSummary, FrontsAreOfTheMethodsThatTellBoth)
{
  const Json scenes =
    SummariseScenes(AddRatios({ With(Row("scenes", 0, "vtk-oit", 1.0), Error(0.5)),
      With(Row("scenes", 0, "linked-list", 2.0), Error(0.0)),
      With(Row("scenes", 0, "vtk-peeling", 3.0), Error(0.25)), Row("scenes", 0, "blend", 0.5),
      Skipped("scenes", 0, "prefix-sum") }));
  ASSERT_EQ(scenes.size(), 1u);
  EXPECT_EQ(scenes[0]["reference"], "vtk-oit");
  EXPECT_EQ(scenes[0]["points"].size(), 4u);
  EXPECT_EQ(scenes[0]["fronts"]["time"]["max"], Json::array({ "vtk-oit", "linked-list" }));
  EXPECT_EQ(scenes[0]["fronts"]["memory"]["max"], Json::array());
  EXPECT_DOUBLE_EQ(scenes[0]["points"][0]["values"]["max"], 127.5);
  EXPECT_TRUE(scenes[0]["points"][0]["values"]["memory"].is_null());
}

TEST(ChartSummary, ScenesAreInTheOrderOfTheirSteps)
{
  const Json scenes = SummariseScenes(AddRatios({ With(Row("scenes", 1, "blend", 1.0), Error(0.0)),
    With(Row("scenes", 0, "blend", 1.0), Error(0.0)), Row("layers", 2, "blend", 1.0) }));
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[0]["step"], 0);
  EXPECT_EQ(scenes[1]["step"], 1);
}

TEST(ChartSummary, GrowthIsFittedToWhatRan)
{
  Json rows = Json::array();
  for (int step = 0; step < 4; ++step)
  {
    const double layers = 1 << step;
    rows.push_back(With(Row("layers", step, "vtk-oit", 2.0), { { "layers_max", layers } }));
    rows.push_back(step < 3
        ? With(Row("layers", step, "linked-list", 3.0 * layers), { { "layers_max", layers } })
        : Skipped("layers", step, "linked-list"));
  }
  const Json growth = SummariseGrowth(AddRatios(rows));
  ASSERT_EQ(growth.size(), 2u); // time and memory
  const Json& list = growth[0]["lines"][1];
  EXPECT_EQ(list["method"], "linked-list");
  EXPECT_EQ(list["points"], Json::parse("[[1.0, 1.5], [2.0, 3.0], [4.0, 6.0]]"));
  EXPECT_NEAR(list["fit"]["exponent"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(list["left_off"], "too slow");
  EXPECT_TRUE(growth[0]["lines"][0]["left_off"].is_null());
}

TEST(ChartSummary, WhatIsNotToldIsNoPoint)
{
  // rows without "bytes", "layers_max" and "fragments": nothing is read that is not there
  const Json growth = SummariseGrowth(
    AddRatios({ Row("layers", 0, "blend", 1.0), Row("fragments", 0, "blend", 1.0) }));
  for (const Json& one : growth)
  {
    EXPECT_TRUE(one["lines"][0]["points"].empty()) << one["title"];
    EXPECT_TRUE(one["lines"][0]["fit"].is_null());
  }
}

TEST(ChartSummary, NothingGrowsWithoutItsFirstStep)
{
  EXPECT_TRUE(SummariseGrowth({}).empty());
  EXPECT_TRUE(SummariseGrowth(AddRatios(Json::array({ Row("layers", 1, "blend", 1.0) }))).empty());
}
