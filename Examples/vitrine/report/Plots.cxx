#include "report/Plots.h"

#include "report/TextTable.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlotLine.h"
#include "vtkPlotPoints.h"
#include "vtkRect.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
int ToVTK(PlotMarker marker)
{
  switch (marker)
  {
    case PlotMarker::Cross:
      return vtkPlotPoints::CROSS;
    case PlotMarker::Plus:
      return vtkPlotPoints::PLUS;
    case PlotMarker::Square:
      return vtkPlotPoints::SQUARE;
    case PlotMarker::Circle:
      return vtkPlotPoints::CIRCLE;
    case PlotMarker::Diamond:
      return vtkPlotPoints::DIAMOND;
    case PlotMarker::None:
      break;
  }
  return vtkPlotPoints::NONE;
}

vtkSmartPointer<vtkTable> ToTable(const PlotSeries& series)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(series.Name.c_str());
  for (const auto& [a, b] : series.Points)
  {
    x->InsertNextValue(a);
    y->InsertNextValue(b);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

/** Marks with a white hole, in the legend too. */
class OpenMarks : public vtkPlotPoints
{
public:
  static OpenMarks* New();
  vtkTypeMacro(OpenMarks, vtkPlotPoints);

  bool Paint(vtkContext2D* painter) override
  {
    const bool isDrawn = this->Superclass::Paint(painter);
    unsigned char color[3];
    this->GetColor(color);
    const float size = this->GetMarkerSize();
    this->SetColor(255, 255, 255, 255);
    this->SetMarkerSize(0.5f * size);
    this->Superclass::Paint(painter);
    this->SetColor(color[0], color[1], color[2], 255);
    this->SetMarkerSize(size);
    return isDrawn;
  }

  /** VTK's marks in legends have no size of their own. */
  bool PaintLegend(vtkContext2D* painter, const vtkRectf& rect, int index) override
  {
    const bool isDrawn = this->Superclass::PaintLegend(painter, rect, index);
    float middle[2] = { rect.GetX() + 0.5f * rect.GetWidth(),
      rect.GetY() + 0.5f * rect.GetHeight() };
    painter->GetPen()->SetColor(255, 255, 255, 255);
    painter->GetBrush()->SetColor(255, 255, 255, 255);
    painter->GetPen()->SetWidth(4.0f);
    painter->DrawMarkers(this->GetMarkerStyle(), /* highlight= */ false, middle, 1);
    return isDrawn;
  }
};
vtkStandardNewMacro(OpenMarks);

vtkSmartPointer<vtkPlotPoints> MakePlot(const PlotSeries& series)
{
  if (series.HasLine && series.Points.size() > 1)
  {
    return vtkSmartPointer<vtkPlotLine>::New();
  }
  return series.IsOpen ? vtkSmartPointer<vtkPlotPoints>(vtkSmartPointer<OpenMarks>::New())
                       : vtkSmartPointer<vtkPlotPoints>::New();
}

void AddSeries(vtkChartXY* chart, const PlotSeries& series)
{
  const vtkSmartPointer<vtkPlotPoints> plot = MakePlot(series);
  chart->AddPlot(plot);
  plot->SetLegendVisibility(series.IsInLegend);
  plot->SetInputData(ToTable(series), 0, 1);
  plot->SetColor(series.Color[0], series.Color[1], series.Color[2], 255);
  plot->SetWidth(2.5f);
  plot->GetPen()->SetLineType(series.IsDashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  plot->SetMarkerStyle(ToVTK(series.Marker));
  plot->SetMarkerSize(series.HasLine ? 7.0f : 11.0f);
}

void SetAxis(vtkAxis* axis, const PlotAxis& what)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const auto& [position, label] : what.Ticks)
  {
    positions->InsertNextValue(position);
    labels->InsertNextValue(label);
  }
  axis->SetTitle(what.Title);
  axis->SetCustomTickPositions(positions, labels);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(what.Low, what.High);
  axis->GetLabelProperties()->SetFontSize(14);
  axis->GetTitleProperties()->SetFontSize(15);
}

void ShowLegend(vtkChartXY* chart, PlotCorner corner)
{
  chart->SetShowLegend(corner != PlotCorner::None);
  chart->GetLegend()->SetLabelSize(14);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(
    corner == PlotCorner::LowerRight ? vtkChartLegend::BOTTOM : vtkChartLegend::TOP);
}

vtkSmartPointer<vtkChartXY> MakeChart(const Plot& plot)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  for (const PlotSeries& series : plot.Series)
  {
    AddSeries(chart, series);
  }
  chart->SetTitle(plot.Title);
  chart->GetTitleProperties()->SetFontSize(17);
  SetAxis(chart->GetAxis(vtkAxis::BOTTOM), plot.X);
  SetAxis(chart->GetAxis(vtkAxis::LEFT), plot.Y);
  ShowLegend(chart, plot.Legend);
  return chart;
}

void PlaceCharts(
  vtkContextActor* actor, const std::vector<Plot>& plots, int columns, PictureSize size)
{
  const int count = static_cast<int>(plots.size());
  const int rows = (count + columns - 1) / columns;
  const float width = static_cast<float>(size.Width) / static_cast<float>(columns);
  const float height = static_cast<float>(size.Height) / static_cast<float>(rows);
  for (int i = 0; i < count; ++i)
  {
    const vtkSmartPointer<vtkChartXY> chart = MakeChart(plots[static_cast<std::size_t>(i)]);
    const float x = width * static_cast<float>(i % columns);
    const float y = height * static_cast<float>(rows - 1 - i / columns);
    chart->SetAutoSize(false);
    chart->SetSize({ x, y, width, height - 8.0f }); // the title stands close to the top
    actor->GetScene()->AddItem(chart);
  }
}
}

PlotAxis LogarithmicAxis(const std::string& title, double low, double high)
{
  const double shortest = 0.7; // decades, so that there are always two ticks
  const double span = std::log10(high) - std::log10(low);
  const double margin = std::max(0.07 * span, 0.5 * (shortest - span));
  PlotAxis axis{ title, std::log10(low) - margin, std::log10(high) + margin, {} };
  const bool isShort = axis.High - axis.Low < 2.0;
  for (double decade = std::floor(axis.Low); decade <= axis.High; ++decade)
  {
    for (const double step :
      isShort ? std::vector<double>{ 1.0, 2.0, 5.0 } : std::vector<double>{ 1.0 })
    {
      const double place = decade + std::log10(step);
      if (place >= axis.Low && place <= axis.High)
      {
        axis.Ticks.emplace_back(place, FormatCell("%g", std::pow(10.0, place)));
      }
    }
  }
  return axis;
}

std::vector<std::uint8_t> DrawPlots(const std::vector<Plot>& plots, int columns, PictureSize size)
{
  vtkNew<vtkHeadlessRenderWindow> headless;
  vtkRenderWindow* window = headless;
  window->SetSize(size.Width, size.Height);
  window->SetMultiSamples(8);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  PlaceCharts(actor, plots, columns, size);
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size.Width - 1, size.Height - 1, /* front= */ 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

}
