#ifndef VITRINE_CORE_OCTREE_ITEM_MARKS_H
#define VITRINE_CORE_OCTREE_ITEM_MARKS_H

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Marks items that were seen since Clear(), because an octree's walk meets some items several times. Clearing takes
 * constant time.
 */
class ItemMarks
{
public:
  explicit ItemMarks(std::uint32_t itemCount)
    : Stamps(itemCount, 0)
  {
  }

  /** Removes all marks. */
  void Clear()
  {
    if (++this->Stamp == 0)
    {
      std::fill(this->Stamps.begin(), this->Stamps.end(), 0);
      this->Stamp = 1;
    }
  }

  /** Marks an item. Returns true if it had no mark. */
  bool Mark(std::uint32_t item)
  {
    const bool isNew = this->Stamps[item] != this->Stamp;
    this->Stamps[item] = this->Stamp;
    return isNew;
  }

  bool IsMarked(std::uint32_t item) const { return this->Stamps[item] == this->Stamp; }

private:
  std::vector<std::uint32_t> Stamps;
  std::uint32_t Stamp = 1;
};

}

#endif
