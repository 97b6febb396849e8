/** The results of `plan` for people and for programs. */
#ifndef VITRINE_PLAN_REPORT_H
#define VITRINE_PLAN_REPORT_H

#include "commands/Comparison.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** A way of drawing frames, as vtkErrorBudgetTransparencyPass plans it. */
struct PlannedRow
{
  std::string Method;
  double Error = 0.0; ///< the largest that it can have; infinity if there is no bound
  double Passes = 1.0;
  std::int64_t Bytes = 0;
  std::string Reason;
};

/** What was found by measuring. Errors and bounds are of channels in [0, 1]. */
struct PlanCheck
{
  ComparisonResult Comparison; ///< of all planned methods, and automatic
  double LargestError = 0.0;
  double LargestBound = 0.0;
  std::int64_t PixelsBeyondBound = 0; ///< whose error exceeds the pixel's bound
  std::optional<double>
    MedianTightness; ///< bound over error, of pixels whose error exceeds 0.25/255
};

struct PlanTable
{
  std::string Scene;
  PictureSize Size{};
  double Budget = 0.0;
  std::int64_t Parts = 0;
  std::int64_t Triangles = 0;
  MethodStatistics Facts;
  std::int64_t WrongGuesses = 0;
  std::string Problem;          ///< why the budget is not promised; empty if it is
  std::vector<PlannedRow> Rows; ///< the first one is the choice
  std::optional<PlanCheck> Check;
};

/** A line for each method, the chosen one first, and what was measured. */
std::string ToText(const PlanTable& table);
std::string ToJson(const PlanTable& table);

}
#endif
