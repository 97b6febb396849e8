#include "chart/ChartRows.h"

#include <gtest/gtest.h>

namespace
{

using program::IsChartCell;
using program::IsChartResult;
using program::Json;

Json Result()
{
  return { { "part", "scenes" }, { "step", 0 }, { "scene", "stack" }, { "method", "blend" },
    { "width", 8 }, { "height", 8 }, { "frame_ms", { { "median", 1.5 } } }, { "fragments", 3 },
    { "bytes", nullptr }, { "error", { { "max", 0.5 }, { "rmse", 0.1 } } },
    { "picture", "pictures/scene-1-blend.png" }, { "truth_picture", "pictures/a.png" } };
}

Json Cell()
{
  return { { "scene", "mating" }, { "method", "blend" }, { "width", 8 }, { "height", 8 },
    { "outcome", "wrong" }, { "verdict", "wrong by 3/255" }, { "worst_error", 0.01 },
    { "worst_frames", "third" }, { "error", { { "max", 0.005 } } },
    { "messages", Json::array({ "none" }) }, { "picture", "pictures/a.png" },
    { "truth_picture", "pictures/b.png" } };
}

Json With(Json row, const char* key, const Json& value)
{
  row[key] = value;
  return row;
}

Json Without(Json row, const char* key)
{
  row.erase(key);
  return row;
}
}

TEST(ChartRows, AreThoseOfMeasurements)
{
  EXPECT_TRUE(IsChartResult(Result()));
  EXPECT_TRUE(IsChartResult(With(Result(), "error", nullptr)));
  EXPECT_TRUE(IsChartResult(With(Without(Result(), "frame_ms"), "skipped", "no GPU")));
  EXPECT_TRUE(IsChartCell(Cell()));
  EXPECT_TRUE(IsChartCell({ { "scene", "mating" }, { "method", "blend" }, { "width", 8 },
    { "height", 8 }, { "outcome", "refused" }, { "verdict", "no" }, { "skipped", "no GPU" } }));
}

TEST(ChartRows, HaveAllThatIsReadFromThem)
{
  for (const char* key : { "part", "step", "scene", "method", "width", "height", "frame_ms" })
  {
    EXPECT_FALSE(IsChartResult(Without(Result(), key))) << key;
  }
  for (const char* key : { "scene", "method", "width", "height", "outcome", "verdict",
         "worst_error", "worst_frames", "error", "picture", "truth_picture" })
  {
    EXPECT_FALSE(IsChartCell(Without(Cell(), key))) << key;
  }
}

TEST(ChartRows, HaveTheTypesThatAreRead)
{
  for (const Json& row : { Json(nullptr), Json(7), Json("row"), Json::array({ 1 }) })
  {
    EXPECT_FALSE(IsChartResult(row)) << row;
    EXPECT_FALSE(IsChartCell(row)) << row;
  }
  for (const auto& [key, value] : { std::pair("skipped", Json(true)),
         std::pair("skipped", Json(nullptr)), std::pair("frame_ms", Json(3)),
         std::pair("frame_ms", Json::array({ 3 })), std::pair("bytes", Json("many")),
         std::pair("error", Json("large")), std::pair("error", Json({ { "max", "large" } })) })
  {
    EXPECT_FALSE(IsChartResult(With(Result(), key, value))) << key << " " << value;
  }
  for (const auto& [key, value] : { std::pair("outcome", Json("magic")),
         std::pair("outcome", Json(1)), std::pair("skipped", Json(false)),
         std::pair("worst_error", Json("large")), std::pair("worst_frames", Json(3)),
         std::pair("error", Json(nullptr)), std::pair("error", Json({ { "max", "large" } })),
         std::pair("messages", Json("none")), std::pair("messages", Json::array({ 1 })) })
  {
    EXPECT_FALSE(IsChartCell(With(Cell(), key, value))) << key << " " << value;
  }
}

TEST(ChartRows, HaveStepsThatCanBeCounted)
{
  EXPECT_TRUE(IsChartResult(With(Result(), "step", 9999)));
  for (const Json& step :
    { Json(-1), Json(10000), Json(1e300), Json(0.5), Json("0"), Json(std::uint64_t{ 1 } << 63) })
  {
    EXPECT_FALSE(IsChartResult(With(Result(), "step", step))) << step;
  }
}

TEST(ChartRows, NamePicturesOfTheirFolderOnly)
{
  for (const Json& path :
    { Json("/etc/passwd"), Json("pictures/../chart.json.png"), Json("../pictures/a.png"),
      Json("pictures//etc/a.png"), Json("pictures/b/a.png"), Json("pictures/a.jpg"),
      Json("pictures/.png"), Json("pictures/..png"), Json("a.png"), Json(""), Json(3),
      Json(nullptr), Json(std::string("pictures/a\0.png", 15)), Json("pictures/..\\a.png") })
  {
    for (const char* key : { "picture", "truth_picture" })
    {
      EXPECT_FALSE(IsChartResult(With(Result(), key, path))) << path;
      EXPECT_FALSE(IsChartCell(With(Cell(), key, path))) << path;
    }
  }
  EXPECT_TRUE(IsChartResult(With(Result(), "picture", program::PicturePath("a"))));
}
