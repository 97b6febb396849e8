#include "stability/Verdict.h"

#include "Join.h"
#include "report/TextTable.h"

#include <algorithm>

namespace program
{

namespace
{
const double LostAsFloat = 1e-6; // by 8-bit values

double MaxOf(const std::optional<vitrine::ImageError>& error)
{
  return error ? error->Max : 0.0;
}

/** Of the scene's own window. */
std::vector<FrameError> OwnFrames(const StabilityCell& cell)
{
  return { { "first", MaxOf(cell.Error) }, { "redrawn", cell.RedrawnError },
    { "shift", cell.Shift.Error }, { "turn", cell.Turn.Error } };
}

/** The first of those with the largest error. */
FrameError WorstOf(const std::vector<FrameError>& frames)
{
  return *std::max_element(frames.begin(), frames.end(),
    [](const FrameError& a, const FrameError& b) { return a.Error < b.Error; });
}

double ExcessOf(const StabilityCell& cell)
{
  return std::max(cell.Shift.Excess, cell.Turn.Excess);
}

bool Flickers(const StabilityCell& cell)
{
  return ExcessOf(cell) > LargestExactExcess();
}

/** The largest error of the windows that exceed their own bounds; 0 if none does. */
double WrongBy(const StabilityCell& cell)
{
  const double own = cell.OwnWindowError();
  double largest = own > LargestExactError(0) ? own : 0.0;
  for (const OtherWindow& other : cell.Others)
  {
    largest = IsWrong(other) ? std::max(largest, other.Error->Max) : largest;
  }
  return largest;
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
  return WrongBy(cell) > 0.0 ? StabilityOutcome::Wrong : StabilityOutcome::Exact;
}

std::string InSteps(double value)
{
  return FormatCell("%.3g/255", 255.0 * value);
}

/** The windows in which there is no truth to judge by. */
std::string NotJudged(const StabilityCell& cell)
{
  std::vector<std::string> names;
  for (const OtherWindow& other : cell.Others)
  {
    if (!other.NotJudged.empty())
    {
      names.push_back(other.Name);
    }
  }
  return Join(names);
}

std::string Describe(const StabilityCell& cell)
{
  if (!cell.Skipped.empty())
  {
    return "refused: " + cell.Skipped;
  }
  std::vector<std::string> faults;
  if (const double error = WrongBy(cell); error > 0.0)
  {
    faults.push_back("wrong by " + InSteps(error));
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
    faults.push_back("flickers by " + InSteps(ExcessOf(cell)));
  }
  if (faults.empty())
  {
    faults.push_back("exact");
  }
  if (const std::string others = NotJudged(cell); !others.empty())
  {
    faults.push_back("not judged in " + others);
  }
  return Join(faults, "; ");
}
}

double StabilityCell::OwnWindowError() const
{
  return WorstOf(OwnFrames(*this)).Error;
}

FrameError StabilityCell::Worst() const
{
  std::vector<FrameError> frames = OwnFrames(*this);
  for (const OtherWindow& other : this->Others)
  {
    frames.push_back({ other.Name, MaxOf(other.Error) });
  }
  return WorstOf(frames);
}

double LargestExactError(int multisamples)
{
  return (multisamples > 0 ? 1.2 : 1.0) / 255.0 + LostAsFloat;
}

double LargestExactExcess()
{
  return 1.5 / 255.0 + LostAsFloat;
}

bool IsWrong(const OtherWindow& other)
{
  return other.Error && other.Error->Max > LargestExactError(other.Multisamples);
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
