#include "Core/lists/PoolSizing.h"

#include <algorithm>

namespace vitrine
{

namespace
{

constexpr std::uint64_t largestValue = std::numeric_limits<std::uint64_t>::max();

std::uint64_t SaturatingAdd(std::uint64_t a, std::uint64_t b)
{
  return a > largestValue - b ? largestValue : a + b;
}

std::uint64_t RoundedUp(std::uint64_t value)
{
  const std::uint64_t excess = value % PoolSizing::Granule;
  return excess == 0 ? value : SaturatingAdd(value, PoolSizing::Granule - excess);
}

// Returns capacity / 1.3 without overflow.
std::uint64_t SettledUse(std::uint64_t capacity)
{
  return capacity / 13 * 10 + capacity % 13 * 10 / 13;
}

}

PoolSizing::PoolSizing(std::uint64_t minimum)
  : Minimum(minimum)
  , Size(minimum)
{
}

void PoolSizing::SetLimit(std::uint64_t limit)
{
  this->Largest = limit;
  if (this->Size > limit)
  {
    this->Resize(limit);
  }
}

bool PoolSizing::Grow(std::uint64_t needed)
{
  if (needed > this->Size)
  {
    const bool isRepeated = this->FramesSinceGrowth < Window;
    const std::uint64_t reserve = isRepeated ? needed / 4 : needed / 8;
    this->Resize(std::max(this->Size, this->Bounded(SaturatingAdd(needed, reserve))));
    this->FramesSinceGrowth = 0;
    this->Patient = this->Patient || this->FramesSinceGross < Window;
  }
  return needed <= this->Size;
}

bool PoolSizing::EndFrame(std::uint64_t used)
{
  this->FramesSinceGrowth = std::min(this->FramesSinceGrowth + 1, Window);
  this->FramesSinceGross = std::min(this->FramesSinceGross + 1, Window);
  this->Low.Count(used, used < SettledUse(this->Size));
  this->Gross.Count(used, used < this->Size / GrossFactor);

  const bool isGross = this->Gross.Frames >= GrossWindow && !this->Patient;
  if (!isGross && this->Low.Frames < Window)
  {
    return false;
  }
  const std::uint64_t largestUse = isGross ? this->Gross.LargestUse : this->Low.LargestUse;
  const std::uint64_t size = this->Bounded(SaturatingAdd(largestUse, largestUse / 8));
  if (size >= this->Size)
  {
    return false;
  }
  this->Resize(size);
  this->FramesSinceGross = isGross ? 0 : this->FramesSinceGross;
  return true;
}

void PoolSizing::Streak::Count(std::uint64_t used, bool isLow)
{
  this->Frames = isLow ? this->Frames + 1 : 0;
  this->LargestUse = isLow ? std::max(this->LargestUse, used) : 0;
}

std::uint64_t PoolSizing::Bounded(std::uint64_t wanted) const
{
  return std::min(std::max(RoundedUp(wanted), this->Minimum), this->Largest);
}

void PoolSizing::Resize(std::uint64_t size)
{
  this->Size = size;
  this->Low = {};
  this->Gross = {};
}

}
