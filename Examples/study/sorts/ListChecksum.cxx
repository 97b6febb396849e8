#include "study/sorts/ListChecksum.h"

#include "study/shaders/SortLayout.h"

#include <cassert>

namespace vitrine
{

std::array<std::uint32_t, 2> ListChecksum(const SortList& list, int capacity)
{
  assert(list.size() <= static_cast<std::size_t>(capacity));
  std::array<std::uint32_t, 2> checksum = { 0, 0 };
  for (std::size_t i = 0; i < static_cast<std::size_t>(capacity); ++i)
  {
    const SortElement element = i < list.size() ? list[i] : SortElement{ NoKey, 0 };
    checksum[0] = checksum[0] * VITRINE_CHECKSUM_FACTOR + element.Key;
    checksum[1] +=
      (element.Key + VITRINE_CHECKSUM_KEY) * (element.Payload + VITRINE_CHECKSUM_PAYLOAD);
  }
  return checksum;
}

}
