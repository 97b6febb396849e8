#include "report/ChartPlot.h"

#include "OutputPicture.h"
#include "chart/MethodFamily.h"
#include "report/Plots.h"
#include "report/TextTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace program
{

namespace
{
const PictureSize PlotSize = { 640, 480 };
const double ZeroLane = 0.12; // of an axis, below what has a logarithm; there zeros lie
const std::array<unsigned char, 3> Black = { 0, 0, 0 };
const char* const Cost = "time";
const char* const Error = "max";

const std::string Open = "open-";

bool IsOpen(const MethodFamily& family)
{
  return family.Marker.compare(0, Open.size(), Open) == 0;
}

PlotMarker MarkerOf(const MethodFamily& family)
{
  static const std::map<std::string, PlotMarker> markers = { { "circle", PlotMarker::Circle },
    { "square", PlotMarker::Square }, { "diamond", PlotMarker::Diamond },
    { "plus", PlotMarker::Plus }, { "cross", PlotMarker::Cross } };
  return markers.at(IsOpen(family) ? family.Marker.substr(Open.size()) : family.Marker);
}

struct Range
{
  double Low = std::numeric_limits<double>::max();
  double High = 0.0;
  bool HasZero = false;

  void Include(double value)
  {
    this->HasZero = this->HasZero || value <= 0.0;
    this->Low = value > 0.0 ? std::min(this->Low, value) : this->Low;
    this->High = std::max(this->High, value);
  }
};

/** Zero has no logarithm: it has a lane of its own below. */
PlotAxis AxisOf(const std::string& title, const Range& range)
{
  PlotAxis axis = range.High > 0.0 ? LogarithmicAxis(title, range.Low, range.High)
                                   : LogarithmicAxis(title, 1.0, 1.0);
  if (range.HasZero)
  {
    const double lane = ZeroLane * (axis.High - axis.Low);
    axis.Low -= lane;
    axis.Ticks.emplace(axis.Ticks.begin(), axis.Low + 0.5 * lane, "0");
  }
  return axis;
}

double PlaceOn(const PlotAxis& axis, double value)
{
  return value > 0.0 ? std::log10(value) : axis.Ticks.front().first;
}

bool IsTold(const Json& point)
{
  return point["values"][Cost].is_number() && point["values"][Error].is_number();
}

PlotSeries FamilySeries(const Json& scene, const MethodFamily& family, const Plot& plot)
{
  PlotSeries series;
  series.Name = family.Name;
  series.Color = family.Color;
  series.Marker = MarkerOf(family);
  series.IsOpen = IsOpen(family);
  series.HasLine = false;
  for (const Json& point : scene["points"])
  {
    if (point["family"] == family.Name && IsTold(point))
    {
      series.Points.emplace_back(
        PlaceOn(plot.X, point["values"][Cost]), PlaceOn(plot.Y, point["values"][Error]));
    }
  }
  return series;
}

const Json& FindPoint(const Json& scene, const Json& method)
{
  return *std::find_if(scene["points"].begin(), scene["points"].end(),
    [&method](const Json& point) { return point["method"] == method; });
}

/** A staircase below and left of which no method lies. */
PlotSeries FrontSeries(const Json& scene, const Plot& plot)
{
  PlotSeries series;
  series.Name = "front";
  series.Color = Black;
  series.Marker = PlotMarker::None;
  double height = plot.Y.High;
  for (const Json& method : scene["fronts"][Cost][Error])
  {
    const Json& values = FindPoint(scene, method)["values"];
    const double x = PlaceOn(plot.X, values[Cost]);
    series.Points.emplace_back(x, height);
    height = PlaceOn(plot.Y, values[Error]);
    series.Points.emplace_back(x, height);
  }
  series.Points.emplace_back(plot.X.High, height);
  return series;
}

Plot ScenePlot(const Json& scene)
{
  Range costs;
  Range errors;
  for (const Json& point : scene["points"])
  {
    if (IsTold(point))
    {
      costs.Include(point["values"][Cost]);
      errors.Include(point["values"][Error]);
    }
  }
  const std::string reference =
    scene["reference"].is_string() ? std::string(scene["reference"]) : "?";
  Plot plot;
  plot.Title = scene["scene"];
  plot.X = AxisOf("frame time, " + reference + " = 1", costs);
  plot.Y = AxisOf("largest error in 1/255", errors);
  for (const MethodFamily& family : MethodFamilies())
  {
    plot.Series.push_back(FamilySeries(scene, family, plot));
  }
  plot.Series.erase(std::remove_if(plot.Series.begin(), plot.Series.end(),
                      [](const PlotSeries& series) { return series.Points.empty(); }),
    plot.Series.end());
  plot.Series.push_back(FrontSeries(scene, plot));
  return plot;
}

/** Room on the right in which there are no points. */
void ShowLegend(Plot& plot)
{
  const double share = 0.5; // of the axis as it is
  plot.X.High += share * (plot.X.High - plot.X.Low);
  plot.Legend = PlotCorner::UpperRight;
}

std::string LineName(const Json& line)
{
  const std::string method = line["method"];
  return line["fit"].is_object() ? method + FormatCell(": %.2f", line["fit"]["exponent"]) : method;
}

using Points = std::vector<std::pair<double, double>>;

Points PlaceOn(const Plot& plot, const Json& line)
{
  Points places;
  for (const Json& point : line["points"])
  {
    places.emplace_back(PlaceOn(plot.X, point[0]), PlaceOn(plot.Y, point[1]));
  }
  return places;
}

/** The power law, dashed, over the range that it was fitted to. */
PlotSeries FitSeries(const Json& fit)
{
  PlotSeries series{ "fit", Black, PlotMarker::None, true, /* IsDashed= */ true, {}, false,
    /* IsInLegend= */ false };
  for (const char* end : { "from", "to" })
  {
    const double x = fit[end];
    const double y = std::pow(x, fit["exponent"].get<double>()) * fit["factor"].get<double>();
    series.Points.emplace_back(std::log10(x), std::log10(y));
  }
  return series;
}

/** A line, and marks on it; VTK's lines have no open marks. */
void AddLine(Plot& plot, const Json& line)
{
  const MethodFamily& family = FamilyOf(line["method"]);
  const Points places = PlaceOn(plot, line);
  plot.Series.push_back({ "line", family.Color, PlotMarker::None, true, false, places, false,
    /* IsInLegend= */ false });
  plot.Series.push_back({ LineName(line), family.Color, MarkerOf(family), /* HasLine= */ false,
    false, places, IsOpen(family), true });
  if (line["fit"].is_object())
  {
    plot.Series.push_back(FitSeries(line["fit"]));
  }
}

Plot GrowthPlot(const Json& growth)
{
  Range xs;
  Range ys;
  for (const Json& line : growth["lines"])
  {
    for (const Json& point : line["points"])
    {
      xs.Include(point[0]);
      ys.Include(point[1]);
    }
  }
  Plot plot;
  plot.Title = growth["title"];
  plot.X = AxisOf(growth["x"], xs);
  plot.Y = AxisOf(growth["y"], ys);
  for (const Json& line : growth["lines"])
  {
    AddLine(plot, line);
  }
  ShowLegend(plot);
  return plot;
}

void WritePlots(const std::string& path, const std::vector<Plot>& plots, int mostColumns)
{
  const int count = static_cast<int>(plots.size());
  const int columns = std::min(count, mostColumns);
  const int rows = (count + columns - 1) / columns;
  const PictureSize size = { columns * PlotSize.Width, rows * PlotSize.Height };
  WritePicture(path, DrawPlots(plots, columns, size), size);
}
}

void PlotChart(const ChartRecord& record)
{
  std::vector<Plot> scenes;
  for (const Json& scene : record.Rows("scenes"))
  {
    scenes.push_back(ScenePlot(scene));
  }
  ShowLegend(scenes.front());
  WritePlots(record.PathOf(ErrorPlotFile), scenes, 3);
  std::vector<Plot> growths;
  for (const Json& growth : record.Rows("growth"))
  {
    growths.push_back(GrowthPlot(growth));
  }
  if (!growths.empty())
  {
    WritePlots(record.PathOf(GrowthPlotFile), growths, 2);
  }
}

}
