#include "assembly/CadCache.h"

#include "Core/assembly/Assembly.h"

#include "vtksys/MD5.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace vitrine
{

namespace
{
namespace fs = std::filesystem;

const std::uintmax_t LeastRoom = std::uintmax_t{ 64 } << 20; // bytes of the disk
const std::ptrdiff_t DigitsOfKey = 32;                       // of MD5
const std::chrono::hours MostHoursUnfinished(24);

fs::path DefaultFolder(const std::string& kind)
{
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache && fs::path(cache).is_absolute()) // others are ignored, as its specification says
  {
    return fs::path(cache) / "vitrine" / kind;
  }
  const char* const home = std::getenv("HOME");
  return home && *home ? fs::path(home) / ".cache/vitrine" / kind : fs::path();
}

/** A file of the cache. */
struct Kept
{
  fs::path Path;
  fs::file_time_type Time;
  std::uint64_t Size;
};

/** Whether a name begins as the cache's own do: with a key, and then a dot. Files of others may lie beside. */
bool IsOurs(const std::string& name)
{
  const auto isDigit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  return static_cast<std::ptrdiff_t>(name.size()) > DigitsOfKey && name[DigitsOfKey] == '.' &&
    std::all_of(name.begin(), name.begin() + DigitsOfKey, isDigit);
}

/** Lists the entries. Removes files that a process which ended early has left. */
std::vector<Kept> ListEntries(const fs::path& folder, const std::string& extension)
{
  std::vector<Kept> entries;
  std::error_code problem;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, problem))
  {
    if (!IsOurs(file.path().filename().string()) || !file.is_regular_file(problem))
    {
      continue;
    }
    const Kept kept{ file.path(), file.last_write_time(problem), file.file_size(problem) };
    if (problem)
    {
      continue; // another process has removed it
    }
    if (kept.Path.extension() == extension && kept.Path.stem().extension().empty())
    {
      entries.push_back(kept);
    }
    else if (fs::file_time_type::clock::now() - kept.Time > MostHoursUnfinished)
    {
      fs::remove(kept.Path, problem);
    }
  }
  return entries;
}
}

CadCache::CadCache(
  fs::path folder, std::uint64_t limit, const std::string& kind, std::string extension)
  : Folder(folder.empty() ? DefaultFolder(kind) : std::move(folder))
  , Limit(limit)
  , Extension(std::move(extension))
{
  if (this->Folder.empty())
  {
    this->WhyNot = "neither XDG_CACHE_HOME nor HOME is set";
    return;
  }
  std::error_code problem;
  if (fs::create_directories(this->Folder, problem))
  {
    fs::permissions(this->Folder, fs::perms::owner_all, problem); // models may be confidential
  }
  if (problem || access(this->Folder.c_str(), W_OK | X_OK) != 0)
  {
    this->WhyNot = "the folder " + this->Folder.string() + " cannot be written to";
  }
  else if (fs::space(this->Folder, problem).available < LeastRoom)
  {
    this->WhyNot = "the disk of the folder " + this->Folder.string() + " is full";
  }
}

fs::path CadCache::EntryOf(const std::string& key) const
{
  return this->Folder / (key + this->Extension);
}

fs::path CadCache::UnfinishedOf(const std::string& key) const
{
  static std::atomic<int> count{ 0 };
  return this->Folder /
    (key + "." + std::to_string(getpid()) + "-" + std::to_string(++count) + this->Extension);
}

void CadCache::Touch(const std::string& key) const
{
  std::error_code problem;
  fs::last_write_time(this->EntryOf(key), fs::file_time_type::clock::now(), problem);
}

bool CadCache::Keep(const fs::path& unfinished, const std::string& key) const
{
  std::error_code problem;
  const std::uint64_t size = fs::file_size(unfinished, problem);
  if (problem || size > this->Limit)
  {
    fs::remove(unfinished, problem);
    return false;
  }
  fs::rename(unfinished, this->EntryOf(key), problem);
  this->Trim();
  return !problem;
}

void CadCache::Remove(const std::string& key) const
{
  std::error_code problem;
  fs::remove(this->EntryOf(key), problem);
}

void CadCache::Trim() const
{
  std::vector<Kept> entries = ListEntries(this->Folder, this->Extension);
  std::sort(entries.begin(), entries.end(),
    [](const Kept& a, const Kept& b) { return a.Time > b.Time; }); // the last used first
  std::uint64_t sum = 0;
  for (const Kept& entry : entries)
  {
    sum += entry.Size;
    if (sum > this->Limit)
    {
      std::error_code problem;
      fs::remove(entry.Path, problem);
    }
  }
}

std::string CadKey(const fs::path& file, const std::string& rest)
{
  const std::unique_ptr<vtksysMD5, void (*)(vtksysMD5*)> sum(vtksysMD5_New(), vtksysMD5_Delete);
  vtksysMD5_Initialize(sum.get());
  const auto append = [&sum](const char* bytes, std::size_t size)
  {
    vtksysMD5_Append(
      sum.get(), reinterpret_cast<const unsigned char*>(bytes), static_cast<int>(size));
  };
  append(rest.c_str(), rest.size() + 1);
  std::ifstream in(file, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  while (in)
  {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    append(buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof())
  {
    throw AssemblyError("cannot be read");
  }
  std::array<char, 32> digits{};
  vtksysMD5_FinalizeHex(sum.get(), digits.data());
  return std::string(digits.data(), digits.size());
}

}
