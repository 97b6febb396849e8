#include "report/ComparisonReport.h"

#include "Version.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace program
{

namespace
{
using Json = nlohmann::ordered_json;

template <typename T>
Json OrNull(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json ToJson(const vitrine::ImageError& error)
{
  return { { "max", error.Max }, { "rmse", error.Rmse }, { "psnr", error.Psnr },
    { "ssim", error.Ssim }, { "flip", error.Flip }, { "wrong_pixels", error.WrongPixels } };
}

Json FrameTimes(const MethodResult& result)
{
  const auto [low, high] =
    std::minmax_element(result.FrameMilliseconds.begin(), result.FrameMilliseconds.end());
  return { { "min", *low }, { "median", result.Median() }, { "max", *high },
    { "frames", result.FrameMilliseconds.size() } };
}

Json ToRow(const ComparisonResult& comparison, const MethodResult& result)
{
  Json row = { { "scene", comparison.Scene }, { "method", result.Method },
    { "width", comparison.Settings.Size.Width }, { "height", comparison.Settings.Size.Height } };
  if (!result.Skipped.empty())
  {
    row["skipped"] = result.Skipped;
    return row;
  }
  row["frame_ms"] = FrameTimes(result);
  row["fragments"] = OrNull(result.Statistics.Fragments);
  row["lost"] = OrNull(result.Statistics.Lost);
  row["lost_is_least"] = result.Statistics.LostIsLeast;
  row["layers_max"] = OrNull(result.Statistics.LayersMax);
  row["layers_mean"] = OrNull(result.Statistics.LayersMean);
  row["geometry_passes"] = OrNull(result.Statistics.GeometryPasses);
  row["bytes"] = OrNull(result.Statistics.Bytes);
  row["error"] = result.Error ? ToJson(*result.Error) : Json(nullptr);
  row["deterministic"] = result.IsDeterministic;
  return row;
}

std::string Format(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

using Row = std::vector<std::string>;

std::string Bytes(const std::optional<std::int64_t>& bytes)
{
  return bytes ? Format("%.1f MiB", *bytes / 1048576.0) : "?";
}

std::string Integer(const std::optional<std::int64_t>& value)
{
  return value ? std::to_string(*value) : "?";
}

Row ErrorCells(const std::optional<vitrine::ImageError>& error)
{
  if (!error)
  {
    return { "?", "?", "?", "?", "?" };
  }
  return { Format("%.2f", 255.0 * error->Max), Format("%.1f", error->Psnr),
    Format("%.5f", error->Ssim), Format("%.5f", error->Flip),
    Format("%.3f %%", 100.0 * error->WrongPixels) };
}

Row ToCells(const MethodResult& result, double firstMedian)
{
  if (!result.Skipped.empty())
  {
    return { result.Method, "skipped: " + result.Skipped };
  }
  const MethodStatistics& statistics = result.Statistics;
  Row cells = { result.Method, Format("%.1f", result.Median()),
    Format("%.2f", result.Median() / firstMedian), Integer(statistics.Fragments),
    (statistics.LostIsLeast ? ">=" : "") + Integer(statistics.Lost), Integer(statistics.LayersMax),
    Integer(statistics.GeometryPasses), Bytes(statistics.Bytes) };
  const Row errors = ErrorCells(result.Error);
  cells.insert(cells.end(), errors.begin(), errors.end());
  cells.push_back(result.IsDeterministic ? "yes" : "no");
  return cells;
}

const Row& Head()
{
  static const Row head = { "method", "ms", "ratio", "fragments", "lost", "layers", "passes",
    "memory", "max error/255", "psnr", "ssim", "flip", "wrong pixels", "deterministic" };
  return head;
}

/** Columns right-aligned but for the first; what stands alone behind a method is left as it is. */
std::string Align(const std::vector<Row>& rows)
{
  std::vector<std::size_t> widths(Head().size(), 0);
  for (const Row& row : rows)
  {
    for (std::size_t i = 0; row.size() == widths.size() ? i < row.size() : i < 1; ++i)
    {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string lines;
  for (const Row& row : rows)
  {
    std::string line = row[0] + std::string(widths[0] - row[0].size(), ' ');
    for (std::size_t i = 1; i < row.size(); ++i)
    {
      const std::size_t padding = row.size() == widths.size() ? widths[i] - row[i].size() : 0;
      line += "  " + std::string(padding, ' ') + row[i];
    }
    lines += line + "\n";
  }
  return lines;
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

bool HasTranslucency(const ComparisonResult& comparison)
{
  return std::any_of(comparison.Results.begin(), comparison.Results.end(),
    [](const MethodResult& result) { return result.Statistics.Fragments.value_or(1) > 0; });
}

Json SettingsJson(const ComparisonSettings& settings)
{
  return { { "opacity", settings.Opacity },
    { "view", { settings.From.Azimuth, settings.From.Elevation, settings.From.Zoom } },
    { "orbit", settings.Orbit }, { "multisamples", settings.Multisamples } };
}
}

std::string ToTable(const ComparisonResult& comparison)
{
  const double firstMedian = FirstMedian(comparison);
  std::vector<Row> rows = { Head() };
  for (const MethodResult& result : comparison.Results)
  {
    rows.push_back(ToCells(result, firstMedian));
  }
  const PictureSize size = comparison.Settings.Size;
  return comparison.Scene + ", " + std::to_string(size.Width) + "x" + std::to_string(size.Height) +
    ", " + comparison.GL.Renderer + "\n" + Align(rows) +
    (HasTranslucency(comparison) ? ""
                                 : "Nothing in it is translucent; --opacity 0.3 makes it so.\n");
}

std::string ToJson(const ComparisonResult& comparison)
{
  Json rows = Json::array();
  for (const MethodResult& result : comparison.Results)
  {
    rows.push_back(ToRow(comparison, result));
  }
  const Json document = { { "vitrine", Version },
    { "device",
      { { "vendor", comparison.GL.Vendor }, { "renderer", comparison.GL.Renderer },
        { "gl", comparison.GL.Version } } },
    { "settings", SettingsJson(comparison.Settings) }, { "results", rows } };
  return document.dump(2, ' ', /* ensure_ascii= */ false, Json::error_handler_t::replace) + "\n";
}

}
