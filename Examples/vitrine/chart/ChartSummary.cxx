#include "chart/ChartSummary.h"

#include "chart/ChartMeasures.h"
#include "chart/GrowthFit.h"
#include "chart/MethodFamily.h"
#include "chart/ParetoFront.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace program
{

namespace
{
const char* const PreferredReference = "vtk-oit";
const double MiB = 1024.0 * 1024.0;

using Rows = std::vector<const Json*>;

Rows Select(const Json& results, const std::string& part)
{
  Rows rows;
  for (const Json& row : results)
  {
    if (row["part"] == part)
    {
      rows.push_back(&row);
    }
  }
  return rows;
}

Rows SelectStep(const Json& results, const std::string& part, int step)
{
  Rows rows;
  for (const Json* row : Select(results, part))
  {
    if ((*row)["step"] == step)
    {
      rows.push_back(row);
    }
  }
  return rows;
}

bool Ran(const Json& row)
{
  return !row.contains("skipped");
}

double Milliseconds(const Json& row)
{
  return row["frame_ms"]["median"];
}

/** Null if no method ran. */
const Json* FindReference(const Rows& step)
{
  const Json* reference = nullptr;
  for (const Json* row : step)
  {
    const bool isPreferred = (*row)["method"] == PreferredReference;
    if (Ran(*row) && (!reference || isPreferred))
    {
      reference = row;
    }
  }
  return reference;
}

Json NumberOrNull(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json PointValues(const Json& row)
{
  Json values = Json::object();
  for (const std::vector<ChartMeasure>* measures : { &CostMeasures(), &ErrorMeasures() })
  {
    for (const ChartMeasure& measure : *measures)
    {
      values[measure.Name] = NumberOrNull(measure.Read(row));
    }
  }
  return values;
}

Json FrontMethods(const Rows& rows, const ChartMeasure& cost, const ChartMeasure& error)
{
  std::vector<CostAndError> choices;
  for (const Json* row : rows)
  {
    choices.push_back({ cost.Read(*row), error.Read(*row) });
  }
  Json methods = Json::array();
  for (const std::size_t i : FindParetoFront(choices))
  {
    methods.push_back((*rows[i])["method"]);
  }
  return methods;
}

Json Fronts(const Rows& rows)
{
  Json fronts = Json::object();
  for (const ChartMeasure& cost : CostMeasures())
  {
    for (const ChartMeasure& error : ErrorMeasures())
    {
      fronts[cost.Name][error.Name] = FrontMethods(rows, cost, error);
    }
  }
  return fronts;
}

Json SummariseScene(const Rows& step)
{
  const Json& first = *step.front();
  Json points = Json::array();
  Rows ran;
  for (const Json* row : step)
  {
    if (Ran(*row))
    {
      ran.push_back(row);
      points.push_back({ { "method", (*row)["method"] }, { "family", (*row)["family"] },
        { "values", PointValues(*row) } });
    }
  }
  const Json* reference = FindReference(step);
  return { { "step", first["step"] }, { "scene", first["scene"] }, { "width", first["width"] },
    { "height", first["height"] },
    { "reference", reference ? (*reference)["method"] : Json(nullptr) },
    { "truth_picture", first.value("truth_picture", Json(nullptr)) }, { "points", points },
    { "fronts", Fronts(ran) } };
}

/** One chart of growth: what is on its axes. */
struct Growth
{
  std::string Part;
  std::string Cost;
  std::string Title;
  std::string XTitle;
  std::function<double(const Json& row)> X;
};

const std::vector<Growth>& Growths()
{
  const auto layers = [](const Json& row) { return NumberOrNaN(row, "layers_max"); };
  const auto fragments = [](const Json& row) { return NumberOrNaN(row, "fragments"); };
  const auto pixels = [](const Json& row)
  { return NumberOrNaN(row, "width") * NumberOrNaN(row, "height"); };
  static const std::vector<Growth> growths = {
    { "layers", "time", "Time against layers", "layers", layers },
    { "layers", "memory", "Memory against layers", "layers", layers },
    { "fragments", "time", "Time against fragments", "fragments", fragments },
    { "resolution", "time", "Time against resolution", "pixels", pixels },
  };
  return growths;
}

Json FitJson(const std::optional<GrowthFit>& fit)
{
  if (!fit)
  {
    return nullptr;
  }
  return { { "exponent", fit->Exponent }, { "factor", fit->Factor }, { "from", fit->From },
    { "to", fit->To }, { "points", fit->Points }, { "off_by", fit->OffBy } };
}

std::vector<std::string> MethodsOf(const Rows& rows)
{
  std::vector<std::string> methods;
  for (const Json* row : rows)
  {
    const std::string method = (*row)["method"];
    if (std::find(methods.begin(), methods.end(), method) == methods.end())
    {
      methods.push_back(method);
    }
  }
  return methods;
}

/** The x of all rows of a step: the most that any method counted, since some stop counting before the others. */
double StepX(const Growth& growth, const Rows& rows, const Json& step)
{
  double most = std::nan("");
  for (const Json* row : rows)
  {
    if ((*row)["step"] == step && Ran(*row))
    {
      most = std::fmax(most, growth.X(*row));
    }
  }
  return most;
}

Json Line(const Growth& growth, const Rows& rows, const std::string& method, double unit)
{
  Json points = Json::array();
  std::vector<GrowthPoint> toFit;
  Json leftOff = nullptr;
  Json losesFrom = nullptr;
  for (const Json* row : rows)
  {
    if ((*row)["method"] != method)
    {
      continue;
    }
    if (!Ran(*row))
    {
      leftOff = leftOff.is_null() ? (*row)["skipped"] : leftOff;
      continue;
    }
    const double y =
      growth.Cost == "time" ? Milliseconds(*row) / unit : NumberOrNaN(*row, "bytes") / unit;
    const double x = StepX(growth, rows, (*row)["step"]);
    if (std::isfinite(x) && std::isfinite(y))
    {
      toFit.push_back({ x, y });
      points.push_back({ x, y });
    }
    if (losesFrom.is_null() && NumberOrNaN(*row, "lost") > 0.0)
    {
      losesFrom = NumberOrNull(x);
    }
  }
  return { { "method", method }, { "family", FamilyOf(method).Name }, { "points", points },
    { "fit", FitJson(FitGrowth(toFit)) }, { "loses_from", losesFrom }, { "left_off", leftOff } };
}

/** Nothing if no method ran in the first step. */
Json SummariseOne(const Growth& growth, const Json& results)
{
  const Rows rows = Select(results, growth.Part);
  const Json* reference = FindReference(SelectStep(results, growth.Part, 0));
  if (!reference)
  {
    return nullptr;
  }
  const bool isTime = growth.Cost == "time";
  Json lines = Json::array();
  for (const std::string& method : MethodsOf(rows))
  {
    lines.push_back(Line(growth, rows, method, isTime ? Milliseconds(*reference) : MiB));
  }
  const std::string unit =
    "frame time, " + std::string((*reference)["method"]) + " at the left end = 1";
  return { { "part", growth.Part }, { "cost", growth.Cost }, { "title", growth.Title },
    { "x", growth.XTitle }, { "y", isTime ? unit : "MiB" }, { "lines", lines } };
}
}

Json AddRatios(const Json& results)
{
  Json rows = results;
  for (Json& row : rows)
  {
    row["family"] = FamilyOf(row["method"]).Name;
    const Json* reference = FindReference(SelectStep(results, row["part"], row["step"]));
    if (Ran(row) && reference)
    {
      row["ratio"] = Milliseconds(row) / Milliseconds(*reference);
      row["ratio_to"] = (*reference)["method"];
    }
  }
  return rows;
}

Json SummariseScenes(const Json& results)
{
  Json scenes = Json::array();
  for (int step = 0;; ++step)
  {
    const Rows rows = SelectStep(results, "scenes", step);
    if (rows.empty())
    {
      return scenes;
    }
    scenes.push_back(SummariseScene(rows));
  }
}

Json SummariseGrowth(const Json& results)
{
  Json summary = Json::array();
  for (const Growth& growth : Growths())
  {
    const Json one = SummariseOne(growth, results);
    if (!one.is_null())
    {
      summary.push_back(one);
    }
  }
  return summary;
}

}
