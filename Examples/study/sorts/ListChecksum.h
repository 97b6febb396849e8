/** Lists of keys with payloads, and a checksum of their order that ignores the order among equal keys. */
#ifndef VITRINE_STUDY_SORTS_LIST_CHECKSUM_H
#define VITRINE_STUDY_SORTS_LIST_CHECKSUM_H

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** An element of a list. The key is the bits of a depth from 0 to infinity, the payload is a packed colour. */
struct SortElement
{
  std::uint32_t Key;
  std::uint32_t Payload;
};

using SortList = std::vector<SortElement>;

/** The key of unused elements behind a list's end: NO_KEY of Registers.glsl. */
inline constexpr std::uint32_t NoKey = 0xffffffffu;

/**
 * Returns the checksum of a list in storage for `capacity` elements, as SortHarness.glsl computes it. It is a
 * polynomial in the keys, for their order, and a sum over the pairs of key and payload. Unused elements have NoKey and
 * payload 0.
 */
std::array<std::uint32_t, 2> ListChecksum(const SortList& list, int capacity);

}

#endif
