#include "Core/StencilMasks.h"

#include <algorithm>

namespace vitrine
{
namespace
{

// With which the last layer begins, whatever the group: how many fragments can be counted.
constexpr int LastStartValue = 255;

}

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
  std::vector<std::uint8_t> values(static_cast<std::size_t>(group.Layers()));
  const std::size_t last =
    static_cast<std::size_t>(group.Height / 2) * group.Width + group.Width / 2;
  int next = group.PassingValue();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<std::uint8_t>(i == last ? LastStartValue : next++);
  }
  return values;
}

MaskCounts CountMasked(const MaskGroup& group, const std::vector<std::uint8_t>& lastValues)
{
  MaskCounts counts;
  for (const std::uint8_t value : lastValues)
  {
    const int fragments = LastStartValue - value;
    counts.Fragments += fragments;
    counts.Lost += std::max(fragments - group.Layers(), 0);
    counts.Covered += fragments > 0;
    counts.Overflowing += fragments > group.Layers();
    counts.Saturated += value == 0;
    counts.LayersMax = std::max(counts.LayersMax, fragments);
  }
  return counts;
}

}
