#include "chart/ParetoFront.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
std::vector<std::size_t> SortByCost(const std::vector<CostAndError>& choices)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    if (!std::isnan(choices[i].Cost) && !std::isnan(choices[i].Error))
    {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      return choices[a].Cost != choices[b].Cost ? choices[a].Cost < choices[b].Cost
                                                : choices[a].Error < choices[b].Error;
    });
  return order;
}
}

std::vector<std::size_t> FindParetoFront(const std::vector<CostAndError>& choices)
{
  std::vector<std::size_t> front;
  for (const std::size_t i : SortByCost(choices))
  {
    const CostAndError& choice = choices[i];
    const CostAndError* last = front.empty() ? nullptr : &choices[front.back()];
    const bool isEqual = last && choice.Cost == last->Cost && choice.Error == last->Error;
    if (!last || isEqual || choice.Error < last->Error)
    {
      front.push_back(i);
    }
  }
  return front;
}

}
