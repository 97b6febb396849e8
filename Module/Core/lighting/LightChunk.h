#ifndef VITRINE_CORE_LIGHTING_LIGHT_CHUNK_H
#define VITRINE_CORE_LIGHTING_LIGHT_CHUNK_H

#include "Core/lighting/ClusterRuns.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** What one thread finds of lights one after the other. */
class LightChunk
{
public:
  /** To be filled anew. */
  ClusterRuns& Begin()
  {
    this->Runs.Clear();
    return this->Runs;
  }

  /** Counts how many lights are in each cluster. */
  void Count(std::uint32_t clusters)
  {
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

}

#endif
