#include "stability/Verdict.h"

#include <gtest/gtest.h>

namespace
{

using program::Judge;
using program::OtherWindow;
using program::StabilityCell;
using program::StabilityOutcome;

const double Step = 1.0 / 255.0;

/** A cell whose first frame is off by less than a step. */
StabilityCell Exact()
{
  StabilityCell cell;
  cell.Error.emplace();
  cell.Error->Max = 0.5 * Step;
  return cell;
}

OtherWindow Other(double error, int multisamples)
{
  OtherWindow other;
  other.Multisamples = multisamples;
  other.Error.emplace();
  other.Error->Max = error;
  return other;
}

void ExpectVerdict(StabilityCell cell, StabilityOutcome outcome, const std::string& verdict)
{
  Judge(cell);
  EXPECT_EQ(program::Name(cell.Outcome), std::string(program::Name(outcome)));
  EXPECT_EQ(cell.Verdict, verdict);
}
}

TEST(Verdict, IsExactUpToAStep)
{
  StabilityCell cell = Exact();
  ExpectVerdict(cell, StabilityOutcome::Exact, "exact");
  cell.Error->Max = Step;
  ExpectVerdict(cell, StabilityOutcome::Exact, "exact");
  cell.Error->Max = 1.1 * Step;
  ExpectVerdict(cell, StabilityOutcome::Wrong, "wrong by 1.1/255");
}

TEST(Verdict, TakesTheWorstFrame)
{
  EXPECT_EQ(Exact().Worst().Frames, "first");
  StabilityCell redrawn = Exact();
  redrawn.RedrawnError = redrawn.Error->Max;
  EXPECT_EQ(redrawn.Worst().Frames, "first"); // of equals
  redrawn.RedrawnError = 3.0 * Step;
  EXPECT_EQ(redrawn.Worst().Frames, "redrawn");
  ExpectVerdict(redrawn, StabilityOutcome::Wrong, "wrong by 3/255");
  StabilityCell shifted = Exact();
  shifted.Shift.Error = 4.0 * Step;
  EXPECT_EQ(shifted.Worst().Frames, "shift");
  ExpectVerdict(shifted, StabilityOutcome::Wrong, "wrong by 4/255");
  StabilityCell turned = Exact();
  turned.Turn.Error = 5.0 * Step;
  EXPECT_EQ(turned.Worst().Frames, "turn");
  ExpectVerdict(turned, StabilityOutcome::Wrong, "wrong by 5/255");
}

TEST(Verdict, JudgesOtherWindowsByTheirOwnBound)
{
  StabilityCell resized = Exact();
  resized.Others = { Other(0.5 * Step, 0), Other(1.1 * Step, 0) };
  ExpectVerdict(resized, StabilityOutcome::Wrong, "wrong by 1.1/255");
  StabilityCell sampled = Exact();
  sampled.Others = { Other(1.1 * Step, 4) };
  sampled.Others.front().Name = "4-samples";
  EXPECT_DOUBLE_EQ(sampled.WorstError(), 1.1 * Step);
  EXPECT_EQ(sampled.Worst().Frames, "4-samples");
  EXPECT_DOUBLE_EQ(sampled.OwnWindowError(), 0.5 * Step);
  ExpectVerdict(sampled, StabilityOutcome::Exact, "exact");
  sampled.Error->Max = 1.05 * Step; // beyond its bound, which samples' errors are not
  ExpectVerdict(sampled, StabilityOutcome::Wrong, "wrong by 1.05/255");
  sampled.Others = { Other(1.3 * Step, 4) };
  ExpectVerdict(sampled, StabilityOutcome::Wrong, "wrong by 1.3/255");
}

TEST(Verdict, OtherWindowsThatAreRefusedAreNotWrong)
{
  StabilityCell cell = Exact();
  OtherWindow refused;
  refused.Skipped = "multisampled";
  cell.Others = { refused };
  ExpectVerdict(cell, StabilityOutcome::Exact, "exact");
}

TEST(Verdict, SaysInWhichWindowsThereIsNoTruth)
{
  OtherWindow without;
  without.Name = "double";
  without.NotJudged = "no memory";
  StabilityCell cell = Exact();
  cell.Others = { Other(0.5 * Step, 0), without };
  ExpectVerdict(cell, StabilityOutcome::Exact, "exact; not judged in double");
  cell.Shift.Error = 4.0 * Step;
  without.Name = "4-samples";
  cell.Others.push_back(without);
  ExpectVerdict(cell, StabilityOutcome::Wrong, "wrong by 4/255; not judged in double, 4-samples");
}

TEST(Verdict, FlickersWhereAValueChangesMoreThanRoundingExplains)
{
  StabilityCell cell = Exact();
  cell.Turn.Method.Largest = cell.Turn.Truth.Largest = 0.7; // silhouettes move
  cell.Turn.Excess = 1.4 * Step;
  ExpectVerdict(cell, StabilityOutcome::Exact, "exact");
  cell.Turn.Excess = 1.6 * Step;
  ExpectVerdict(cell, StabilityOutcome::Flickers, "flickers by 1.6/255");
  cell.Shift.Excess = 2.0 * Step;
  ExpectVerdict(cell, StabilityOutcome::Flickers, "flickers by 2/255");
}

TEST(Verdict, TellsAllThatIsWrongAndTheFirstAsTheOutcome)
{
  StabilityCell cell = Exact();
  cell.RepetitionDifference = 3;
  cell.OrderDifference = 7;
  cell.Error->Max = 9.0 * Step;
  cell.Shift.Excess = 2.0 * Step;
  ExpectVerdict(cell, StabilityOutcome::OrderDependent,
    "wrong by 9/255; another picture each time (3 values); order-dependent (7 values); "
    "flickers by 2/255");
  cell.Skipped = "no OpenGL";
  ExpectVerdict(cell, StabilityOutcome::Refused, "refused: no OpenGL");
}
