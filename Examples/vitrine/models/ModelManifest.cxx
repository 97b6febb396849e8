#include "models/ModelManifest.h"

#include "Errors.h"
#include "Join.h"
#include "models/ModelManifestText.h"
#include "report/TextTable.h"
#include "scene/files/FileBytes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace program
{

namespace
{
using ManifestJson = nlohmann::ordered_json;

const int ManifestFormat = 1;
const std::uint64_t MostBytes = std::uint64_t(1) << 30; // a model is checked in memory
const char* const All = "all";

bool HasOnly(const std::string& text, const char* characters)
{
  return !text.empty() && text.find_first_not_of(characters) == std::string::npos;
}

bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/** A name that stays in the folder that it is written to, and is neither hidden nor an option. */
bool IsFileName(const std::string& name)
{
  return HasOnly(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") &&
    name.front() != '.' && name.front() != '-' && name != All;
}

bool IsAddress(const std::string& address)
{
  return (BeginsWith(address, "https://") || BeginsWith(address, "http://")) &&
    std::all_of(address.begin(), address.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

/** A text that is shown as it is: no line ends in it, and no escape of a terminal begins. */
bool IsLine(const std::string& text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= ' ' && c != 0x7f; });
}

bool IsSha256(const std::string& hash)
{
  return hash.size() == 64 && HasOnly(hash, "0123456789abcdef");
}

/** The text of a key, or an empty one. */
std::string TextOf(const ManifestJson& entry, const char* key)
{
  const auto found = entry.find(key);
  return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::uint64_t BytesOf(const ManifestJson& entry)
{
  const auto found = entry.find("bytes");
  return found != entry.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

Model ToModel(const ManifestJson& entry)
{
  Model model;
  model.Name = TextOf(entry, "name");
  model.Address = TextOf(entry, "address");
  model.Reason = TextOf(entry, "reason");
  model.Sha256 = TextOf(entry, "sha256");
  model.Bytes = BytesOf(entry);
  model.Licence = TextOf(entry, "licence");
  model.Author = TextOf(entry, "author");
  model.Source = TextOf(entry, "source");
  model.Conversion = TextOf(entry, "conversion");
  return model;
}

/** What is wrong with a model, or nothing. */
std::string ProblemOf(const Model& model)
{
  if (!IsFileName(model.Name))
  {
    return "its \"name\" is no plain name of a file";
  }
  if (model.Address.empty() == model.Reason.empty())
  {
    return "it needs either an \"address\" or a \"reason\"";
  }
  if (CanBeFetched(model) && !IsAddress(model.Address))
  {
    return "its \"address\" does not begin with https:// or http://, or has characters that no "
           "address has";
  }
  if (!IsSha256(model.Sha256))
  {
    return "its \"sha256\" is not of 64 hexadecimal digits in lower case";
  }
  if (model.Bytes == 0 || model.Bytes > MostBytes)
  {
    return "its \"bytes\" are no integer from 1 to " + std::to_string(MostBytes);
  }
  const std::string& obtained = CanBeFetched(model) ? model.Address : model.Reason;
  const std::pair<const char*, const std::string*> lines[] = { { "reason", &obtained },
    { "licence", &model.Licence }, { "author", &model.Author }, { "source", &model.Source },
    { "conversion", &model.Conversion } };
  for (const auto& [key, line] : lines)
  {
    if (!IsLine(*line))
    {
      return "its \"" + std::string(key) + "\" is no text of one line";
    }
  }
  return "";
}

ManifestJson ParseManifest(const std::string& path, const std::string& text)
{
  const ManifestJson document = ManifestJson::parse(text, nullptr, false);
  if (document.is_discarded())
  {
    throw InputError(path, "is no manifest of models: it is no JSON");
  }
  const bool isKnown = document.is_object() && document.contains("format") &&
    document["format"] == ManifestFormat && document.contains("models") &&
    document["models"].is_array();
  if (!isKnown)
  {
    throw InputError(
      path, "is no manifest of models: it has no \"format\" 1 with a list of \"models\"");
  }
  return document;
}

std::vector<Model> ModelsOf(const std::string& path, const ManifestJson& document)
{
  std::vector<Model> models;
  std::set<std::string> names;
  for (const ManifestJson& entry : document["models"])
  {
    const Model model = ToModel(entry);
    std::string problem = ProblemOf(model);
    if (problem.empty() && !names.insert(model.Name).second)
    {
      problem = "its \"name\" is that of a model before it";
    }
    if (!problem.empty())
    {
      const std::string number = std::to_string(models.size() + 1);
      throw InputError(
        path, "is no manifest of models: of model number " + number + ", " + problem);
    }
    models.push_back(model);
  }
  return models;
}

void CheckNames(const ModelManifest& manifest, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    const bool isKnown = std::any_of(manifest.Models.begin(), manifest.Models.end(),
      [&](const Model& model) { return model.Name == name; });
    if (name != All && !isKnown)
    {
      throw InputError(name, "there is no such model; `vitrine models` lists them");
    }
  }
}

/** The names of models by the reason for which they have no address. */
std::map<std::string, std::vector<std::string>> NamesByReason(const ModelManifest& manifest)
{
  std::map<std::string, std::vector<std::string>> names;
  for (const Model& model : manifest.Models)
  {
    if (!CanBeFetched(model))
    {
      names[model.Reason].push_back(model.Name);
    }
  }
  return names;
}
}

bool CanBeFetched(const Model& model)
{
  return !model.Address.empty();
}

ModelManifest ReadModelManifest(const std::optional<std::string>& path)
{
  ModelManifest manifest;
  manifest.Text = path ? ReadBytes(*path) : model_manifest::manifest;
  const std::string name = path.value_or("the program's manifest");
  manifest.Models = ModelsOf(name, ParseManifest(name, manifest.Text));
  return manifest;
}

std::vector<Model> ChooseModels(
  const ModelManifest& manifest, const std::vector<std::string>& names)
{
  CheckNames(manifest, names);
  const auto isNamed = [&](const std::string& name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  std::vector<Model> chosen;
  for (const Model& model : manifest.Models)
  {
    if (isNamed(model.Name) || (isNamed(All) && CanBeFetched(model)))
    {
      chosen.push_back(model);
    }
  }
  return chosen;
}

std::string ToText(const ModelManifest& manifest)
{
  std::vector<TextRow> rows = { { "model", "bytes", "can be fetched", "licence" } };
  for (const Model& model : manifest.Models)
  {
    rows.push_back({ model.Name, std::to_string(model.Bytes), CanBeFetched(model) ? "yes" : "no",
      model.Licence });
  }
  std::string text = AlignColumns(rows);
  for (const auto& [reason, names] : NamesByReason(manifest))
  {
    text += "\nCannot be fetched: " + Join(names) + "\n  " + reason + "\n";
  }
  return text;
}

}
