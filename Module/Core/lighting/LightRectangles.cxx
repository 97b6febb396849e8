#include "Core/lighting/LightRectangles.h"

#include <glm/common.hpp>

#include <algorithm>

namespace vitrine
{

std::vector<LightRectangle> RectanglesOf(const ClusterGrid& grid, const LightLists& lists)
{
  const auto last = std::max_element(lists.Indices.begin(), lists.Indices.end());
  const std::size_t count = last == lists.Indices.end() ? 0 : std::size_t{ *last } + 1;
  const glm::ivec2 beyond(grid.Columns(), grid.Rows());
  std::vector<LightRectangle> all(count, { 0, beyond, glm::ivec2(-1) });
  for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
  {
    const int place = static_cast<int>(cluster);
    const glm::ivec2 tile(place % beyond.x, place / beyond.x % beyond.y);
    for (const std::uint32_t* light = lists.BeginOf(cluster); light != lists.EndOf(cluster);
         ++light)
    {
      LightRectangle& rectangle = all[*light];
      rectangle = { *light, glm::min(rectangle.First, tile), glm::max(rectangle.Last, tile) };
    }
  }
  all.erase(std::remove_if(all.begin(), all.end(),
              [](const LightRectangle& rectangle) { return rectangle.Last.x < 0; }),
    all.end());
  return all;
}

LightLists CoveredTiles(const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles)
{
  std::vector<std::vector<std::uint32_t>> tiles(grid.Count());
  for (const LightRectangle& rectangle : rectangles)
  {
    for (int row = rectangle.First.y; row <= rectangle.Last.y; ++row)
    {
      for (int column = rectangle.First.x; column <= rectangle.Last.x; ++column)
      {
        tiles[grid.ClusterAt(column, row, 0)].push_back(rectangle.Light);
      }
    }
  }
  LightLists lists;
  lists.Offsets = { 0 };
  for (const std::vector<std::uint32_t>& tile : tiles)
  {
    lists.Indices.insert(lists.Indices.end(), tile.begin(), tile.end());
    lists.Offsets.push_back(static_cast<std::uint32_t>(lists.Indices.size()));
  }
  return lists;
}

}
