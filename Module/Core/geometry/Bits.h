#ifndef VITRINE_CORE_GEOMETRY_BITS_H
#define VITRINE_CORE_GEOMETRY_BITS_H

#include <cstdint>

namespace vitrine
{

#if defined(__GNUC__) && !defined(VITRINE_SCALAR_LANES)

inline int CountBits(std::uint32_t bits)
{
  return __builtin_popcount(bits);
}

inline int CountBits(std::uint64_t bits)
{
  return __builtin_popcountll(bits);
}

/** Returns the index of the lowest 1 bit. The argument must not be 0. */
inline int LowestBit(std::uint32_t bits)
{
  return __builtin_ctz(bits);
}

inline int LowestBit(std::uint64_t bits)
{
  return __builtin_ctzll(bits);
}

#else

/** Returns the number of 1 bits. It adds neighbours: bits, then pairs, then groups of four, then all bytes. */
inline int CountBits(std::uint64_t bits)
{
  bits -= bits >> 1 & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<int>(bits * 0x0101010101010101u >> 56);
}

inline int CountBits(std::uint32_t bits)
{
  return CountBits(std::uint64_t{ bits });
}

/** Returns the index of the lowest 1 bit, which is the number of 0 bits below it. The argument must not be 0. */
inline int LowestBit(std::uint64_t bits)
{
  return CountBits(~bits & (bits - 1));
}

inline int LowestBit(std::uint32_t bits)
{
  return LowestBit(std::uint64_t{ bits });
}

#endif

}

#endif
