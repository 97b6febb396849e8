#include "OutputFile.h"

#include "Errors.h"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace program
{

namespace
{
namespace fs = std::filesystem;

/** What `path` leads to: where a link ends, or what would be made. */
fs::path Resolve(const std::string& path)
{
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : resolved;
}

/** A device or a pipe can only be written to, not made anew. */
bool IsDeviceOrPipe(const fs::path& path)
{
  std::error_code error;
  return fs::exists(path, error) && !fs::is_regular_file(path, error);
}

/** Beside `path`, so that it can be renamed. */
fs::path TemporaryPath(const fs::path& path)
{
  return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(getpid()));
}

bool WriteBytes(const fs::path& path, std::string_view bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file.good();
}

bool ReplaceFile(const fs::path& path, std::string_view bytes)
{
  const fs::path temporary = TemporaryPath(path);
  std::error_code error;
  if (WriteBytes(temporary, bytes))
  {
    fs::rename(temporary, path, error);
    if (!error)
    {
      return true;
    }
  }
  fs::remove(temporary, error);
  return false;
}
}

void CheckWritable(const std::string& path)
{
  if (path.empty())
  {
    throw InputError("the name of a file to write", "is empty");
  }
  std::error_code error;
  const fs::path target = Resolve(path);
  if (fs::is_directory(target, error))
  {
    throw InputError(path, "is a directory");
  }
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0)
  {
    throw InputError(path, "may not be written to");
  }
  if (IsDeviceOrPipe(target))
  {
    return;
  }
  fs::path folder = target.parent_path();
  folder = folder.empty() ? "." : folder;
  if (!fs::is_directory(folder, error))
  {
    throw InputError(path, "there is no folder " + folder.string());
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw InputError(path, "its folder may not be written to");
  }
}

bool AreSame(const std::string& path, const std::string& other)
{
  return Resolve(path) == Resolve(other);
}

void MakeFolder(const std::string& path)
{
  std::error_code error;
  if (path.empty())
  {
    throw InputError("the name of a folder to write", "is empty");
  }
  if (fs::exists(path, error) && !fs::is_directory(path, error))
  {
    throw InputError(path, "is not a folder");
  }
  fs::create_directory(path, error);
  if (error)
  {
    throw InputError(path, "cannot be made: " + error.message());
  }
}

bool CanBeReplaced(const std::string& path)
{
  return !IsDeviceOrPipe(Resolve(path));
}

void WriteWholeFile(const std::string& path, std::string_view bytes)
{
  CheckWritable(path);
  const fs::path target = Resolve(path);
  if (!(IsDeviceOrPipe(target) ? WriteBytes(target, bytes) : ReplaceFile(target, bytes)))
  {
    throw InputError(path, "cannot be written");
  }
}

}
