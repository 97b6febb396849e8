#include "Core/lighting/LightAssignment.h"

#include "Core/lighting/LightScatter.h"
#include "Core/threads/ForEachInThreads.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>

namespace vitrine
{

namespace
{

/** The minimum number of lights that is worth a thread. */
constexpr std::size_t LightsPerThread = 2048;
}

/** Gives each cluster its part of the indices by a prefix sum, and each chunk its part of each list. */
void LightAssigner::PlaceLists(
  std::uint32_t clusters, const std::vector<std::uint8_t>* used, LightLists& lists)
{
  lists.Offsets.resize(clusters + std::size_t{ 1 });
  std::uint64_t sum = 0;
  for (std::uint32_t cluster = 0; cluster < clusters; ++cluster)
  {
    lists.Offsets[cluster] = static_cast<std::uint32_t>(sum);
    if (used == nullptr || (*used)[cluster] != 0)
    {
      for (LightChunk& chunk : this->Chunks)
      {
        const std::uint32_t count = chunk.CountIn(cluster);
        chunk.BeginAt(cluster, static_cast<std::uint32_t>(sum));
        sum += count;
      }
    }
    if (sum > std::numeric_limits<std::uint32_t>::max())
    {
      throw std::length_error("the lists of lights hold 2^32 numbers or more");
    }
  }
  lists.Offsets[clusters] = static_cast<std::uint32_t>(sum);
  lists.Indices.resize(sum);
}

template <class Scatter>
void LightAssigner::AssignBy(const Scatter& scatter, const std::vector<LightVolume>& volumes,
  LightLists& lists, const std::vector<std::uint8_t>* used)
{
  assert(used == nullptr || used->size() == scatter.Count());
  assert(volumes.size() <= std::numeric_limits<std::uint32_t>::max());
  const std::size_t most = std::max<std::size_t>(1, volumes.size() / LightsPerThread);
  const std::size_t count = std::min<std::size_t>(most, std::max(1u, this->Settings.Threads));
  const std::size_t blocks = (volumes.size() + LightFilter::BlockSize - 1) / LightFilter::BlockSize;
  const auto beginOf = [&](std::size_t chunk)
  { return std::min(volumes.size(), blocks * chunk / count * LightFilter::BlockSize); };
  this->Chunks.resize(count);
  ForEachInThreads(count,
    [&](std::size_t i)
    {
      LightChunk& chunk = this->Chunks[i];
      scatter.Append(volumes, beginOf(i), beginOf(i + 1), chunk.Begin());
      chunk.Count(scatter.Count());
    });
  this->PlaceLists(scatter.Count(), used, lists);
  ForEachInThreads(count, [&](std::size_t i) { this->Chunks[i].Fill(used, lists.Indices); });
}

void LightAssigner::Assign(const ClusterGrid& grid, const std::vector<LightVolume>& volumes,
  LightLists& lists, const std::vector<std::uint8_t>* used, const LightMarks* marked)
{
  if (this->Settings.Test == LightTest::Box)
  {
    this->AssignBy(BoxScatter(grid, LightTest::Box), volumes, lists, used);
  }
  else
  {
    this->AssignBy(LightScatter(grid, marked), volumes, lists, used);
  }
}

void LightAssigner::Assign(const WorldGrid& grid, const std::vector<LightVolume>& volumes,
  LightLists& lists, const std::vector<std::uint8_t>* used)
{
  this->AssignBy(BoxScatter(grid, this->Settings.Test), volumes, lists, used);
}

}
