#include "Core/lighting/LightRectangles.h"

#include <glm/common.hpp>

#include <algorithm>
#include <numeric>

namespace vitrine
{

namespace
{

/** Visits the tiles of each rectangle, light by light. */
template <class Visit>
void ForEachTile(
  const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles, const Visit& visit)
{
  for (const LightRectangle& rectangle : rectangles)
  {
    for (int row = rectangle.First.y; row <= rectangle.Last.y; ++row)
    {
      for (int column = rectangle.First.x; column <= rectangle.Last.x; ++column)
      {
        visit(grid.ClusterAt(column, row, 0), rectangle.Light);
      }
    }
  }
}
}

std::vector<LightRectangle> RectanglesOf(
  const ClusterGrid& grid, const LightLists& lists, int tilesAround)
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
  for (LightRectangle& rectangle : all)
  {
    rectangle.First = glm::max(rectangle.First - tilesAround, 0);
    rectangle.Last = glm::min(rectangle.Last + tilesAround, beyond - 1);
  }
  return all;
}

LightLists CoveredTiles(const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles)
{
  LightLists lists;
  lists.Offsets.assign(grid.Count() + 1, 0);
  ForEachTile(
    grid, rectangles, [&](std::uint32_t tile, std::uint32_t) { ++lists.Offsets[tile + 1]; });
  std::partial_sum(lists.Offsets.begin(), lists.Offsets.end(), lists.Offsets.begin());
  lists.Indices.resize(lists.Offsets.back());
  std::vector<std::uint32_t> next(lists.Offsets.begin(), lists.Offsets.end() - 1);
  ForEachTile(grid, rectangles,
    [&](std::uint32_t tile, std::uint32_t light) { lists.Indices[next[tile]++] = light; });
  return lists;
}

}
