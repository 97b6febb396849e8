#include "scene/files/FileBytes.h"

#include "Errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace program
{

void CheckReadable(const std::string& path)
{
  if (path.empty())
  {
    throw InputError("the name of an input file", "is empty");
  }
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw InputError(path, "there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    throw InputError(path, "is a directory");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw InputError(path, "is not a regular file");
  }
  errno = 0;
  const std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw InputError(path, std::string("cannot be read: ") + std::strerror(errno));
  }
  if (std::filesystem::file_size(path, error) == 0)
  {
    throw InputError(path, "is empty");
  }
}

std::string ReadBytes(const std::string& path)
{
  CheckReadable(path);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file || !bytes)
  {
    throw InputError(path, "cannot be read to its end");
  }
  return bytes.str();
}

std::uint32_t ReadUInt32(const std::string& bytes, std::size_t offset)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  }
  return value;
}

}
