/** Sums of part numbers by exclusive or, and which parts they are of. */
#ifndef VITRINE_CORE_SECTION_PART_SUMS_H
#define VITRINE_CORE_SECTION_PART_SUMS_H

#include "Core/section/PartHash.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>

namespace vitrine
{

/** The exclusive or of numbers of parts, and that of their hashes. */
using PartSum = std::array<std::uint32_t, 2>;

using PartSlots = std::set<std::uint32_t>;

/** Returns true if a sum is of one part, or of none. */
inline bool IsOfOnePart(const PartSum& sum)
{
  return PartHash(sum[0]) == sum[1];
}

/** Returns a sum with or without a part: it is taken away if it was in the sum, and added if it was not. */
inline PartSum Toggled(const PartSum& sum, std::uint32_t slot)
{
  return { sum[0] ^ slot, sum[1] ^ PartHash(slot) };
}

/**
 * Returns the parts of a sum, at most `most` of those that are known. Returns nothing if no such parts have this sum.
 * The time grows with the number of known parts to the power of `most` - 1.
 */
std::optional<PartSlots> PartsOf(const PartSum& sum, const PartSlots& known, int most = 3);

/**
 * Returns the parts of a sum, of which `inside` are expected and a few more or less may be there. Returns nothing if
 * more than three differ.
 */
std::optional<PartSlots> PartsNear(
  const PartSum& sum, const PartSlots& inside, const PartSlots& known);

}

#endif
