#include "stability/Verdict.h"

#include "report/TextTable.h"

#include <algorithm>

namespace program
{

namespace
{
const double Step = LargestExactError(0);

bool HasMore(const PictureChange& method, const PictureChange& truth)
{
  return method.Largest - truth.Largest > Step || method.Typical - truth.Typical > Step;
}

/** How much more a picture changes than truth's, in the worse of largest and typical step. */
double SurplusOf(const Flicker& flicker)
{
  return std::max(
    flicker.Method.Largest - flicker.Truth.Largest, flicker.Method.Typical - flicker.Truth.Typical);
}

bool Flickers(const StabilityCell& cell)
{
  return HasMore(cell.Shift.Method, cell.Shift.Truth) || HasMore(cell.Turn.Method, cell.Turn.Truth);
}

bool IsOrderDependent(const StabilityCell& cell)
{
  return cell.RepetitionDifference > 0 || cell.OrderDifference > 0;
}

StabilityOutcome OutcomeOf(const StabilityCell& cell)
{
  if (!cell.Skipped.empty())
  {
    return StabilityOutcome::Refused;
  }
  if (IsOrderDependent(cell))
  {
    return StabilityOutcome::OrderDependent;
  }
  if (Flickers(cell))
  {
    return StabilityOutcome::Flickers;
  }
  return cell.WorstError() > Step ? StabilityOutcome::Wrong : StabilityOutcome::Exact;
}

std::string InSteps(double value)
{
  return FormatCell("%.1f/255", 255.0 * value);
}

std::string Describe(const StabilityCell& cell)
{
  if (!cell.Skipped.empty())
  {
    return "refused: " + cell.Skipped;
  }
  std::vector<std::string> faults;
  if (cell.WorstError() > Step)
  {
    faults.push_back("wrong by " + InSteps(cell.WorstError()));
  }
  if (cell.RepetitionDifference > 0)
  {
    faults.push_back(
      "another picture each time (" + std::to_string(cell.RepetitionDifference) + " values)");
  }
  if (cell.OrderDifference > 0)
  {
    faults.push_back("order-dependent (" + std::to_string(cell.OrderDifference) + " values)");
  }
  if (Flickers(cell))
  {
    faults.push_back(
      "flickers by " + InSteps(std::max(SurplusOf(cell.Shift), SurplusOf(cell.Turn))));
  }
  std::string verdict;
  for (const std::string& fault : faults)
  {
    verdict += (verdict.empty() ? "" : "; ") + fault;
  }
  return verdict.empty() ? "exact" : verdict;
}
}

double LargestExactError(int multisamples)
{
  const double lostAsFloat = 1e-6; // by 8-bit values
  return (multisamples > 0 ? 1.2 : 1.0) / 255.0 + lostAsFloat;
}

void Judge(StabilityCell& cell)
{
  cell.Outcome = OutcomeOf(cell);
  cell.Verdict = Describe(cell);
}

const char* Name(StabilityOutcome outcome)
{
  switch (outcome)
  {
    case StabilityOutcome::Refused:
      return "refused";
    case StabilityOutcome::OrderDependent:
      return "order-dependent";
    case StabilityOutcome::Flickers:
      return "flickers";
    case StabilityOutcome::Wrong:
      return "wrong";
    case StabilityOutcome::Exact:
      break;
  }
  return "exact";
}

}
