#ifndef VITRINE_CORE_LIGHTING_LIGHT_CHUNK_H
#define VITRINE_CORE_LIGHTING_LIGHT_CHUNK_H

#include "Core/lighting/ClusterRuns.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** The clusters that one thread finds for consecutive lights. */
class LightChunk
{
public:
  /** Empties the chunk and returns its runs, which the caller fills. */
  ClusterRuns& Begin()
  {
    this->Runs.Clear();
    return this->Runs;
  }

  /** Counts the lights of each cluster. */
  void Count(std::uint32_t clusters)
  {
    this->Places.assign(clusters + std::size_t{ 1 }, 0);
    for (const ClusterRun& run : this->Runs)
    {
      ++this->Places[run.First];
      --this->Places[run.First + run.Count]; // may wrap below 0; the sum below undoes it
    }
    std::uint32_t count = 0;
    for (std::uint32_t& place : this->Places)
    {
      place = count += place;
    }
  }

  std::uint32_t CountIn(std::uint32_t cluster) const { return this->Places[cluster]; }

  /** Sets where this chunk's part of a cluster's list begins. */
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
  /** By cluster: the number of lights, later the position of the next entry. */
  std::vector<std::uint32_t> Places;
};

}

#endif
