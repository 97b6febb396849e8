#include "models/ModelFetch.h"

#include "Errors.h"
#include "OutputFile.h"
#include "Progress.h"
#include "models/Download.h"
#include "models/Sha256.h"
#include "scene/files/FileBytes.h"

#include <filesystem>
#include <system_error>

namespace program
{

namespace
{
namespace fs = std::filesystem;

std::string PathOf(const Model& model, const std::string& folder)
{
  return (fs::path(folder) / model.Name).string();
}

/** Throw InputError if another file has the model's name. */
bool IsThere(const Model& model, const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return false;
  }
  const bool isSame =
    fs::file_size(path, error) == model.Bytes && Sha256Of(ReadBytes(path)) == model.Sha256;
  if (!isSame)
  {
    throw InputError(
      path, "is another file than the manifest's; move it away, or name another folder");
  }
  return true;
}

/** Throw InputError unless the model can be fetched and written. */
void CheckFetch(const Model& model, const std::string& path)
{
  if (!CanBeFetched(model))
  {
    throw InputError(model.Name, "this model cannot be fetched: " + model.Reason);
  }
  CheckWritable(path);
}

std::string FetchBytes(const Model& model, Progress& progress)
{
  const auto show = [&](std::size_t count)
  {
    progress.Show(
      "fetching " + model.Name + ": " + std::to_string(100 * count / model.Bytes) + " %");
  };
  std::string bytes = Download(model.Address, model.Bytes, show);
  progress.Hide();
  const std::string hash = Sha256Of(bytes);
  if (hash != model.Sha256)
  {
    throw InputError(model.Address,
      "is another file than the manifest's: its sha256 is " + hash + ", not " + model.Sha256);
  }
  return bytes;
}
}

void FetchModels(const std::vector<Model>& models, const std::string& folder, Progress& progress,
  const std::function<void(const Model&, FetchOutcome)>& tell)
{
  MakeFolder(folder);
  std::vector<Model> missing;
  for (const Model& model : models)
  {
    const std::string path = PathOf(model, folder);
    if (IsThere(model, path))
    {
      tell(model, FetchOutcome::WasThere);
    }
    else
    {
      CheckFetch(model, path);
      missing.push_back(model);
    }
  }
  for (const Model& model : missing)
  {
    WriteWholeFile(PathOf(model, folder), FetchBytes(model, progress));
    tell(model, FetchOutcome::Fetched);
  }
}

}
