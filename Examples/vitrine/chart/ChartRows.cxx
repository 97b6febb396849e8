#include "chart/ChartRows.h"

#include "stability/Verdict.h"

#include <algorithm>

namespace program
{

namespace
{
const std::string PictureFolder = "pictures/";
const std::string PictureEnding = ".png";
const int MostSteps = 10000;

bool HasStrings(const Json& row, const std::vector<std::string>& keys)
{
  return std::all_of(keys.begin(), keys.end(),
    [&row](const std::string& key) { return row.contains(key) && row[key].is_string(); });
}

bool HasNumber(const Json& row, const char* key)
{
  return row.contains(key) && row[key].is_number();
}

/** What a method need not tell. */
bool HasNumbersOrNothing(const Json& row, const std::vector<std::string>& keys)
{
  return std::all_of(keys.begin(), keys.end(),
    [&row](const std::string& key)
    { return !row.contains(key) || row[key].is_null() || row[key].is_number(); });
}

bool HasStep(const Json& row)
{
  if (!row.contains("step") || !row["step"].is_number_integer())
  {
    return false;
  }
  const auto step = row["step"].get<std::int64_t>();
  return step >= 0 && step < MostSteps;
}

bool HasError(const Json& row)
{
  const Json error = row.value("error", Json(nullptr));
  return error.is_null() ||
    (error.is_object() &&
      std::all_of(error.begin(), error.end(), [](const Json& value) { return value.is_number(); }));
}

bool IsMeasured(const Json& row)
{
  return row.contains("frame_ms") && row["frame_ms"].is_object() &&
    HasNumber(row["frame_ms"], "median") && HasError(row) &&
    HasNumbersOrNothing(row,
      { "fragments", "lost", "layers_max", "layers_mean", "geometry_passes", "bytes",
        "guaranteed_error", "regret" });
}

/** A file of the picture folder and of none below or beside it: a page that is passed on holds nothing else. */
bool IsPicturePath(const Json& value)
{
  const std::string path = value.is_string() ? value.get<std::string>() : "";
  if (path.size() <= PictureFolder.size() + PictureEnding.size() ||
    path.compare(0, PictureFolder.size(), PictureFolder) != 0 ||
    path.compare(path.size() - PictureEnding.size(), PictureEnding.size(), PictureEnding) != 0)
  {
    return false;
  }
  const std::string name = path.substr(PictureFolder.size());
  return name.find_first_of(std::string("/\\\0", 3)) == std::string::npos &&
    name.find("..") == std::string::npos;
}

bool HasNoOtherPictures(const Json& row)
{
  const auto isOwn = [&row](const char* key)
  { return !row.contains(key) || IsPicturePath(row[key]); };
  return isOwn("picture") && isOwn("truth_picture");
}

bool IsOutcome(const Json& value)
{
  const auto all = { StabilityOutcome::Refused, StabilityOutcome::OrderDependent,
    StabilityOutcome::Flickers, StabilityOutcome::Wrong, StabilityOutcome::Exact };
  return std::any_of(
    all.begin(), all.end(), [&value](StabilityOutcome outcome) { return value == Name(outcome); });
}

bool HasMessages(const Json& row)
{
  const Json messages = row.value("messages", Json::array());
  return messages.is_array() &&
    std::all_of(
      messages.begin(), messages.end(), [](const Json& message) { return message.is_string(); });
}

/** Either why nothing was measured, or what was. */
bool IsSkippedOr(bool (*isMeasured)(const Json& row), const Json& row)
{
  return row.contains("skipped") ? row["skipped"].is_string() : isMeasured(row);
}

bool IsJudged(const Json& row)
{
  return HasNumber(row, "worst_error") && HasStrings(row, { "worst_frames" }) &&
    row.contains("error") && row["error"].is_object() && HasNumber(row["error"], "max") &&
    row.contains("picture") && row.contains("truth_picture") && HasMessages(row);
}
}

std::string PicturePath(const std::string& name)
{
  return PictureFolder + name + PictureEnding;
}

bool IsChartResult(const Json& row)
{
  return row.is_object() && HasStrings(row, { "part", "scene", "method" }) && HasStep(row) &&
    HasNumber(row, "width") && HasNumber(row, "height") && HasNoOtherPictures(row) &&
    IsSkippedOr(IsMeasured, row);
}

bool IsChartCell(const Json& row)
{
  return row.is_object() && HasStrings(row, { "scene", "method", "outcome", "verdict" }) &&
    IsOutcome(row["outcome"]) && HasNumber(row, "width") && HasNumber(row, "height") &&
    HasNoOtherPictures(row) && IsSkippedOr(IsJudged, row);
}

}
