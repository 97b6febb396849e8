#include "report/ComparisonJson.h"

namespace program
{

Json ToJson(const ComparisonSettings& settings)
{
  Json json = { { "opacity", settings.Opacity },
    { "view", { settings.From.Azimuth, settings.From.Elevation, settings.From.Zoom } },
    { "orbit", settings.Orbit }, { "multisamples", settings.Multisamples } };
  AddCoincidence(json, settings.Tolerance);
  if (settings.ErrorBudget)
  {
    json["error_budget"] = *settings.ErrorBudget;
  }
  return json;
}

namespace
{
/** The spread of each stage's times over frames. */
Json StagesJson(const MethodResult& result)
{
  Json stages = Json::object();
  for (const auto& [stage, milliseconds] : TimesOfStages(result))
  {
    stages[stage] = Spread(milliseconds, "frames");
  }
  return stages;
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
  row["first_frame_ms"] = OrNull(result.FirstFrameMilliseconds);
  if (result.FrameMilliseconds.empty())
  {
    return row;
  }
  row["frame_ms"] = Spread(result.FrameMilliseconds, "frames");
  if (comparison.Settings.MeasuresStages)
  {
    row["stages_ms"] = StagesJson(result);
  }
  row["fragments"] = OrNull(result.Statistics.Fragments);
  row["lost"] = OrNull(result.Statistics.Lost);
  row["lost_is_least"] = result.Statistics.LostIsLeast;
  row["layers_max"] = OrNull(result.Statistics.LayersMax);
  row["layers_mean"] = OrNull(result.Statistics.LayersMean);
  row["geometry_passes"] = OrNull(result.Statistics.GeometryPasses);
  row["bytes"] = OrNull(result.Statistics.Bytes);
  if (result.Statistics.Chosen)
  {
    row["chosen"] = *result.Statistics.Chosen;
    row["guaranteed_error"] = OrNull(result.Statistics.GuaranteedError);
    const std::optional<Regret> regret = RegretOf(comparison);
    row["regret"] = regret ? Json(regret->Ratio) : Json(nullptr);
  }
  row["error"] = result.Error ? ErrorJson(*result.Error) : Json(nullptr);
  row["deterministic"] = result.IsDeterministic;
  return row;
}

std::string ToJsonDocument(const ComparisonResult& comparison, const Json& rows)
{
  Json document = MeasurementHead(comparison.GL);
  document["settings"] = ToJson(comparison.Settings);
  if (!comparison.Unfinished.empty())
  {
    document["unfinished"] = comparison.Unfinished;
  }
  document["results"] = rows;
  return JsonText(document);
}

}
