/**
 * Plots of measurements as a picture, drawn by VTK's charts.
 */
#ifndef VITRINE_PLOTS_H
#define VITRINE_PLOTS_H

#include "methods/Stage.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace program
{

enum class PlotMarker
{
  None,
  Cross,
  Plus,
  Square,
  Circle,
  Diamond
};

/** Points of one colour, marked, joined by a line, or both. */
struct PlotSeries
{
  std::string Name;
  std::array<unsigned char, 3> Color;
  PlotMarker Marker = PlotMarker::Circle;
  bool HasLine = true;
  bool IsDashed = false;
  std::vector<std::pair<double, double>> Points; ///< in the units of the axes
  bool IsOpen = false;                           ///< its marks have a hole
  bool IsInLegend = true;
};

/** From Low to High; nothing is written but the labels of ticks. */
struct PlotAxis
{
  std::string Title;
  double Low;
  double High;
  std::vector<std::pair<double, std::string>> Ticks;
};

enum class PlotCorner
{
  None,
  LowerRight,
  UpperRight
};

struct Plot
{
  std::string Title;
  PlotAxis X;
  PlotAxis Y;
  std::vector<PlotSeries> Series;
  PlotCorner Legend = PlotCorner::None; ///< where the names of series stand
};

/**
 * Returns an axis of decimal logarithms from a little below `low` to a little above `high`, both positive. Ticks are at
 * powers of ten. A short axis also has them at 2 and 5 times these.
 */
PlotAxis LogarithmicAxis(const std::string& title, double low, double high);

/** Draw plots in rows of `columns`: 8-bit RGB, rows from the bottom. */
std::vector<std::uint8_t> DrawPlots(const std::vector<Plot>& plots, int columns, PictureSize size);

}
#endif
