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
/**
 * Beside `path`, so that it can be renamed, with its extension, by which writers know the format.
 */
std::filesystem::path TemporaryPath(const std::filesystem::path& path)
{
  const std::string name =
    "." + path.stem().string() + "." + std::to_string(getpid()) + path.extension().string();
  return path.parent_path() / name;
}
}

void CheckWritable(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
  {
    throw InputError(path, "is a directory");
  }
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  folder = folder.empty() ? "." : folder;
  if (!std::filesystem::is_directory(folder, error))
  {
    throw InputError(path, "there is no folder " + folder.string());
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw InputError(path, "its folder may not be written to");
  }
}

void WriteWholeFile(
  const std::string& path, const std::function<bool(const std::string& temporary)>& write)
{
  CheckWritable(path);
  const std::filesystem::path temporary = TemporaryPath(path);
  const bool isWritten = write(temporary.string());
  std::error_code error;
  if (isWritten)
  {
    std::filesystem::rename(temporary, path, error);
  }
  if (!isWritten || error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw InputError(path, "cannot be written");
  }
}

void WriteTextFile(const std::string& path, const std::string& text)
{
  WriteWholeFile(path,
    [&text](const std::string& temporary)
    {
      std::ofstream file(temporary, std::ios::binary);
      file << text;
      file.close();
      return file.good();
    });
}

}
