#include "Core/lighting/TileLists.h"

#include <algorithm>

namespace vitrine
{

void MarkBetween(const ClusterGrid& grid, std::vector<std::uint8_t>& marks)
{
  const std::size_t tiles = static_cast<std::size_t>(grid.Columns()) * grid.Rows();
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    std::size_t first = marks.size(), last = 0;
    for (std::size_t cluster = tile; cluster < marks.size(); cluster += tiles)
    {
      if (marks[cluster] != 0)
      {
        first = std::min(first, cluster);
        last = cluster;
      }
    }
    for (std::size_t cluster = first; cluster < last; cluster += tiles)
    {
      marks[cluster] = 1;
    }
  }
}

std::vector<std::uint8_t> JoinMarks(const ClusterGrid& grid, const std::vector<std::uint8_t>& marks)
{
  const std::size_t tiles = static_cast<std::size_t>(grid.Columns()) * grid.Rows();
  std::vector<std::uint8_t> joined(std::min(tiles, marks.size()), 0);
  for (std::size_t cluster = 0; cluster < marks.size(); ++cluster)
  {
    joined[cluster % tiles] |= marks[cluster];
  }
  return joined;
}

LightLists JoinSlices(const ClusterGrid& grid, const LightLists& lists)
{
  const std::uint32_t tiles = static_cast<std::uint32_t>(grid.Columns() * grid.Rows());
  LightLists joined;
  joined.Offsets = { 0 };
  for (std::uint32_t tile = 0; tile < tiles; ++tile)
  {
    const auto begin = static_cast<std::ptrdiff_t>(joined.Indices.size());
    for (std::uint32_t cluster = tile; cluster < grid.Count(); cluster += tiles)
    {
      joined.Indices.insert(joined.Indices.end(), lists.BeginOf(cluster), lists.EndOf(cluster));
    }
    std::sort(joined.Indices.begin() + begin, joined.Indices.end());
    joined.Indices.erase(
      std::unique(joined.Indices.begin() + begin, joined.Indices.end()), joined.Indices.end());
    joined.Offsets.push_back(static_cast<std::uint32_t>(joined.Indices.size()));
  }
  return joined;
}

}
