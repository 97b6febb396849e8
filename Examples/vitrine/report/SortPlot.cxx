#include "report/SortPlot.h"

#include "Median.h"
#include "OutputPicture.h"
#include "report/TextTable.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/** What is drawn as one line: milliseconds of each run, NaN where there are none. */
struct Line
{
  std::string Name;
  std::array<unsigned char, 3> Color;
  bool IsFloor;
  std::vector<double> Milliseconds;
};

Line MethodLine(const std::vector<SortRun>& runs, vitrine::ListSort method)
{
  Line line{ vitrine::NameOf(method), Colors[static_cast<std::size_t>(method)], false, {} };
  for (const SortRun& run : runs)
  {
    const SortTimes* times = FindTimes(run, method);
    line.Milliseconds.push_back(times ? Median(times->Milliseconds) : std::nan(""));
  }
  return line;
}

Line FloorLine(const std::vector<SortRun>& runs)
{
  Line line{ "no sort", FloorColor, true, {} };
  for (const SortRun& run : runs)
  {
    line.Milliseconds.push_back(Median(run.FloorMilliseconds));
  }
  return line;
}

std::vector<Line> MakeLines(const SortComparison& comparison, const std::vector<SortRun>& runs)
{
  std::vector<Line> lines;
  for (const vitrine::ListSort method : comparison.Settings.Methods)
  {
    lines.push_back(MethodLine(runs, method));
  }
  lines.push_back(FloorLine(runs));
  return lines;
}

/** Runs stand side by side at 0, 1, 2, ...; heights are decimal logarithms. */
void AddLine(vtkChartXY* chart, const Line& line)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(line.Name.c_str());
  for (std::size_t i = 0; i < line.Milliseconds.size(); ++i)
  {
    if (!std::isnan(line.Milliseconds[i]))
    {
      x->InsertNextValue(static_cast<double>(i));
      y->InsertNextValue(std::log10(line.Milliseconds[i]));
    }
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  auto* plot = vtkPlotPoints::SafeDownCast(
    chart->AddPlot(x->GetNumberOfValues() > 1 ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  plot->SetColor(line.Color[0], line.Color[1], line.Color[2], 255);
  plot->SetWidth(2.5f);
  plot->GetPen()->SetLineType(line.IsFloor ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  plot->SetMarkerStyle(line.IsFloor ? vtkPlotPoints::NONE : vtkPlotPoints::CIRCLE);
  plot->SetMarkerSize(7.0f);
}

void SetAxis(vtkAxis* axis, const std::string& title, const std::vector<double>& ticks,
  const std::vector<std::string>& labels, double margin)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> names;
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    positions->InsertNextValue(ticks[i]);
    names->InsertNextValue(labels[i]);
  }
  axis->SetTitle(title);
  axis->SetCustomTickPositions(positions, names);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(ticks.front() - margin, ticks.back() + margin);
  axis->GetLabelProperties()->SetFontSize(14);
  axis->GetTitleProperties()->SetFontSize(15);
}

void SetRunAxis(vtkAxis* axis, const std::string& title, const std::vector<SortRun>& runs)
{
  std::vector<double> ticks;
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    ticks.push_back(static_cast<double>(i));
    labels.push_back(std::to_string(runs[i].Longest));
  }
  SetAxis(axis, title, ticks, labels, 0.15);
}

/** Decades, from that below the least time to that above the most. */
void SetTimeAxis(vtkAxis* axis, const std::vector<Line>& lines)
{
  double low = 0.0;
  double high = 0.0;
  for (const Line& line : lines)
  {
    for (const double milliseconds : line.Milliseconds)
    {
      if (!std::isnan(milliseconds))
      {
        low = std::min(low, std::floor(std::log10(milliseconds)));
        high = std::max(high, std::ceil(std::log10(milliseconds)));
      }
    }
  }
  std::vector<double> ticks;
  std::vector<std::string> labels;
  for (double decade = low; decade <= high; ++decade)
  {
    ticks.push_back(decade);
    labels.push_back(FormatCell("%g", std::pow(10.0, decade)));
  }
  SetAxis(axis, "milliseconds", ticks, labels, 0.0);
}

vtkSmartPointer<vtkChartXY> MakeChart(const SortComparison& comparison,
  const std::vector<SortRun>& runs, const std::string& title, const std::string& xTitle)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  const std::vector<Line> lines = MakeLines(comparison, runs);
  for (const Line& line : lines)
  {
    AddLine(chart, line);
  }
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(17);
  SetRunAxis(chart->GetAxis(vtkAxis::BOTTOM), xTitle, runs);
  SetTimeAxis(chart->GetAxis(vtkAxis::LEFT), lines);
  return chart;
}

/** Where the lines leave room: lists are sorted the slower the longer they are. */
void ShowLegend(vtkChartXY* chart)
{
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(14);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::BOTTOM);
}

std::vector<std::uint8_t> DrawSideBySide(const std::vector<vtkSmartPointer<vtkChartXY>>& charts)
{
  vtkNew<vtkHeadlessRenderWindow> headless;
  vtkRenderWindow* window = headless;
  window->SetSize(Size.Width, Size.Height);
  window->SetMultiSamples(8);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  const float width = static_cast<float>(Size.Width) / static_cast<float>(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    charts[i]->SetAutoSize(false);
    charts[i]->SetSize({ width * static_cast<float>(i), 0.0f, width, Size.Height - 8.0f });
    actor->GetScene()->AddItem(charts[i]);
  }
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Size.Width - 1, Size.Height - 1, /* front= */ 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}
}

void PlotSorts(const SortComparison& comparison, const std::string& path)
{
  const std::string count = std::to_string(comparison.Settings.Lists) + " lists";
  const std::string storage = std::to_string(comparison.Settings.Storage);
  const vtkSmartPointer<vtkChartXY> sizes =
    MakeChart(comparison, comparison.Sizes, count + " of 0 to N elements, in storage for N", "N");
  const vtkSmartPointer<vtkChartXY> lengths = MakeChart(
    comparison, comparison.Lengths, count + " of 0 to n elements, in storage for " + storage, "n");
  ShowLegend(sizes);
  WritePicture(path, DrawSideBySide({ sizes, lengths }), Size);
}

}
