#include "report/StabilityReport.h"
#include "stability/Verdict.h"

#include <gtest/gtest.h>

namespace
{

using program::OtherWindow;
using program::StabilityCell;
using program::StabilityResult;

/** One cell, exact but in a window with an error of 3/255, and without truth in another. */
StabilityResult OneCell()
{
  OtherWindow wrong;
  wrong.Name = "third";
  wrong.Error.emplace();
  wrong.Error->Max = 3.0 / 255.0;
  OtherWindow notJudged;
  notJudged.Name = "double";
  notJudged.NotJudged = "no memory";
  StabilityCell cell;
  cell.Scene = "mating";
  cell.Method = "blend";
  cell.Error.emplace();
  cell.Others = { wrong, notJudged };
  program::Judge(cell);
  StabilityResult result;
  result.Settings.Methods = { cell.Method };
  result.Settings.Scenes.resize(1);
  result.Settings.Scenes.front().Name = cell.Scene;
  result.Cells = { cell };
  return result;
}
}

TEST(StabilityReport, SaysWhyAWindowIsNotJudged)
{
  const StabilityResult result = OneCell();
  EXPECT_NE(program::SceneTable(result.Settings.Scenes.front(), result.Cells)
              .find("  blend, double: not judged, there is no truth: no memory\n"),
    std::string::npos);
  const program::Json others = program::ToJsonRow(result.Cells.front())["others"];
  EXPECT_FALSE(others[0].contains("not_judged"));
  EXPECT_EQ(others[1]["not_judged"], "no memory");
  EXPECT_FALSE(others[1].contains("error"));
}

TEST(StabilityReport, NamesTheFramesOfTheWorstError)
{
  const StabilityResult result = OneCell();
  EXPECT_EQ(program::ToJsonRow(result.Cells.front())["worst_frames"], "third");
  const std::string worst = program::WorstTable(result);
  EXPECT_NE(worst.find("3.00  mating   third"), std::string::npos) << worst;
}
