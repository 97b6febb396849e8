#include "report/CullReport.h"

#include "Median.h"
#include "report/Json.h"
#include "report/TextTable.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace program
{

namespace
{
using FrameValue = std::function<double(const CullFrame&)>;

std::vector<double> Values(const CullRun& run, const FrameValue& value)
{
  std::vector<double> values;
  for (const CullFrame& frame : run.Frames)
  {
    values.push_back(value(frame));
  }
  return values;
}

double Sum(const CullRun& run, const FrameValue& value)
{
  double sum = 0.0;
  for (const double each : Values(run, value))
  {
    sum += each;
  }
  return sum;
}

double Mean(const CullRun& run, const FrameValue& value)
{
  return Sum(run, value) / static_cast<double>(run.Frames.size());
}

double Drawn(const CullFrame& frame)
{
  return static_cast<double>(frame.Drawn);
}
double Ideal(const CullFrame& frame)
{
  return static_cast<double>(frame.Ideal);
}
double Wrong(const CullFrame& frame)
{
  return static_cast<double>(frame.WrongPixels);
}
double CullTimeOf(const CullFrame& frame)
{
  return frame.CullMilliseconds;
}
double With(const CullFrame& frame)
{
  return frame.FrameMilliseconds;
}
double Without(const CullFrame& frame)
{
  return frame.FrameMillisecondsWithout;
}

double Ideally(const CullFrame& frame)
{
  return frame.FrameMillisecondsIdeal;
}

template <class Value>
std::string NameOf(const std::map<std::string, Value>& names, Value value)
{
  return std::find_if(
    names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; })
    ->first;
}

/** Of all parts, the share that is not drawn. */
double CulledShare(const CullRun& run)
{
  return 1.0 - Mean(run, Drawn) / static_cast<double>(run.Parts);
}

/** Of all parts, the share that a perfect culler would not draw; translucent parts are no matter of its. */
std::optional<double> IdealShare(const CullRun& run)
{
  if (run.OpaqueParts == 0)
  {
    return std::nullopt;
  }
  return 1.0 - Mean(run, Ideal) / static_cast<double>(run.OpaqueParts);
}

std::string Share(const std::optional<double>& share)
{
  return share ? FormatCell("%.1f %%", 100.0 * *share) : "?";
}

TextRow RowOf(const CullRun& run)
{
  return { run.Name, std::to_string(run.Parts), FormatCell("%.0f", Mean(run, Drawn)),
    run.OpaqueParts > 0 ? FormatCell("%.0f", Mean(run, Ideal)) : "?", Share(CulledShare(run)),
    Share(IdealShare(run)), FormatCell("%.2f", Median(Values(run, CullTimeOf))),
    FormatCell("%.2f", Median(Values(run, With))), FormatCell("%.2f", Median(Values(run, Without))),
    run.HasIdealFrames ? FormatCell("%.2f", Median(Values(run, Ideally))) : "?",
    FormatCell("%.0f", Sum(run, Wrong)) };
}

using Counts = std::map<std::string, std::size_t>;

std::vector<std::pair<std::string, std::size_t>> MostFrequentFirst(const Counts& counts)
{
  std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(
    sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return sorted;
}

/** Of props in all frames. */
Counts ReasonsOf(const CullRun& run)
{
  Counts reasons;
  for (const CullFrame& frame : run.Frames)
  {
    for (const auto& [reason, count] : frame.Props)
    {
      reasons[reason] += count;
    }
  }
  return reasons;
}

double PerFrame(const CullRun& run, std::size_t count)
{
  return static_cast<double>(count) / static_cast<double>(run.Frames.size());
}

Json PropsJson(const CullRun& run)
{
  Json props = Json::array();
  for (const auto& [reason, count] : MostFrequentFirst(ReasonsOf(run)))
  {
    props.push_back({ { "reason", reason }, { "per_frame", PerFrame(run, count) } });
  }
  return props;
}

Json RunJson(const CullRun& run)
{
  Json poses = Json::array();
  for (const CullFrame& frame : run.Frames)
  {
    poses.push_back({ { "mode", frame.Mode }, { "reason", frame.Reason }, { "lines", frame.Lines },
      { "drawn", frame.Drawn },
      { "ideal", run.OpaqueParts > 0 ? Json(frame.Ideal) : Json(nullptr) },
      { "cull_ms", frame.CullMilliseconds }, { "frame_ms", frame.FrameMilliseconds },
      { "frame_ms_without", frame.FrameMillisecondsWithout },
      { "frame_ms_ideal", run.HasIdealFrames ? Json(Ideally(frame)) : Json(nullptr) },
      { "wrong_pixels", frame.WrongPixels } });
  }
  return { { "input", run.Name }, { "parts", run.Parts }, { "opaque_parts", run.OpaqueParts },
    { "drawn", Mean(run, Drawn) },
    { "ideal", run.OpaqueParts > 0 ? Json(Mean(run, Ideal)) : Json(nullptr) },
    { "culled_share", CulledShare(run) }, { "ideal_share", OrNull(IdealShare(run)) },
    { "cull_ms", Median(Values(run, CullTimeOf)) }, { "frame_ms", Median(Values(run, With)) },
    { "frame_ms_without", Median(Values(run, Without)) },
    { "frame_ms_ideal", run.HasIdealFrames ? Json(Median(Values(run, Ideally))) : Json(nullptr) },
    { "wrong_pixels", static_cast<std::int64_t>(Sum(run, Wrong)) }, { "props", PropsJson(run) },
    { "poses", poses } };
}

/** Modes and reasons of frames, and of props. */
std::string ReasonsText(const CullRun& run)
{
  std::map<std::string, std::size_t> frames;
  for (const CullFrame& frame : run.Frames)
  {
    ++frames[frame.Reason.empty() ? frame.Mode : frame.Mode + ": " + frame.Reason];
  }
  std::string text = "\n" + run.Name + "\n";
  for (const auto& [mode, count] : MostFrequentFirst(frames))
  {
    text += "  " + std::to_string(count) + " frames: " + mode + "\n";
  }
  for (const auto& [reason, count] : MostFrequentFirst(ReasonsOf(run)))
  {
    text += "  " + FormatCell("%.1f", PerFrame(run, count)) + " props a frame: " + reason + "\n";
  }
  return text;
}
}

std::string ToTable(const std::vector<CullRun>& runs)
{
  std::vector<TextRow> rows = { { "input", "parts", "drawn", "ideal", "culled", "ideally",
    "cull ms", "frame ms", "without", "ideal ms", "wrong pixels" } };
  for (const CullRun& run : runs)
  {
    rows.push_back(RowOf(run));
  }
  std::string text = runs.front().DrawnBy.Renderer + "\n\n" + AlignColumns(rows);
  for (const CullRun& run : runs)
  {
    text += ReasonsText(run);
  }
  return text;
}

std::string ToJson(const std::vector<CullRun>& runs, const std::string& unfinished)
{
  const CullSettings& settings = runs.front().Settings;
  Json document = MeasurementHead(runs.front().DrawnBy);
  document["settings"] = { { "width", settings.Size.Width }, { "height", settings.Size.Height },
    { "multisamples", settings.Multisamples }, { "poses", settings.Poses },
    { "seed", settings.Seed }, { "method", settings.Method },
    { "buffer_lines", settings.BufferLines }, { "turn_degrees", settings.TurnDegrees },
    { "skipped_poses", settings.SkippedPoses },
    { "projection", NameOf(NamesOfProjections(), settings.Projection) },
    { "as", NameOf(NamesOfForms(), settings.Form) }, { "opaque_from", OrNull(settings.OpaqueFrom) },
    { "samples", runs.front().Samples } };
  if (!unfinished.empty())
  {
    document["unfinished"] = unfinished;
  }
  document["results"] = Json::array();
  for (const CullRun& run : runs)
  {
    if (!run.Frames.empty())
    {
      document["results"].push_back(RunJson(run));
    }
  }
  return JsonText(document);
}

std::int64_t CountWrongPixels(const std::vector<CullRun>& runs)
{
  double wrong = 0.0;
  for (const CullRun& run : runs)
  {
    wrong += Sum(run, Wrong);
  }
  return static_cast<std::int64_t>(wrong);
}

}
