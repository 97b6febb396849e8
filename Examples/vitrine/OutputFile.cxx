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
/** Beside `path`, so that it can be renamed, with its extension, by which writers know the format. */
std::filesystem::path TemporaryPath(const std::filesystem::path& path)
{
  const std::string name =
    "." + path.stem().string() + "." + std::to_string(getpid()) + path.extension().string();
  return path.parent_path() / name;
}
}

void WriteWholeFile(
  const std::string& path, const std::function<bool(const std::string& temporary)>& write)
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
  {
    throw InputError(path, "is a directory");
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    throw InputError(path, "there is no folder " + folder.string());
  }
  const std::filesystem::path temporary = TemporaryPath(path);
  const bool isWritten = write(temporary.string());
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
