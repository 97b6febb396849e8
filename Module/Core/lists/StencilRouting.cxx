#include "Core/lists/StencilRouting.h"

#include "Core/geometry/Rounding.h"

#include <algorithm>

namespace vitrine
{

const std::vector<int>& RoutedSampleCounts()
{
  static const std::vector<int> counts = { 1, 2, 4, 8, 16, 32 };
  return counts;
}

int StencilRoute::PassesFor(int layers) const
{
  return std::min(DividedUp(layers, this->Samples), this->MostPasses());
}

}
