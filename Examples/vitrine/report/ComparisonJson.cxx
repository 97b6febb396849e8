#include "report/ComparisonJson.h"

namespace program
{

Json ToJson(const ComparisonSettings& settings)
{
  Json json = { { "opacity", settings.Opacity },
    { "view", { settings.From.Azimuth, settings.From.Elevation, settings.From.Zoom } },
    { "orbit", settings.Orbit }, { "multisamples", settings.Multisamples } };
  AddCoincidence(json, settings.Tolerance);
  return json;
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
  row["frame_ms"] = Spread(result.FrameMilliseconds, "frames");
  row["fragments"] = OrNull(result.Statistics.Fragments);
  row["lost"] = OrNull(result.Statistics.Lost);
  row["lost_is_least"] = result.Statistics.LostIsLeast;
  row["layers_max"] = OrNull(result.Statistics.LayersMax);
  row["layers_mean"] = OrNull(result.Statistics.LayersMean);
  row["geometry_passes"] = OrNull(result.Statistics.GeometryPasses);
  row["bytes"] = OrNull(result.Statistics.Bytes);
  row["error"] = result.Error ? ErrorJson(*result.Error) : Json(nullptr);
  row["deterministic"] = result.IsDeterministic;
  return row;
}

std::string ToJsonDocument(const ComparisonResult& comparison, const Json& rows)
{
  Json document = MeasurementHead(comparison.GL);
  document["settings"] = ToJson(comparison.Settings);
  document["results"] = rows;
  return JsonText(document);
}

}
