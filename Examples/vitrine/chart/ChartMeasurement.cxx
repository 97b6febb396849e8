#include "chart/ChartMeasurement.h"

#include "VTKMessages.h"
#include "commands/Options.h"
#include "report/ComparisonJson.h"
#include "report/StabilityReport.h"
#include "report/TextTable.h"
#include "scene/DemoScene.h"
#include "scene/Viewpoint.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace program
{

namespace
{
/** Rotation per frame, as if a user turned a model. It affects methods that predict from the previous frame. */
const double DegreesAFrame = 3.75;

/** In names of pictures: truth in float64, rounded once. What the method `truth` draws into a window is another. */
const char* const ReferenceName = "reference";

double OrbitDegrees(int frames)
{
  return DegreesAFrame * (frames - 1);
}

/** What tells whether an input is what it was. */
Json StepJson(const ChartStep& step)
{
  Json input = { { "part", step.Part }, { "scene", step.Input }, { "width", step.Size.Width },
    { "height", step.Size.Height }, { "zoom", step.Zoom } };
  if (!IsDemoScene(step.Input))
  {
    std::error_code error;
    input["bytes"] = std::filesystem::file_size(step.Input, error);
    input["modified"] =
      std::filesystem::last_write_time(step.Input, error).time_since_epoch().count();
  }
  return input;
}

Json FailuresJson(const StabilitySettings& settings)
{
  return { { "methods", settings.Methods }, { "width", settings.Size.Width },
    { "height", settings.Size.Height }, { "repetitions", settings.Repetitions },
    { "orders", settings.Orders }, { "shifts", settings.Shifts }, { "turns", settings.Turns },
    { "other_windows", settings.WithOtherWindows }, { "scenes", ScenesJson(settings.Scenes) } };
}

Json Key(const std::string& part, int number)
{
  return { { "part", part }, { "step", number } };
}

/** A row of `compare` that knows its place in the chart. */
Json PlaceRow(const ComparisonResult& comparison, const MethodResult& result,
  const std::string& part, int number)
{
  Json row = Key(part, number);
  row.update(ToJsonRow(comparison, result));
  return row;
}

/** Why `method` is left out of a step: its frames took too long in one before. Empty if they did not. */
std::string WhyLeftOut(const ChartRecord& record, const std::string& part, int number,
  const std::string& method, double slowest)
{
  for (const Json& row : record.Rows("results"))
  {
    if (row["part"] != part || row["step"] >= number || row["method"] != method ||
      row.contains("skipped"))
    {
      continue;
    }
    const double milliseconds = row["frame_ms"]["median"];
    if (milliseconds > slowest)
    {
      return "a frame of " + row["scene"].get<std::string>() +
        FormatCell(" took %.1f s", milliseconds / 1000.0);
    }
  }
  return "";
}

/** Those of `methods` that are left out, each with its reason. */
std::vector<MethodResult> LeaveOut(const std::vector<std::string>& methods, const ChartPlan& plan,
  const std::string& part, int number, const ChartRecord& record)
{
  std::vector<MethodResult> leftOut;
  for (const std::string& method : methods)
  {
    MethodResult result;
    result.Method = method;
    result.Skipped = WhyLeftOut(record, part, number, method, plan.SlowestFrame);
    if (!result.Skipped.empty())
    {
      leftOut.push_back(result);
    }
  }
  return leftOut;
}

Scene LoadStep(const ChartStep& step)
{
  return step.Loaded ? *step.Loaded : LoadInput(step.Input);
}

ComparisonSettings MakeSettings(const ChartPlan& plan, const ChartStep& step, const Scene& scene)
{
  ComparisonSettings settings;
  settings.Methods = step.Part == "scenes" ? plan.SceneMethods : plan.GrowthMethods;
  settings.Size = step.Size;
  settings.Frames = plan.Frames;
  settings.Orbit = OrbitDegrees(plan.Frames);
  settings.From = scene.Placement.DefaultView;
  settings.From.Zoom *= step.Zoom;
  return settings;
}

/** CompareMethods(), with nothing on stderr of why methods are skipped, which their rows tell. */
ComparisonResult Compare(const Scene& scene, const ComparisonSettings& settings, Progress& progress)
{
  MessageCapture messages;
  ComparisonResult comparison = CompareMethods(scene, settings, progress);
  std::vector<std::string> told;
  for (const MethodResult& result : comparison.Results)
  {
    told.push_back(result.Skipped);
  }
  messages.ShowAllBut(told);
  return comparison;
}

void RecordGrowth(
  const ComparisonResult& comparison, const std::string& part, int number, ChartRecord& record)
{
  Json rows = Json::array();
  for (const MethodResult& result : comparison.Results)
  {
    rows.push_back(PlaceRow(comparison, result, part, number));
  }
  record.Add("results", rows);
}

void MeasureScene(
  const ChartPlan& plan, const ChartStep& step, int number, ChartRecord& record, Progress& progress)
{
  const Scene scene = LoadStep(step);
  RecordScene(Compare(scene, MakeSettings(plan, step, scene), progress), number, record);
}

void MeasureGrowth(
  const ChartPlan& plan, const ChartStep& step, int number, ChartRecord& record, Progress& progress)
{
  const Scene scene = LoadStep(step);
  ComparisonSettings settings = MakeSettings(plan, step, scene);
  const std::vector<MethodResult> leftOut =
    LeaveOut(settings.Methods, plan, step.Part, number, record);
  for (const MethodResult& result : leftOut)
  {
    settings.Methods.erase(
      std::remove(settings.Methods.begin(), settings.Methods.end(), result.Method),
      settings.Methods.end());
  }
  ComparisonResult comparison;
  comparison.Scene = scene.Name;
  comparison.Settings = settings;
  if (!settings.Methods.empty())
  {
    comparison = Compare(scene, settings, progress);
  }
  comparison.Results.insert(comparison.Results.end(), leftOut.begin(), leftOut.end());
  RecordGrowth(comparison, step.Part, number, record);
}

/**
 * Growth is timed in units of its first step, so all steps must be of one run. In another run the machine may be busier
 * or less busy.
 */
void DropUnfinishedGrowth(const ChartPlan& plan, ChartRecord& record)
{
  std::map<std::string, int> counts;
  for (const ChartStep& step : plan.Steps)
  {
    ++counts[step.Part];
  }
  counts.erase("scenes");
  for (const auto& [part, count] : counts)
  {
    if (!record.Has("results", Key(part, count - 1)))
    {
      record.Remove("results", { { "part", part } });
    }
  }
}

void RecordCell(const StabilityCell& cell, ChartRecord& record)
{
  Json row = ToJsonRow(cell);
  const std::string prefix = "failure-" + cell.Scene + "-";
  if (cell.Skipped.empty())
  {
    row["picture"] = record.AddPicture(prefix + cell.Method, cell.Picture, cell.Size);
    row["truth_picture"] = record.AddPicture(prefix + ReferenceName, cell.TruthPicture, cell.Size);
  }
  record.Add("failures", Json::array({ row }));
}
}

Device FindDevice()
{
  const Scene scene = LoadInput("demo:stack,layers=1");
  Stage stage(scene, MakeMethod("blend"), { 8, 8 }, 0);
  stage.Draw(PlaceCamera(scene, {}, 1.0));
  return stage.GetDevice();
}

Json ChartHead(const ChartPlan& plan, const Device& device)
{
  Json head = MeasurementHead(device);
  Json steps = Json::array();
  for (const ChartStep& step : plan.Steps)
  {
    steps.push_back(StepJson(step));
  }
  head["settings"] = { { "opacity", plan.Opacity }, { "frames", plan.Frames },
    { "orbit", OrbitDegrees(plan.Frames) }, { "slowest_frame_ms", plan.SlowestFrame },
    { "scene_methods", plan.SceneMethods }, { "growth_methods", plan.GrowthMethods },
    { "steps", steps }, { "failures", FailuresJson(plan.Failures) } };
  return head;
}

void MeasureSteps(const ChartPlan& plan, ChartRecord& record, Progress& progress)
{
  DropUnfinishedGrowth(plan, record);
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < plan.Steps.size(); ++i)
  {
    const ChartStep& step = plan.Steps[i];
    const int number = numbers[step.Part]++;
    if (record.Has("results", Key(step.Part, number)))
    {
      continue;
    }
    progress.SetTask(std::to_string(i + 1) + " of " + std::to_string(plan.Steps.size()) + ", " +
      step.Input + ": ");
    (step.Part == "scenes" ? MeasureScene : MeasureGrowth)(plan, step, number, record, progress);
  }
}

void MeasureFailures(const ChartPlan& plan, ChartRecord& record, Progress& progress)
{
  const std::string count =
    std::to_string(plan.Failures.Scenes.size() * plan.Failures.Methods.size());
  StabilityListener listener;
  listener.IsKnown = [&record](const std::string& scene, const std::string& method) {
    return record.Has("failures", { { "scene", scene }, { "method", method } });
  };
  listener.Begins = [&](const std::string& scene, const std::string& method)
  {
    progress.SetTask(
      "failures, " + std::to_string(record.Rows("failures").size()) + " of " + count + ": ");
    progress.Show(scene + ", " + method);
  };
  listener.Finished = [&record](const StabilityCell& cell) { RecordCell(cell, record); };
  MeasureStability(plan.Failures, listener);
}

void RecordScene(const ComparisonResult& comparison, int number, ChartRecord& record)
{
  const PictureSize size = comparison.Settings.Size;
  const std::string prefix = "scene-" + std::to_string(number + 1) + "-";
  const std::string truth = comparison.TruthPicture.empty()
    ? ""
    : record.AddPicture(prefix + ReferenceName, comparison.TruthPicture, size);
  Json rows = Json::array();
  for (const MethodResult& result : comparison.Results)
  {
    Json row = PlaceRow(comparison, result, "scenes", number);
    if (result.Skipped.empty())
    {
      row["picture"] = record.AddPicture(prefix + result.Method, result.Picture, size);
    }
    if (!truth.empty())
    {
      row["truth_picture"] = truth;
    }
    rows.push_back(row);
  }
  record.Add("results", rows);
}

}
