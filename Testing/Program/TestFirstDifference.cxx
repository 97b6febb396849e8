#include "chart/FirstDifference.h"

#include <gtest/gtest.h>

namespace
{

using program::Json;

/** Of documents that are called "settings". */
std::string Difference(const char* before, const char* now)
{
  return program::FirstDifference("settings", Json::parse(before), Json::parse(now));
}
}

TEST(FirstDifference, IsEmptyWhereAllIsAlike)
{
  EXPECT_EQ(Difference(R"({"a": [1, {"b": null}]})", R"({"a": [1, {"b": null}]})"), "");
}

TEST(FirstDifference, IsTheFirstOfWhatIsNow)
{
  EXPECT_EQ(Difference(R"({"b": 1, "a": 1})", R"({"a": 2, "b": 2})"), "settings.a was 1 and is 2");
}

TEST(FirstDifference, IsNamedByItsPath)
{
  EXPECT_EQ(Difference(R"({"methods": ["blend", "oit"]})", R"({"methods": ["blend", "truth"]})"),
    "settings.methods.1 was \"oit\" and is \"truth\"");
  EXPECT_EQ(Difference("[1]", "[1, 2]"), "settings was of 1 values and is of 2");
  EXPECT_EQ(Difference("{}", R"({"a": "x"})"), "settings.a was nothing and is \"x\"");
  EXPECT_EQ(Difference(R"({"a": 0.5})", "{}"), "settings.a was 0.5 and is nothing");
  EXPECT_EQ(Difference("{}", "[3]"), "settings was {} and is [3]");
}

TEST(FirstDifference, OfAFileIsThatItHasChanged)
{
  const char* before = R"([{"scene": "a.stl", "bytes": 7, "modified": 1}])";
  for (const char* now : { R"([{"scene": "a.stl", "bytes": 8, "modified": 1}])",
         R"([{"scene": "a.stl", "bytes": 7, "modified": 2}])" })
  {
    EXPECT_EQ(Difference(before, now), "a.stl has changed");
  }
  EXPECT_EQ(Difference(before, R"([{"scene": "b.stl", "bytes": 8, "modified": 1}])"),
    "settings.0.scene was \"a.stl\" and is \"b.stl\"");
}

TEST(FirstDifference, IsALineThatIsCutBetweenCharacters)
{
  std::string value = "a";
  for (int i = 0; i < 13; ++i)
  {
    value += "\xe2\x82\xac";
  }
  // a quotation mark, the a, and 12 characters of three bytes are 38
  EXPECT_EQ(program::FirstDifference("x", Json(value), Json("\n")),
    "x was \"" + value.substr(0, 37) + "... and is \"\\n\"");
}
