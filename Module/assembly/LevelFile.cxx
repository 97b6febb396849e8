#include "assembly/LevelFile.h"

#include "vtkPolyData.h"

#include "vtksys/MD5.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

namespace vitrine
{

namespace
{

/** It changes with the file's form, and with how levels are made. */
constexpr std::uint32_t VersionOfLevels = 1;

/** Calls `append` with the bytes of numbers. */
template <class Append, class Number>
void AppendAll(const Append& append, const std::vector<Number>& numbers)
{
  const std::uint64_t count = numbers.size();
  append(&count, sizeof(count));
  append(numbers.data(), count * sizeof(Number));
}

/** @param levels  empty for a geometry that is not usable */
void Write(std::ofstream& file, const std::vector<MeshLevel>& levels)
{
  const auto append = [&](const void* bytes, std::size_t size)
  { file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size)); };
  const std::uint64_t count = levels.size();
  append(&count, sizeof(count));
  for (const MeshLevel& level : levels)
  {
    append(&level.Bound, sizeof(level.Bound));
    AppendAll(append, level.Corners);
  }
}

template <class Number>
bool Read(std::ifstream& file, Number& number)
{
  return static_cast<bool>(file.read(reinterpret_cast<char*>(&number), sizeof(number)));
}

/** Reads the levels of a mesh, or nothing if they cannot be those. */
std::optional<std::vector<MeshLevel>> ReadLevelsOf(const DetailedMesh& mesh, std::ifstream& file)
{
  std::uint64_t count = 0;
  if (!Read(file, count) || count > 64)
  {
    return std::nullopt;
  }
  std::vector<MeshLevel> levels(count);
  double least = 0;
  for (MeshLevel& level : levels)
  {
    std::uint64_t corners = 0;
    if (!Read(file, level.Bound) || !(level.Bound >= least) || !Read(file, corners) ||
      corners % 3 != 0 || corners > mesh.Corners.size())
    {
      return std::nullopt;
    }
    least = level.Bound;
    level.Corners.resize(corners);
    if (!file.read(reinterpret_cast<char*>(level.Corners.data()),
          static_cast<std::streamsize>(corners * sizeof(std::uint32_t))) ||
      std::any_of(level.Corners.begin(), level.Corners.end(),
        [&](std::uint32_t corner) { return corner >= mesh.Points.size(); }))
    {
      return std::nullopt;
    }
  }
  return levels;
}

std::optional<Details> ReadAll(
  std::ifstream& file, const DetailWork::Geometries& geometries, const std::atomic<bool>& isStopped)
{
  Details details;
  for (vtkPolyData* const geometry : geometries)
  {
    if (isStopped)
    {
      return details;
    }
    const DetailedMesh mesh = DetailedMeshOf(geometry);
    std::optional<std::vector<MeshLevel>> levels = ReadLevelsOf(mesh, file);
    if (!levels)
    {
      return std::nullopt;
    }
    details.push_back(MakePartDetail(mesh, std::move(*levels), isStopped));
  }
  return file.peek() == std::ifstream::traits_type::eof() ? std::optional<Details>(details)
                                                          : std::nullopt;
}

}

std::string KeyOfLevels(
  const DetailWork::Geometries& geometries, const std::atomic<bool>& isStopped)
{
  const std::unique_ptr<vtksysMD5, void (*)(vtksysMD5*)> sum(vtksysMD5_New(), vtksysMD5_Delete);
  vtksysMD5_Initialize(sum.get());
  const auto append = [&](const void* bytes, std::size_t size)
  {
    const auto* const first = static_cast<const unsigned char*>(bytes);
    constexpr std::size_t most = std::size_t{ 1 } << 30; // it counts by int
    for (std::size_t done = 0; done < size; done += most)
    {
      vtksysMD5_Append(sum.get(), first + done, static_cast<int>(std::min(most, size - done)));
    }
  };
  append(&VersionOfLevels, sizeof(VersionOfLevels));
  for (std::size_t i = 0; i < geometries.size() && !isStopped; ++i)
  {
    const DetailedMesh mesh = DetailedMeshOf(geometries[i]);
    AppendAll(append, mesh.Points);
    AppendAll(append, mesh.Corners);
    AppendAll(append, mesh.Normals);
    AppendAll(append, mesh.Colors);
  }
  std::array<char, 32> digits{};
  vtksysMD5_FinalizeHex(sum.get(), digits.data());
  return std::string(digits.data(), digits.size());
}

bool ReadLevels(const CadCache& cache, const std::string& key,
  const DetailWork::Geometries& geometries, const std::atomic<bool>& isStopped, Details& details)
{
  std::error_code problem;
  if (!std::filesystem::exists(cache.EntryOf(key), problem))
  {
    return false;
  }
  std::ifstream file(cache.EntryOf(key), std::ios::binary);
  std::optional<Details> read = ReadAll(file, geometries, isStopped);
  if (isStopped)
  {
    return false;
  }
  if (!read)
  {
    cache.Remove(key);
    return false;
  }
  cache.Touch(key);
  details = std::move(*read);
  return true;
}

void KeepLevels(const CadCache& cache, const std::string& key, const Details& details)
{
  const std::filesystem::path unfinished = cache.UnfinishedOf(key);
  std::ofstream file(unfinished, std::ios::binary);
  for (const std::shared_ptr<const PartDetail>& detail : details)
  {
    Write(file, detail ? detail->Levels : std::vector<MeshLevel>());
  }
  file.close();
  std::error_code problem;
  if (file)
  {
    cache.Keep(unfinished, key);
  }
  else
  {
    std::filesystem::remove(unfinished, problem);
  }
}

}
