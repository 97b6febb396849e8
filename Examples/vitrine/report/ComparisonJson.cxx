#include "report/ComparisonJson.h"

#include "Version.h"

#include <algorithm>

namespace program
{

namespace
{
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

Json SettingsJson(const ComparisonSettings& settings)
{
  return { { "opacity", settings.Opacity },
    { "view", { settings.From.Azimuth, settings.From.Elevation, settings.From.Zoom } },
    { "orbit", settings.Orbit }, { "multisamples", settings.Multisamples } };
}
}

Json ToJsonRow(const ComparisonResult& comparison, const MethodResult& result)
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

std::string ToJsonDocument(const ComparisonResult& comparison, const Json& rows)
{
  const Json document = { { "vitrine", Version },
    { "device",
      { { "vendor", comparison.GL.Vendor }, { "renderer", comparison.GL.Renderer },
        { "gl", comparison.GL.Version } } },
    { "settings", SettingsJson(comparison.Settings) }, { "results", rows } };
  return document.dump(2, ' ', /* ensure_ascii= */ false, Json::error_handler_t::replace) + "\n";
}

}
