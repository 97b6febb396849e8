#include "chart/ChartRecord.h"

#include "Errors.h"
#include "OutputFile.h"
#include "OutputPicture.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

namespace program
{

namespace
{
namespace fs = std::filesystem;

const char* const DocumentName = "chart.json";
const char* const PictureFolder = "pictures";
const std::array<const char*, 3> Head = { "vitrine", "device", "settings" };

/** Nothing if there is no file; throws if it is no chart. */
std::optional<Json> ReadDocument(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    return std::nullopt;
  }
  std::ifstream file(path);
  Json document = Json::parse(file, nullptr, /* allow_exceptions= */ false);
  if (!document.is_object() || !document.contains(Head[0]) || !document.contains("results"))
  {
    throw InputError(path, "is not the chart.json of a chart; move it, or name another folder");
  }
  return document;
}

bool HasStrings(const Json& row, const std::vector<std::string>& keys)
{
  return row.is_object() &&
    std::all_of(keys.begin(), keys.end(),
      [&row](const std::string& key) { return row.contains(key) && row[key].is_string(); });
}

bool HasNumber(const Json& row, const std::string& pointer)
{
  const Json::json_pointer place(pointer);
  return row.contains(place) && row.at(place).is_number();
}

bool IsResult(const Json& row)
{
  const bool ran = HasNumber(row, "/frame_ms/median");
  return HasStrings(row, { "part", "scene", "method" }) && HasNumber(row, "/step") &&
    HasNumber(row, "/width") && HasNumber(row, "/height") &&
    (ran || HasStrings(row, { "skipped" }));
}

bool IsCell(const Json& row)
{
  return HasStrings(row, { "scene", "method", "outcome", "verdict" });
}

bool HasNoOtherPictures(const Json& row)
{
  const auto isPath = [&row](const char* key)
  { return !row.contains(key) || row[key].is_string(); };
  return isPath("picture") && isPath("truth_picture");
}

/** What anyone can have edited. */
void CheckRows(const std::string& path, const Json& rows, bool (*isGood)(const Json& row))
{
  for (const Json& row : rows)
  {
    if (!isGood(row) || !HasNoOtherPictures(row))
    {
      throw InputError(path, "has rows that are damaged; remove it to measure afresh");
    }
  }
}

bool HasValues(const Json& row, const Json& values)
{
  return std::all_of(values.items().begin(), values.items().end(),
    [&row](const auto& item)
    { return row.contains(item.key()) && row[item.key()] == item.value(); });
}

/** The first of the head's keys whose values differ; null if none do. */
const char* FindDifference(const Json& head, const Json& document)
{
  for (const char* key : Head)
  {
    if (!document.contains(key) || document[key] != head[key])
    {
      return key;
    }
  }
  return nullptr;
}
}

ChartRecord::ChartRecord(const std::string& folder, const Json& head)
  : Folder(folder)
  , Contents(head)
{
  MakeFolder(folder);
  CheckWritable(this->PathOf(DocumentName));
  this->Contents["results"] = Json::array();
  ReadDocument(this->PathOf(DocumentName));
  MakeFolder(this->PathOf(PictureFolder));
}

std::string ChartRecord::GoOn()
{
  const std::optional<Json> before = ReadDocument(this->PathOf(DocumentName));
  if (!before)
  {
    return "";
  }
  if (const char* difference = FindDifference(this->Contents, *before))
  {
    return this->PathOf(DocumentName) + " was measured with another " +
      (difference == Head[0] ? "version" : difference) + "; starting afresh";
  }
  this->Contents = *before;
  CheckRows(this->PathOf(DocumentName), this->Rows("results"), IsResult);
  CheckRows(this->PathOf(DocumentName), this->Rows("failures"), IsCell);
  return this->PathOf(DocumentName) + " has " +
    std::to_string(this->Rows("results").size() + this->Rows("failures").size()) +
    " results already; going on from there";
}

bool ChartRecord::Has(const std::string& list, const Json& values) const
{
  const Json& rows = this->Rows(list);
  return std::any_of(
    rows.begin(), rows.end(), [&values](const Json& row) { return HasValues(row, values); });
}

const Json& ChartRecord::Rows(const std::string& list) const
{
  static const Json none = Json::array();
  return this->Contents.contains(list) ? this->Contents[list] : none;
}

void ChartRecord::Add(const std::string& list, const Json& rows)
{
  for (const Json& row : rows)
  {
    this->Contents[list].push_back(row);
  }
  this->Save();
}

void ChartRecord::Set(const std::string& key, const Json& value)
{
  this->Contents[key] = value;
  this->Save();
}

std::string ChartRecord::AddPicture(
  const std::string& name, const std::vector<std::uint8_t>& pixels, PictureSize size)
{
  const std::string file = std::string(PictureFolder) + "/" + name + ".png";
  WritePicture(this->PathOf(file), pixels, size);
  return file;
}

std::string ChartRecord::PathOf(const std::string& file) const
{
  return (fs::path(this->Folder) / file).string();
}

void ChartRecord::Save() const
{
  WriteWholeFile(this->PathOf(DocumentName), JsonText(this->Contents));
}

}
