#include "report/PaperReport.h"

#include "report/ComparisonJson.h"
#include "report/FaceOrderReport.h"
#include "report/TextTable.h"

#include <algorithm>

namespace program
{

namespace
{
double FramesPerSecond(const MethodResult& result)
{
  return 1000.0 / result.Median();
}

double MegapixelsPerSecond(const ComparisonResult& comparison, const MethodResult& result)
{
  const PictureSize size = comparison.Settings.Size;
  return 1e-6 * size.Width * size.Height * FramesPerSecond(result);
}

/** Of the frame rate of blend, which is always among the methods. */
double ShareOfBlend(const ComparisonResult& comparison, const MethodResult& result)
{
  const auto blend = std::find_if(comparison.Results.begin(), comparison.Results.end(),
    [](const MethodResult& other) { return other.Method == "blend"; });
  return blend->Median() / result.Median();
}

const TextRow& PaperHead()
{
  static const TextRow head = { "layers", "method", "ms", "fps", "Mpixel/s", "share of blend",
    "paper's share", "factor", "layers there", "max error/255" };
  return head;
}

TextRow ToCells(const PaperTable& table, const PaperStep& step, const MethodResult& result)
{
  TextRow cells = { std::to_string(step.Layers), result.Method };
  if (!result.Skipped.empty())
  {
    cells.push_back("skipped: " + result.Skipped);
    return cells;
  }
  const double share = ShareOfBlend(step.Comparison, result);
  const std::optional<double> paper = PaperShare(table, result.Method, step.Layers);
  const std::optional<std::int64_t> layers = result.Statistics.LayersMax;
  cells.insert(cells.end(),
    { FormatCell("%.1f", result.Median()), FormatCell("%.2f", FramesPerSecond(result)),
      FormatCell("%.2f", MegapixelsPerSecond(step.Comparison, result)),
      FormatCell("%.1f %%", 100.0 * share), paper ? FormatCell("%.1f %%", 100.0 * *paper) : "-",
      paper ? FormatCell("%.1f", share / *paper) : "-", layers ? std::to_string(*layers) : "?",
      result.Error ? FormatCell("%.2f", 255.0 * result.Error->Max) : "?" });
  return cells;
}

std::string ToText(const PaperResult& result)
{
  std::vector<TextRow> rows = { PaperHead() };
  for (const PaperStep& step : result.Steps)
  {
    for (const MethodResult& method : step.Comparison.Results)
    {
      rows.push_back(ToCells(*result.Table, step, method));
    }
  }
  const ComparisonResult& first = result.Steps.front().Comparison;
  const PictureSize size = first.Settings.Size;
  return result.Table->Title + ": " + result.Table->Scene + ", " + std::to_string(size.Width) +
    "x" + std::to_string(size.Height) + ", " + first.GL.Renderer + "\n" + AlignColumns(rows);
}

Json ToJsonRow(const PaperTable& table, const PaperStep& step, const MethodResult& result)
{
  Json row = ToJsonRow(step.Comparison, result);
  if (result.Skipped.empty())
  {
    row["fps"] = FramesPerSecond(result);
    row["mpixel_s"] = MegapixelsPerSecond(step.Comparison, result);
    row["share_of_blend"] = ShareOfBlend(step.Comparison, result);
    row["paper_share"] = OrNull(PaperShare(table, result.Method, step.Layers));
  }
  return row;
}

Json ToJsonRows(const std::vector<PaperResult>& results)
{
  Json rows = Json::array();
  for (const PaperResult& result : results)
  {
    for (const PaperStep& step : result.Steps)
    {
      for (const MethodResult& method : step.Comparison.Results)
      {
        rows.push_back(ToJsonRow(*result.Table, step, method));
      }
    }
  }
  return rows;
}
}

std::string ToText(const PaperResults& results)
{
  std::string text;
  for (const PaperResult& result : results.Tables)
  {
    text += (text.empty() ? "" : "\n") + ToText(result);
  }
  if (results.Faces)
  {
    text += (text.empty() ? "" : "\n") + ToText(*results.Faces);
  }
  return text;
}

std::string ToJson(const PaperResults& results)
{
  Json document = MeasurementHead(results.GL);
  if (!results.Tables.empty())
  {
    document["settings"] = ToJson(results.Tables.front().Steps.front().Comparison.Settings);
    document["results"] = ToJsonRows(results.Tables);
  }
  if (results.Faces)
  {
    document["faces"] = ToJsonRows(*results.Faces);
  }
  return JsonText(document);
}

}
