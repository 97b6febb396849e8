/**
 * Lists of keys with payloads, and a checksum of them in order that does not depend on the order among equal keys.
 */
#ifndef VITRINE_STUDY_SORTS_LIST_CHECKSUM_H
#define VITRINE_STUDY_SORTS_LIST_CHECKSUM_H

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** What is sorted: a key, the bits of a depth from 0 to infinity, and what goes with it, a packed colour. */
struct SortElement
{
  std::uint32_t Key;
  std::uint32_t Payload;
};

using SortList = std::vector<SortElement>;

/** The key of elements that storage holds behind a list's end: NO_KEY of Registers.glsl. */
inline constexpr std::uint32_t NoKey = 0xffffffffu;

/**
 * The checksum of a list in storage for `capacity` elements, as SortHarness.glsl computes it: a polynomial in the
 * keys, for their order, and a sum over the pairs of key and payload. Unused elements have NoKey and payload 0.
 */
std::array<std::uint32_t, 2> ListChecksum(const SortList& list, int capacity);

}

#endif
