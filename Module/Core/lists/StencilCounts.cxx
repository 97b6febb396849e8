#include "Core/lists/StencilCounts.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

StencilCounts CountFragments(
  int layers, const std::vector<std::uint8_t>& startValues, std::vector<std::uint8_t>& values)
{
  assert(startValues.size() == values.size());
  StencilCounts counts;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    counts.Saturated += values[i] == 0;
    const int fragments = startValues[i] - values[i];
    counts.Fragments += fragments;
    counts.Lost += std::max(fragments - layers, 0);
    counts.Covered += fragments > 0;
    counts.LayersMax = std::max(counts.LayersMax, fragments);
    values[i] = static_cast<std::uint8_t>(fragments);
  }
  return counts;
}

void CountedRegions::Box::Include(const Box& other)
{
  if (other.Right == 0)
  {
    return;
  }
  if (this->Right == 0)
  {
    *this = other;
    return;
  }
  this->Left = std::min(this->Left, other.Left);
  this->Bottom = std::min(this->Bottom, other.Bottom);
  this->Right = std::max(this->Right, other.Right);
  this->Top = std::max(this->Top, other.Top);
}

CountedRegions::CountedRegions(const std::vector<std::uint8_t>& counts, int width)
{
  assert(width > 0 && counts.size() % static_cast<std::size_t>(width) == 0);
  int x = 0;
  int y = 0;
  for (const std::uint8_t count : counts)
  {
    this->Boxes[count].Include({ x, y, x + 1, y + 1 });
    if (++x == width)
    {
      x = 0;
      ++y;
    }
  }
}

PixelRegion CountedRegions::Around(int first, int last) const
{
  Box box;
  for (int count = std::max(first, 0); count <= std::min(last, LargestCount); ++count)
  {
    box.Include(this->Boxes[static_cast<std::size_t>(count)]);
  }
  return { box.Left, box.Bottom, box.Right - box.Left, box.Top - box.Bottom };
}

}
