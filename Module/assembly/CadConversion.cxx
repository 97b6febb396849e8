#include "assembly/CadConversion.h"

#include "Core/assembly/gltf/GltfReader.h"
#include "assembly/CadCache.h"
#include "assembly/CadConverter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <system_error>

namespace vitrine
{

namespace
{
namespace fs = std::filesystem;

/** Counts changes of how converters are called, and of what is expected of their files. */
const int VersionOfCache = 1;

/** What tells that a file is still the same. */
struct FileStamp
{
  explicit FileStamp(const fs::path& file)
  {
    std::error_code problem;
    this->Time = fs::last_write_time(file, problem);
    this->Size = fs::file_size(file, problem);
  }

  bool operator==(const FileStamp& other) const
  {
    return this->Time == other.Time && this->Size == other.Size;
  }

  fs::file_time_type Time{};
  std::uintmax_t Size = 0;
};

/** A folder that is removed with all that is in it. */
class ScratchFolder
{
public:
  ScratchFolder()
  {
    std::error_code problem;
    std::string name = (fs::temp_directory_path(problem) / "vitrine-XXXXXX").string();
    if (problem || !mkdtemp(name.data()))
    {
      throw AssemblyError("cannot be converted: no folder can be made in that for temporary files");
    }
    this->Path = name;
  }
  ~ScratchFolder()
  {
    std::error_code problem;
    fs::remove_all(this->Path, problem);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  fs::path Path;
};

/** Removes a file, and what a converter may have left beside it, unless it got another name. */
class UnfinishedFile
{
public:
  explicit UnfinishedFile(fs::path path)
    : Path(std::move(path))
  {
  }
  ~UnfinishedFile()
  {
    std::error_code problem;
    const std::string name = this->Path.filename().string();
    for (const fs::directory_entry& file :
      fs::directory_iterator(this->Path.parent_path(), problem))
    {
      if (file.path().filename().string().rfind(name, 0) == 0)
      {
        fs::remove(file.path(), problem);
      }
    }
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  fs::path Path;
};

std::string KeyOf(const fs::path& file, const CadSettings& settings, const CadConverter& converter)
{
  std::ostringstream rest;
  rest.precision(17);
  rest << VersionOfCache << "\n"
       << converter.Name() << "\n"
       << converter.Version() << "\n"
       << settings.Tolerance << "\n"
       << file.extension().string() << "\n"
       << file.stem().string() << "\n"; // It may be the name of a part.
  return CadKey(file, rest.str());
}

Assembly Convert(const CadConverter& converter, const fs::path& file, const fs::path& output,
  int scene, const CadProgress& showProgress)
{
  converter.Convert(file, output, showProgress);
  try
  {
    return ReadGltf(output, scene);
  }
  catch (const AssemblyError& error)
  {
    throw AssemblyError(
      "cannot be converted: the GLB that " + converter.Name() + " wrote " + error.what());
  }
}

/** Returns an entry of the cache, or nothing if there is none that can be read. */
std::optional<Assembly> ReadEntry(const CadCache& cache, const std::string& key, int scene)
{
  std::error_code problem;
  if (!fs::exists(cache.EntryOf(key), problem))
  {
    return std::nullopt;
  }
  try
  {
    Assembly assembly = ReadGltf(cache.EntryOf(key), scene);
    cache.Touch(key);
    return assembly;
  }
  catch (const AssemblyError&)
  {
    if (scene != NO_INDEX)
    {
      throw; // There may be no such scene.
    }
    cache.Remove(key);
    return std::nullopt;
  }
}

Assembly ReadByCache(const CadCache& cache, const CadConverter& converter, const fs::path& file,
  int scene, const CadSettings& settings, const CadProgress& showProgress)
{
  const FileStamp stamp(file);
  const std::string key = KeyOf(file, settings, converter);
  if (std::optional<Assembly> kept = ReadEntry(cache, key, scene))
  {
    return std::move(*kept);
  }
  const UnfinishedFile unfinished(cache.UnfinishedOf(key));
  Assembly assembly = Convert(converter, file, unfinished.Path, scene, showProgress);
  if (stamp == FileStamp(file))
  {
    cache.Keep(unfinished.Path, key);
  }
  return assembly;
}
}

bool IsCadFile(const fs::path& file)
{
  static const std::array<const char*, 5> extensions = { ".step", ".stp", ".iges", ".igs",
    ".brep" };
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Assembly ReadCad(
  const fs::path& file, int scene, const CadSettings& settings, const CadProgress& showProgress)
{
  const CadConverter converter(settings);
  std::string problem;
  if (settings.UseCache)
  {
    const CadCache cache(settings.CacheFolder, settings.CacheLimit);
    if (cache.Problem().empty())
    {
      return ReadByCache(cache, converter, file, scene, settings, showProgress);
    }
    problem = cache.Problem();
  }
  const ScratchFolder scratch;
  Assembly assembly = Convert(converter, file, scratch.Path / "converted.glb", scene, showProgress);
  if (!problem.empty())
  {
    assembly.Notes.push_back("conversions are not kept: " + problem);
  }
  return assembly;
}

}
