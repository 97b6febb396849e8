#include "report/PlanReport.h"

#include "report/ComparisonJson.h"
#include "report/ComparisonReport.h"
#include "report/TextTable.h"

#include <cmath>

namespace program
{

namespace
{
std::string InSteps(double error)
{
  return std::isfinite(error) ? FormatCell("%.2f", 255.0 * error) : "no bound";
}

std::string SceneLine(const PlanTable& table)
{
  return table.Scene + ", " + std::to_string(table.Size.Width) + "x" +
    std::to_string(table.Size.Height) + ": " + std::to_string(table.Parts) + " parts, " +
    std::to_string(table.Triangles) + " triangles, " +
    std::to_string(table.Facts.Fragments.value_or(0)) + " fragments in up to " +
    std::to_string(table.Facts.LayersMax.value_or(0)) + " layers\n";
}

std::string CheckLines(const PlanTable& table)
{
  const PlanCheck& check = *table.Check;
  std::string lines = "\nmeasured: error at most " + InSteps(check.LargestError) +
    "/255, bound at most " + InSteps(check.LargestBound) + "/255, " +
    std::to_string(check.PixelsBeyondBound) + " pixels beyond their bound";
  if (check.MedianTightness)
  {
    lines +=
      ", bounds " + FormatCell("%.2f", *check.MedianTightness) + " times the error in the median";
  }
  return lines + "\n" + ToTable(check.Comparison);
}

Json CheckJson(const PlanCheck& check)
{
  const std::optional<Regret> regret = RegretOf(check.Comparison);
  Json rows = Json::array();
  for (const MethodResult& result : check.Comparison.Results)
  {
    rows.push_back(ToJsonRow(check.Comparison, result));
  }
  return { { "error_max", check.LargestError }, { "bound_max", check.LargestBound },
    { "pixels_beyond_bound", check.PixelsBeyondBound },
    { "tightness_median", OrNull(check.MedianTightness) },
    { "regret", regret ? Json(regret->Ratio) : Json(nullptr) }, { "results", rows } };
}
}

std::string ToText(const PlanTable& table)
{
  std::vector<TextRow> rows = { { "method", "error/255", "passes", "MB", "why" } };
  for (const PlannedRow& row : table.Rows)
  {
    rows.push_back({ row.Method, InSteps(row.Error), FormatCell("%.2f", row.Passes),
      FormatCell("%.1f", static_cast<double>(row.Bytes) / 1e6), row.Reason });
  }
  return SceneLine(table) + "budget " + InSteps(table.Budget) + "/255: " +
    (table.Rows.empty() ? std::string("nothing is translucent")
                        : table.Rows.front().Method +
          (table.Problem.empty() ? ", which keeps it"
                                 : ", which may not keep it: " + table.Problem)) +
    "\n" + (table.Rows.empty() ? std::string() : "\n" + AlignColumns(rows)) +
    (table.Check ? CheckLines(table) : std::string());
}

std::string ToJson(const PlanTable& table)
{
  Json rows = Json::array();
  for (const PlannedRow& row : table.Rows)
  {
    rows.push_back({ { "method", row.Method },
      { "error", std::isfinite(row.Error) ? Json(row.Error) : Json(nullptr) },
      { "geometry_passes", row.Passes }, { "bytes", row.Bytes }, { "reason", row.Reason } });
  }
  Json json = { { "scene", table.Scene }, { "width", table.Size.Width },
    { "height", table.Size.Height }, { "error_budget", table.Budget }, { "parts", table.Parts },
    { "triangles", table.Triangles }, { "fragments", OrNull(table.Facts.Fragments) },
    { "layers_max", OrNull(table.Facts.LayersMax) },
    { "layers_mean", OrNull(table.Facts.LayersMean) }, { "wrong_guesses", table.WrongGuesses },
    { "problem", table.Problem }, { "methods", rows } };
  json["check"] = table.Check ? CheckJson(*table.Check) : Json(nullptr);
  return JsonText(json);
}

}
