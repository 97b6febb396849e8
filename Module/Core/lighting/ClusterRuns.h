#ifndef VITRINE_CORE_LIGHTING_CLUSTER_RUNS_H
#define VITRINE_CORE_LIGHTING_CLUSTER_RUNS_H

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Consecutive clusters that a light reaches. */
struct ClusterRun
{
  std::uint32_t Light;
  std::uint32_t First;
  std::uint32_t Count;
};

/** The clusters that lights reach, as runs. The runs of each light are consecutive. */
class ClusterRuns
{
public:
  void Add(std::uint32_t light, std::uint32_t first, std::uint32_t count)
  {
    if (!this->All.empty())
    {
      ClusterRun& last = this->All.back();
      if (last.Light == light && last.First + last.Count == first)
      {
        last.Count += count;
        return;
      }
    }
    this->All.push_back({ light, first, count });
  }

  void Clear() { this->All.clear(); }

  std::vector<ClusterRun>::const_iterator begin() const { return this->All.begin(); }
  std::vector<ClusterRun>::const_iterator end() const { return this->All.end(); }

private:
  std::vector<ClusterRun> All;
};

}

#endif
