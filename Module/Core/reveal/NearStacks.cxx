#include "Core/reveal/NearStacks.h"

#include <algorithm>

namespace vitrine
{

void NearStacks::Add(int x, int y, std::uint32_t stack)
{
  std::vector<std::uint32_t>& tile = this->StacksOfTile[{ y / this->Side, x / this->Side }];
  if (stack != FrontStacks::NoStack && (tile.empty() || tile.back() != stack))
  {
    tile.push_back(stack);
  }
}

void NearStacks::AddTo(FrontStacks& stacks) const
{
  std::vector<std::uint32_t> layers(stacks.Parts().size(), 0);
  std::vector<std::uint32_t> around;
  std::vector<std::uint32_t> columns;
  for (const auto& [place, own] : this->StacksOfTile)
  {
    around.clear();
    columns.clear();
    for (int i = 0; i < 9; ++i)
    {
      const auto found =
        this->StacksOfTile.find({ place.first + i / 3 - 1, place.second + i % 3 - 1 });
      if (found != this->StacksOfTile.end())
      {
        around.insert(around.end(), found->second.begin(), found->second.end());
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::vector<FrontStacks::Entry> entries;
    for (const std::uint32_t stack : around)
    {
      for (const auto* entry = stacks.Begin(stack); entry != stacks.End(stack); ++entry)
      {
        if (layers[entry->Column] == 0)
        {
          columns.push_back(entry->Column);
        }
        layers[entry->Column] = std::max(layers[entry->Column], entry->Layers);
      }
    }
    std::sort(columns.begin(), columns.end());
    for (const std::uint32_t column : columns)
    {
      entries.push_back({ column, layers[column] });
      layers[column] = 0;
    }
    if (!entries.empty())
    {
      stacks.AddNear(entries);
    }
  }
}

}
