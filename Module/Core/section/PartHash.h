/** The hash by which a sum of part numbers tells whether it is of one part. */
#ifndef VITRINE_CORE_SECTION_PART_HASH_H
#define VITRINE_CORE_SECTION_PART_HASH_H

#include <cstdint>

namespace vitrine
{

/** Returns a hash of a number that is not linear under exclusive or. The shader PartHash.glsl has the same. */
inline std::uint32_t PartHash(std::uint32_t number)
{
  number ^= number >> 16;
  number *= 0x7feb352du;
  number ^= number >> 15;
  number *= 0x846ca68bu;
  number ^= number >> 16;
  return number;
}

}

#endif
