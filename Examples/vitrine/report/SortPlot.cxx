#include "report/SortPlot.h"

#include "Median.h"
#include "OutputPicture.h"
#include "report/Plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace program
{

namespace
{
const PictureSize Size = { 1280, 560 };

// The colours of M. Okabe and K. Ito, which the colour-blind tell apart, one for each sort.
const std::array<std::array<unsigned char, 3>, vitrine::AllListSorts.size()> Colors = {
  { { 213, 94, 0 }, { 230, 159, 0 }, { 204, 121, 167 }, { 0, 158, 115 }, { 0, 114, 178 } }
};
const std::array<unsigned char, 3> FloorColor = { 128, 128, 128 };

using ReadMilliseconds = std::function<std::optional<double>(const SortRun& run)>;

/** Runs stand side by side at 0, 1, 2, ...; heights are decimal logarithms. */
void AddPoints(PlotSeries& series, const std::vector<SortRun>& runs, const ReadMilliseconds& read)
{
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    if (const std::optional<double> milliseconds = read(runs[i]))
    {
      series.Points.emplace_back(static_cast<double>(i), std::log10(*milliseconds));
    }
  }
}

PlotSeries MethodLine(const std::vector<SortRun>& runs, vitrine::ListSort method)
{
  PlotSeries line;
  line.Name = vitrine::NameOf(method);
  line.Color = Colors[static_cast<std::size_t>(method)];
  AddPoints(line, runs,
    [method](const SortRun& run) -> std::optional<double>
    {
      const SortTimes* times = FindTimes(run, method);
      return times ? std::optional<double>(Median(times->Milliseconds)) : std::nullopt;
    });
  return line;
}

PlotSeries FloorLine(const std::vector<SortRun>& runs)
{
  PlotSeries line;
  line.Name = "no sort";
  line.Color = FloorColor;
  line.Marker = PlotMarker::None;
  line.IsDashed = true;
  AddPoints(line, runs, [](const SortRun& run) { return Median(run.FloorMilliseconds); });
  return line;
}

PlotAxis RunAxis(const std::string& title, const std::vector<SortRun>& runs)
{
  const double margin = 0.15;
  PlotAxis axis{ title, -margin, static_cast<double>(runs.size()) - 1.0 + margin, {} };
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    axis.Ticks.emplace_back(static_cast<double>(i), std::to_string(runs[i].Longest));
  }
  return axis;
}

PlotAxis TimeAxis(const std::vector<PlotSeries>& lines)
{
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  for (const PlotSeries& line : lines)
  {
    for (const auto& point : line.Points)
    {
      low = std::min(low, std::pow(10.0, point.second));
      high = std::max(high, std::pow(10.0, point.second));
    }
  }
  return LogarithmicAxis("milliseconds", low, high);
}

Plot MakePlot(const SortComparison& comparison, const std::vector<SortRun>& runs,
  const std::string& title, const std::string& xTitle)
{
  Plot plot;
  for (const vitrine::ListSort method : comparison.Settings.Methods)
  {
    plot.Series.push_back(MethodLine(runs, method));
  }
  plot.Series.push_back(FloorLine(runs));
  plot.Title = title;
  plot.X = RunAxis(xTitle, runs);
  plot.Y = TimeAxis(plot.Series);
  return plot;
}
}

void PlotSorts(const SortComparison& comparison, const std::string& path)
{
  const std::string count = std::to_string(comparison.Settings.Lists) + " lists";
  const std::string storage = std::to_string(comparison.Settings.Storage);
  Plot sizes =
    MakePlot(comparison, comparison.Sizes, count + " of 0 to N elements, in storage for N", "N");
  const Plot lengths = MakePlot(
    comparison, comparison.Lengths, count + " of 0 to n elements, in storage for " + storage, "n");
  sizes.Legend = PlotCorner::LowerRight; // lists are sorted the slower the longer they are
  WritePicture(path, DrawPlots({ sizes, lengths }, 2, Size), Size);
}

}
