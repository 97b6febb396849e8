#include "report/ComparisonReport.h"

#include "Median.h"
#include "report/ComparisonJson.h"
#include "report/TextTable.h"

namespace program
{

namespace
{
std::string Bytes(const std::optional<std::int64_t>& bytes)
{
  return bytes ? FormatCell("%.1f MiB", *bytes / 1048576.0) : "?";
}

std::string Integer(const std::optional<std::int64_t>& value)
{
  return value ? std::to_string(*value) : "?";
}

TextRow ErrorCells(const std::optional<vitrine::ImageError>& error)
{
  if (!error)
  {
    return { "?", "?", "?", "?", "?" };
  }
  return { FormatCell("%.2f", 255.0 * error->Max), FormatCell("%.1f", error->Psnr),
    FormatCell("%.5f", error->Ssim), FormatCell("%.5f", error->Flip),
    FormatCell("%.3f %%", 100.0 * error->WrongPixels) };
}

TextRow ToCells(const MethodResult& result, double firstMedian)
{
  if (!result.Skipped.empty())
  {
    return { result.Method, "skipped: " + result.Skipped };
  }
  const MethodStatistics& statistics = result.Statistics;
  TextRow cells = { result.Method, FormatCell("%.1f", result.Median()),
    FormatCell("%.2f", result.Median() / firstMedian), Integer(statistics.Fragments),
    (statistics.LostIsLeast ? ">=" : "") + Integer(statistics.Lost), Integer(statistics.LayersMax),
    Integer(statistics.GeometryPasses), Bytes(statistics.Bytes) };
  const TextRow errors = ErrorCells(result.Error);
  cells.insert(cells.end(), errors.begin(), errors.end());
  cells.push_back(result.IsDeterministic ? "yes" : "no");
  return cells;
}

const TextRow& ComparisonHead()
{
  static const TextRow head = { "method", "ms", "ratio", "fragments", "lost", "layers", "passes",
    "memory", "max error/255", "psnr", "ssim", "flip", "wrong pixels", "deterministic" };
  return head;
}

/** The median of each stage's times, method by method; empty if stages were not measured. */
std::string StageTable(const ComparisonResult& comparison)
{
  if (!comparison.Settings.MeasuresStages)
  {
    return "";
  }
  std::vector<TextRow> rows = { { "stages, ms on the device" } };
  for (const MethodResult& result : comparison.Results)
  {
    TextRow cells = { result.Method };
    double sum = 0.0;
    for (const auto& [stage, milliseconds] : TimesOfStages(result))
    {
      const double median = Median(milliseconds);
      sum += median;
      cells.push_back(stage + FormatCell(" %.2f", median));
    }
    cells.push_back(FormatCell("sum %.2f", sum));
    rows.push_back(cells);
  }
  return "\n" + AlignColumns(rows);
}

/** What the method automatic chose, and what that cost. */
std::string AutomaticLine(const ComparisonResult& comparison)
{
  std::string line;
  for (const MethodResult& result : comparison.Results)
  {
    if (result.Statistics.Chosen)
    {
      line = result.Method + " chose " + *result.Statistics.Chosen;
    }
  }
  const std::optional<Regret> regret = RegretOf(comparison);
  if (!line.empty() && regret)
  {
    line += ", " + FormatCell("%.2f", regret->Ratio) + " times the time of " + regret->Fastest +
      ", the fastest within the budget";
  }
  return line.empty() ? "" : line + "\n";
}

double FirstMedian(const ComparisonResult& comparison)
{
  for (const MethodResult& result : comparison.Results)
  {
    if (result.Skipped.empty())
    {
      return result.Median();
    }
  }
  return 1.0;
}
}

std::string ToTable(const ComparisonResult& comparison)
{
  const double firstMedian = FirstMedian(comparison);
  std::vector<TextRow> rows = { ComparisonHead() };
  for (const MethodResult& result : comparison.Results)
  {
    rows.push_back(ToCells(result, firstMedian));
  }
  const PictureSize size = comparison.Settings.Size;
  return comparison.Scene + ", " + std::to_string(size.Width) + "x" + std::to_string(size.Height) +
    ", " + comparison.GL.Renderer + "\n" + AlignColumns(rows) + StageTable(comparison) +
    AutomaticLine(comparison) + (comparison.Advice.empty() ? "" : comparison.Advice + "\n");
}

std::string ToJson(const ComparisonResult& comparison)
{
  Json rows = Json::array();
  for (const MethodResult& result : comparison.Results)
  {
    rows.push_back(ToJsonRow(comparison, result));
  }
  return ToJsonDocument(comparison, rows);
}

}
