#include "report/LightsReport.h"

#include "Median.h"
#include "report/Json.h"
#include "report/TextTable.h"

namespace program
{

namespace
{
template <typename T>
std::string CellOrUnknown(const char* format, const std::optional<T>& value, double factor = 1.0)
{
  return value ? FormatCell(format, factor * static_cast<double>(*value)) : "?";
}

TextRow RowOf(const LightingRun& run, const ModeResult& result)
{
  const std::string name = run.Name + " " + result.Mode;
  if (!result.Skipped.empty())
  {
    return { name, "skipped: " + result.Skipped };
  }
  const LightingStatistics& told = result.Statistics;
  return { name, std::to_string(run.Lights), FormatCell("%.1f", Median(result.FrameMilliseconds)),
    CellOrUnknown("%.0f", result.FirstFrameMilliseconds),
    CellOrUnknown("%.2f", told.AssignmentMilliseconds),
    CellOrUnknown("%.1f", told.LightsPerClusterMean),
    CellOrUnknown("%.0f", told.LightsPerClusterMax), CellOrUnknown("%.0f", told.Clusters),
    CellOrUnknown("%.0f", told.ClustersUsed),
    CellOrUnknown("%.1f MiB", told.Bytes, 1.0 / 1048576.0),
    CellOrUnknown("%.0f", result.Error, 255.0) };
}

Json LightingRow(const LightingRun& run, const ModeResult& result)
{
  Json row = { { "input", run.Name }, { "mode", result.Mode }, { "lights", run.Lights } };
  if (!result.Skipped.empty())
  {
    row["skipped"] = result.Skipped;
    return row;
  }
  const LightingStatistics& told = result.Statistics;
  if (!result.FrameMilliseconds.empty())
  {
    row["frame_ms"] = Spread(result.FrameMilliseconds, "frames");
  }
  row["first_frame_ms"] = OrNull(result.FirstFrameMilliseconds);
  row["assignment_ms"] = OrNull(told.AssignmentMilliseconds);
  row["lights_per_cluster"] = { { "mean", OrNull(told.LightsPerClusterMean) },
    { "max", OrNull(told.LightsPerClusterMax) } };
  row["clusters"] = OrNull(told.Clusters);
  row["clusters_used"] = OrNull(told.ClustersUsed);
  row["bytes"] = OrNull(told.Bytes);
  row["error"] = result.Error ? Json{ { "max", *result.Error } } : Json(nullptr);
  row["reference"] = run.Reference.empty() ? Json(nullptr) : Json(run.Reference);
  return row;
}
}

std::string ToTable(const std::vector<LightingRun>& runs, const Device& device)
{
  std::vector<TextRow> rows = { { "input and mode", "lights", "ms", "first ms", "assignment ms",
    "lights/cluster", "most", "clusters", "used", "memory", "max error/255" } };
  for (const LightingRun& run : runs)
  {
    for (const ModeResult& result : run.Results)
    {
      rows.push_back(RowOf(run, result));
    }
  }
  return device.Renderer + "\n\n" + AlignColumns(rows);
}

std::string ToJson(
  const std::vector<LightingRun>& runs, const LightingPlan& plan, const Device& device)
{
  Json document = MeasurementHead(device);
  document["settings"] = { { "width", plan.Size.Width }, { "height", plan.Size.Height },
    { "frames", plan.Frames }, { "orbit", plan.Orbit }, { "tile", plan.Settings.TileSize },
    { "slices", plan.Settings.Slices }, { "slice_law", plan.Settings.SliceLaw },
    { "cutoff", plan.Settings.CutOff } };
  if (!runs.empty() && !runs.back().Unfinished.empty())
  {
    document["unfinished"] = runs.back().Name + ": " + runs.back().Unfinished;
  }
  document["results"] = Json::array();
  for (const LightingRun& run : runs)
  {
    for (const ModeResult& result : run.Results)
    {
      document["results"].push_back(LightingRow(run, result));
    }
  }
  return JsonText(document);
}

}
