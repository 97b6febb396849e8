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
  for (const auto& [place, own] : this->StacksOfTile)
  {
    around.clear();
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
        layers[entry->Column] = std::max(layers[entry->Column], entry->Layers);
      }
    }
    for (std::uint32_t column = 0; column < layers.size(); ++column)
    {
      if (layers[column] != 0)
      {
        entries.push_back({ column, layers[column] });
        layers[column] = 0;
      }
    }
    if (!entries.empty())
    {
      stacks.AddNear(entries);
    }
  }
}

}
