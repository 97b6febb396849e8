#include "Core/lists/StencilMasks.h"

#include <algorithm>
#include <numeric>

namespace vitrine
{
std::optional<MaskGroup> FindMaskGroup(int layers)
{
  for (const MaskGroup& group : { MaskGroup{ 2, 2 }, { 4, 2 }, { 3, 3 }, { 4, 4 } })
  {
    if (group.Layers() == layers)
    {
      return group;
    }
  }
  return std::nullopt;
}

std::vector<std::uint8_t> MaskStartValues(const MaskGroup& group)
{
  std::vector<int> places(static_cast<std::size_t>(group.Layers()));
  std::iota(places.begin(), places.end(), 0);
  const auto distance = [&group](int place)
  {
    const int x = 2 * (place % group.Width) + 1 - group.Width;
    const int y = 2 * (place / group.Width) + 1 - group.Height;
    return x * x + y * y;
  };
  std::stable_sort(
    places.begin(), places.end(), [&distance](int a, int b) { return distance(a) > distance(b); });

  std::vector<std::uint8_t> values(places.size());
  int next = group.PassingValue();
  for (const int place : places)
  {
    values[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(next++);
  }
  return values;
}

}
