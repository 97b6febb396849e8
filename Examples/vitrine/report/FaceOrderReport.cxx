#include "report/FaceOrderReport.h"

#include "Median.h"
#include "report/TextTable.h"

namespace program
{

namespace
{

TextRow ToCells(const FaceOrderRun& run, const FaceOrderResult& result)
{
  TextRow cells = { run.Faces, run.Sequence, result.Statements };
  if (!result.Skipped.empty())
  {
    cells.push_back("skipped: " + result.Skipped);
    return cells;
  }
  const double time = Median(result.Milliseconds);
  cells.insert(cells.end(),
    { std::to_string(result.Comparisons), FormatCell("%.0f %%", 100.0 * SavedShare(run, result)),
      std::to_string(result.Lookups), std::to_string(result.EndChecks), FormatCell("%.1f", time),
      FormatCell("%.2f", time / Median(run.Results.front().Milliseconds)) });
  return cells;
}

Json ToJsonRow(const PictureSize& size, const FaceOrderRun& run, const FaceOrderResult& result)
{
  Json row = { { "faces", run.Faces }, { "sequence", run.Sequence }, { "count", run.Count },
    { "width", size.Width }, { "height", size.Height }, { "statements", result.Statements } };
  if (!result.Skipped.empty())
  {
    row["skipped"] = result.Skipped;
    return row;
  }
  row["comparisons"] = result.Comparisons;
  row["saved"] = SavedShare(run, result);
  row["lookups"] = result.Lookups;
  row["end_checks"] = result.EndChecks;
  row["insert_ms"] = Spread(result.Milliseconds, "rounds");
  return row;
}
}

std::string ToText(const FaceOrderComparison& comparison)
{
  std::vector<TextRow> rows = { { "faces", "sequence", "statements", "comparisons", "saved",
    "look-ups", "end checks", "ms", "compared = 1" } };
  for (const FaceOrderRun& run : comparison.Runs)
  {
    for (const FaceOrderResult& result : run.Results)
    {
      rows.push_back(ToCells(run, result));
    }
  }
  return "Order of faces: comparisons of depths that the statements save in an s-buffer of " +
    std::to_string(comparison.Size.Width) + "x" + std::to_string(comparison.Size.Height) + "\n" +
    AlignColumns(rows);
}

Json ToJsonRows(const FaceOrderComparison& comparison)
{
  Json rows = Json::array();
  for (const FaceOrderRun& run : comparison.Runs)
  {
    for (const FaceOrderResult& result : run.Results)
    {
      rows.push_back(ToJsonRow(comparison.Size, run, result));
    }
  }
  return rows;
}

}
