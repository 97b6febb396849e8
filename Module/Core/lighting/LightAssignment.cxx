#include "Core/lighting/LightAssignment.h"

#include "Core/lighting/LightScatter.h"

#include <algorithm>
#include <future>
#include <limits>
#include <stdexcept>

namespace vitrine
{

namespace
{

/** Fewer lights are not worth a thread. */
constexpr std::size_t LightsPerThread = 2048;

/** Lights that one thread looks at, one after the other. */
class LightChunk
{
public:
  /** Finds their clusters, and how many of them are in each. */
  void Scatter(const LightScatter& scatter, const std::vector<LightVolume>& volumes,
    std::size_t first, std::size_t last, std::uint32_t clusters)
  {
    for (std::size_t light = first; light < last; ++light)
    {
      scatter.Append(static_cast<std::uint32_t>(light), volumes[light], this->Runs);
    }
    this->Places.assign(clusters + std::size_t{ 1 }, 0);
    for (const ClusterRun& run : this->Runs)
    {
      ++this->Places[run.First];
      --this->Places[run.First + run.Count]; // wraps, and is undone by the sum
    }
    std::uint32_t count = 0;
    for (std::uint32_t& place : this->Places)
    {
      place = count += place;
    }
  }

  std::uint32_t CountIn(std::uint32_t cluster) const { return this->Places[cluster]; }

  /** Where its part of a cluster's list begins. */
  void BeginAt(std::uint32_t cluster, std::uint32_t place) { this->Places[cluster] = place; }

  void Fill(const std::vector<std::uint8_t>* used, std::vector<std::uint32_t>& indices)
  {
    for (const ClusterRun& run : this->Runs)
    {
      for (std::uint32_t cluster = run.First; cluster < run.First + run.Count; ++cluster)
      {
        if (used == nullptr || (*used)[cluster] != 0)
        {
          indices[this->Places[cluster]++] = run.Light;
        }
      }
    }
  }

private:
  ClusterRuns Runs;
  std::vector<std::uint32_t>
    Places; ///< of each cluster: how many lights, then where the next one is put
};

/** Does something for each chunk, each in a thread of its own. */
template <class Work>
void ForEachChunk(std::vector<LightChunk>& chunks, const Work& work)
{
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < chunks.size(); ++i)
  {
    others.push_back(std::async(std::launch::async, [&work, &chunks, i] { work(chunks[i], i); }));
  }
  work(chunks[0], 0);
  for (std::future<void>& other : others)
  {
    other.get();
  }
}

/** Gives each cluster its part of the list, and each chunk its part of that. */
void PlaceLists(std::uint32_t clusters, const std::vector<std::uint8_t>* used,
  std::vector<LightChunk>& chunks, LightLists& lists)
{
  lists.Offsets.resize(clusters + std::size_t{ 1 });
  std::uint64_t sum = 0;
  for (std::uint32_t cluster = 0; cluster < clusters; ++cluster)
  {
    lists.Offsets[cluster] = static_cast<std::uint32_t>(sum);
    if (used == nullptr || (*used)[cluster] != 0)
    {
      for (LightChunk& chunk : chunks)
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
}

void Assign(const ClusterGrid& grid, const std::vector<LightVolume>& volumes, LightLists& lists,
  const std::vector<std::uint8_t>* used, const AssignmentSettings& settings)
{
  const LightScatter scatter(grid);
  const std::size_t most = std::max<std::size_t>(1, volumes.size() / LightsPerThread);
  std::vector<LightChunk> chunks(std::min<std::size_t>(most, std::max(1u, settings.Threads)));
  const auto beginOf = [&](std::size_t chunk) { return volumes.size() * chunk / chunks.size(); };
  ForEachChunk(chunks,
    [&](LightChunk& chunk, std::size_t i)
    { chunk.Scatter(scatter, volumes, beginOf(i), beginOf(i + 1), grid.Count()); });
  PlaceLists(grid.Count(), used, chunks, lists);
  ForEachChunk(chunks, [&](LightChunk& chunk, std::size_t) { chunk.Fill(used, lists.Indices); });
}

}
