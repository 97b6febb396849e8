#include "Core/culling/mesh/OrderedRuns.h"

#include <algorithm>

namespace vitrine
{

namespace
{

// Cost of testing and drawing a run besides its items, in items.
const double ItemsPerRun = 256.0;

// A cut keeps at least one in this many of the items on each side. So the depth of the recursion stays small.
const std::uint32_t ShareOfEnds = 32;

double HalfSurface(const Box& box)
{
  const glm::dvec3 size = glm::dvec3(box.Max) - glm::dvec3(box.Min);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

double CostOf(const Box& box, std::uint32_t items)
{
  return HalfSurface(box) * (items + ItemsPerRun);
}

/** Cuts runs recursively while it pays. */
class Cutter
{
public:
  explicit Cutter(const std::vector<Box>& boxes)
    : Boxes(boxes)
    , CostBehind(boxes.size())
  {
  }

  std::vector<OrderedRun> Cut()
  {
    this->Cut(0, static_cast<std::uint32_t>(this->Boxes.size()));
    return std::move(this->Runs);
  }

private:
  void Cut(std::uint32_t first, std::uint32_t end)
  {
    const std::uint32_t middle = this->BestCut(first, end);
    if (middle == end)
    {
      this->Runs.push_back({ first, end - first, this->Around });
      return;
    }
    this->Cut(first, middle);
    this->Cut(middle, end);
  }

  /** Returns the first item behind the best cut, or `end` if no cut pays. Stores the box of all items in Around. */
  std::uint32_t BestCut(std::uint32_t first, std::uint32_t end)
  {
    const std::uint32_t count = end - first;
    const std::uint32_t margin = std::max(LeastItemsOfARun, count / ShareOfEnds);
    this->MeasureFromBehind(first, end);
    if (count < 2 * margin)
    {
      return end;
    }
    std::uint32_t best = count > MostItemsOfARun ? first + count / 2 : end;
    double least = best == end ? CostOf(this->Around, count) : this->CostOfCut(first, best);
    Box before;
    for (std::uint32_t i = first; i < end - margin; ++i)
    {
      if (i >= first + margin)
      {
        const double cost = CostOf(before, i - first) + this->CostBehind[i];
        if (cost < least)
        {
          best = i;
          least = cost;
        }
      }
      before.Add(this->Boxes[i]);
    }
    return best;
  }

  void MeasureFromBehind(std::uint32_t first, std::uint32_t end)
  {
    this->Around = Box();
    for (std::uint32_t i = end; i-- > first;)
    {
      this->Around.Add(this->Boxes[i]);
      this->CostBehind[i] = CostOf(this->Around, end - i);
    }
  }

  double CostOfCut(std::uint32_t first, std::uint32_t cut) const
  {
    Box before;
    for (std::uint32_t i = first; i < cut; ++i)
    {
      before.Add(this->Boxes[i]);
    }
    return CostOf(before, cut - first) + this->CostBehind[cut];
  }

  const std::vector<Box>& Boxes;
  std::vector<double> CostBehind; ///< Cost of each item together with all later items of its run.
  std::vector<OrderedRun> Runs;
  Box Around;
};
}

std::vector<OrderedRun> CutIntoRuns(const std::vector<Box>& boxes)
{
  return boxes.empty() ? std::vector<OrderedRun>() : Cutter(boxes).Cut();
}

}
