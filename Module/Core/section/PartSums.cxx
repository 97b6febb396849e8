#include "Core/section/PartSums.h"

#include <iterator>

namespace vitrine
{

std::optional<PartSlots> PartsOf(const PartSum& sum, const PartSlots& known, int most)
{
  if (sum == PartSum{ 0, 0 })
  {
    return PartSlots();
  }
  if (known.count(sum[0]) > 0 && IsOfOnePart(sum))
  {
    return PartSlots{ sum[0] };
  }
  for (auto slot = known.begin(); most > 1 && slot != known.end(); ++slot)
  {
    const std::optional<PartSlots> others =
      PartsOf(Toggled(sum, *slot), PartSlots(std::next(slot), known.end()), most - 1);
    if (others)
    {
      PartSlots all = *others;
      all.insert(*slot);
      return all;
    }
  }
  return {};
}

std::optional<PartSlots> PartsNear(
  const PartSum& sum, const PartSlots& inside, const PartSlots& known)
{
  PartSum rest = sum;
  for (const std::uint32_t slot : inside)
  {
    rest = Toggled(rest, slot);
  }
  const std::optional<PartSlots> differing = PartsOf(rest, known);
  if (!differing)
  {
    return {};
  }
  PartSlots all = inside;
  for (const std::uint32_t slot : *differing)
  {
    if (!all.insert(slot).second)
    {
      all.erase(slot);
    }
  }
  return all;
}

}
