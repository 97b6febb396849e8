#include "chart/ChartRecord.h"

#include "Errors.h"
#include "OutputFile.h"
#include "OutputPicture.h"
#include "chart/ChartRows.h"
#include "chart/FirstDifference.h"

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

/** What is alike in all of a chart, and in words where it is not. */
struct HeadKey
{
  const char* Name;
  const char* Difference;
};

const std::array<HeadKey, 4> Head = { { { "vitrine", "by another version" },
  { "build", "by another build" }, { "device", "on another device" },
  { "settings", "with other settings" } } };

/** Where a document has rows, they are a list. */
bool HasLists(const Json& document)
{
  return document.contains("results") && document["results"].is_array() &&
    (!document.contains("failures") || document["failures"].is_array());
}

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
  if (document.is_discarded())
  {
    throw InputError(path, "is damaged: it is no JSON; move it, or name another folder");
  }
  if (!document.is_object() || !document.contains(Head[0].Name) || !HasLists(document))
  {
    throw InputError(path, "is not the chart.json of a chart; move it, or name another folder");
  }
  return document;
}

void CheckRows(const std::string& path, const Json& rows, bool (*isGood)(const Json& row))
{
  if (!std::all_of(rows.begin(), rows.end(), isGood))
  {
    throw InputError(path, "has rows that are damaged; empty its folder to measure afresh");
  }
}

bool HasValues(const Json& row, const Json& values)
{
  return std::all_of(values.items().begin(), values.items().end(),
    [&row](const auto& item)
    { return row.contains(item.key()) && row[item.key()] == item.value(); });
}

/** Throws where a document was measured otherwise: what may have taken hours is not written over. */
void CheckHead(
  const std::string& path, const Json& document, const Json& head, const std::string& option)
{
  for (const HeadKey& key : Head)
  {
    const std::string difference =
      FirstDifference(key.Name, document.value(key.Name, Json(nullptr)), head[key.Name]);
    if (!difference.empty())
    {
      throw InputError(path,
        std::string("was measured ") + key.Difference + " (" + difference +
          "); name another folder by " + option + ", or empty this one to measure afresh");
    }
  }
}
}

ChartRecord::ChartRecord(
  const std::string& folder, const Json& head, const std::string& folderOption)
  : Folder(folder)
  , Contents(Json::parse(JsonText(head))) // as it is read again: names of files need not be UTF-8
{
  MakeFolder(folder);
  this->Lock = std::make_unique<FolderLock>(folder);
  for (const char* file : { DocumentName, PageFile, ErrorPlotFile, GrowthPlotFile })
  {
    CheckWritable(this->PathOf(file));
  }
  this->Contents["results"] = Json::array();
  const fs::path pictures = fs::path(this->PathOf(PicturePath("any"))).parent_path();
  if (const std::optional<Json> before = ReadDocument(this->PathOf(DocumentName)))
  {
    CheckHead(this->PathOf(DocumentName), *before, this->Contents, folderOption);
  }
  else
  {
    this->CheckThatNoneIsThere(
      { PageFile, ErrorPlotFile, GrowthPlotFile, pictures.filename().string() }, folderOption);
    this->Save(); // before any picture: pictures without it are somebody else's
  }
  MakeFolder(pictures.string());
  CheckWritable(this->PathOf(PicturePath("any")));
}

std::string ChartRecord::GoOn()
{
  const std::optional<Json> before = ReadDocument(this->PathOf(DocumentName));
  if (!before)
  {
    return "";
  }
  this->Contents = *before;
  CheckRows(this->PathOf(DocumentName), this->Rows("results"), IsChartResult);
  CheckRows(this->PathOf(DocumentName), this->Rows("failures"), IsChartCell);
  const std::size_t count = this->Rows("results").size() + this->Rows("failures").size();
  return count == 0 ? ""
                    : this->PathOf(DocumentName) + " has " + std::to_string(count) +
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

void ChartRecord::Remove(const std::string& list, const Json& values)
{
  if (!this->Has(list, values))
  {
    return;
  }
  Json kept = Json::array();
  for (const Json& row : this->Rows(list))
  {
    if (!HasValues(row, values))
    {
      kept.push_back(row);
    }
  }
  this->Set(list, kept);
}

void ChartRecord::Set(const std::string& key, const Json& value)
{
  this->Contents[key] = value;
  this->Save();
}

std::string ChartRecord::AddPicture(
  const std::string& name, const std::vector<std::uint8_t>& pixels, PictureSize size)
{
  const std::string file = PicturePath(name);
  WritePicture(this->PathOf(file), pixels, size);
  return file;
}

void ChartRecord::CheckThatNoneIsThere(
  const std::vector<std::string>& files, const std::string& folderOption) const
{
  for (const std::string& file : files)
  {
    std::error_code error;
    if (fs::exists(this->PathOf(file), error))
    {
      throw InputError(this->PathOf(file),
        "is of no chart, since no chart.json is beside it; name another folder by " + folderOption +
          ", or move it");
    }
  }
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
