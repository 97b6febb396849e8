#ifndef VITRINE_CORE_GEOMETRY_LANES_H
#define VITRINE_CORE_GEOMETRY_LANES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/**
 * Precedes a function that is also compiled for wider registers. The program picks the right version when it starts. No
 * version fuses products, so all of them give the same numbers.
 */
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__)
#define VITRINE_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define VITRINE_FOR_EACH_PROCESSOR
#endif

/**
 * Forces inlining. Functions with parameters of lanes need it, because registers differ between processors and cannot
 * pass lanes.
 */
#define VITRINE_INLINE inline __attribute__((always_inline))

/** Forces inlining of a lambda. It stands behind the parameters. */
#define VITRINE_INLINED __attribute__((always_inline))

namespace vitrine
{

const int LaneCount = 8;

/** A vector of eight floats (the vector extension of GCC and Clang). */
using Lanes = float __attribute__((vector_size(4 * LaneCount)));

/** The result of a comparison of lanes: all bits of a lane are 1 or 0. */
using LaneMask = std::int32_t __attribute__((vector_size(4 * LaneCount)));

/** A vector of four floats, and the result of a comparison of two. */
using HalfLanes = float __attribute__((vector_size(4 * LaneCount / 2)));
using HalfMask = std::int32_t __attribute__((vector_size(4 * LaneCount / 2)));

/** A vector of four doubles, such as a column of a matrix. */
using DoubleLanes = double __attribute__((vector_size(32)));

const std::size_t BytesOfLine = 64; ///< Size of a cache line in bytes.

/** Prefetches the cache line at an address. */
VITRINE_INLINE void Prefetch(const void* place)
{
  __builtin_prefetch(place);
}

/** Prefetches all cache lines of an object. */
template <class Thing>
VITRINE_INLINE void PrefetchAll(const Thing& thing)
{
  const char* const first = reinterpret_cast<const char*>(&thing);
  for (std::size_t offset = 0; offset < sizeof(Thing); offset += BytesOfLine)
  {
    Prefetch(first + offset);
  }
  if (alignof(Thing) < BytesOfLine)
  {
    Prefetch(first + sizeof(Thing) - 1);
  }
}

/** Returns the value in all lanes. */
VITRINE_INLINE Lanes AllLanes(float value)
{
  return Lanes{} + value;
}

/** Returns value, value + 1, and so on. */
VITRINE_INLINE Lanes LanesFrom(float value)
{
  return value + Lanes{ 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
}

/** Returns the minimum per lane, and b if either is NaN. */
VITRINE_INLINE Lanes LeastOf(Lanes a, Lanes b)
{
  return a < b ? a : b;
}

/** Returns the maximum per lane, and b if either is NaN. */
VITRINE_INLINE Lanes GreatestOf(Lanes a, Lanes b)
{
  return a > b ? a : b;
}

VITRINE_INLINE Lanes LeastOf(Lanes a, Lanes b, Lanes c)
{
  return LeastOf(LeastOf(a, b), c);
}

VITRINE_INLINE Lanes GreatestOf(Lanes a, Lanes b, Lanes c)
{
  return GreatestOf(GreatestOf(a, b), c);
}

/** Returns the absolute values. */
VITRINE_INLINE Lanes SizeOf(Lanes a)
{
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneMask>(a) & 0x7fffffff);
}

VITRINE_INLINE float LeastLane(Lanes a)
{
  a = LeastOf(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3));
  a = LeastOf(a, __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5));
  a = LeastOf(a, __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6));
  return a[0];
}

VITRINE_INLINE float GreatestLane(Lanes a)
{
  return -LeastLane(-a);
}

VITRINE_INLINE float SumOfLanes(Lanes a)
{
  a += __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3);
  a += __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5);
  a += __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6);
  return a[0];
}

/** Returns a bit for each lane. The first lane has the lowest bit. */
VITRINE_INLINE unsigned BitsOf(LaneMask mask)
{
#if defined(__SSE__)
  using Half = float __attribute__((vector_size(16)));
  Half halves[2];
  __builtin_memcpy(halves, &mask, sizeof(mask));
  return static_cast<unsigned>(
    __builtin_ia32_movmskps(halves[0]) | __builtin_ia32_movmskps(halves[1]) << 4);
#else
  LaneMask bits = mask & LaneMask{ 1, 2, 4, 8, 16, 32, 64, 128 };
  bits |= __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
  bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1, 6, 7, 4, 5);
  bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2, 5, 4, 7, 6);
  return static_cast<unsigned>(bits[0]);
#endif
}

VITRINE_INLINE unsigned BitsOf(HalfMask mask)
{
#if defined(__SSE__)
  HalfLanes lanes;
  __builtin_memcpy(&lanes, &mask, sizeof(mask));
  return static_cast<unsigned>(__builtin_ia32_movmskps(lanes));
#else
  HalfMask bits = mask & HalfMask{ 1, 2, 4, 8 };
  bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
  bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2);
  return static_cast<unsigned>(bits[0]);
#endif
}

/** Returns the mask of the lanes whose bits are 1. */
VITRINE_INLINE LaneMask LaneBits(unsigned bits)
{
  const LaneMask ofLanes{ 1, 2, 4, 8, 16, 32, 64, 128 };
  return ((LaneMask{} + static_cast<std::int32_t>(bits)) & ofLanes) == ofLanes;
}

/** Returns the index of the lowest 1 bit. The argument must not be 0. */
VITRINE_INLINE int LowestBit(unsigned bits)
{
  return __builtin_ctz(bits);
}

VITRINE_INLINE int CountBits(unsigned bits)
{
  return __builtin_popcount(bits);
}

/** Returns the mask of the first `count` lanes. */
VITRINE_INLINE LaneMask FirstLanes(int count)
{
  return LaneMask{ 0, 1, 2, 3, 4, 5, 6, 7 } < LaneMask{} + count;
}

/** Returns values[lanes[i]] in each lane i. */
VITRINE_INLINE Lanes Picked(Lanes values, LaneMask lanes)
{
#if defined(__clang__)
  Lanes picked;
  for (int i = 0; i < LaneCount; ++i)
  {
    picked[i] = values[lanes[i]];
  }
  return picked;
#else
  return __builtin_shuffle(values, lanes);
#endif
}

/** Loads eight consecutive floats. They need no alignment. */
VITRINE_INLINE Lanes LoadLanes(const float* values)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

/** Loads four consecutive floats of an object, from the float `first` on. */
template <class Thing>
VITRINE_INLINE HalfLanes LoadHalf(const Thing& thing, std::size_t first)
{
  HalfLanes lanes;
  __builtin_memcpy(
    &lanes, reinterpret_cast<const char*>(&thing) + first * sizeof(float), sizeof(lanes));
  return lanes;
}

VITRINE_INLINE void StoreLanes(Lanes lanes, float* values)
{
  __builtin_memcpy(values, &lanes, sizeof(lanes));
}

/** Loads eight consecutive 32-bit integers. They need no alignment. */
VITRINE_INLINE LaneMask LoadMask(const void* values)
{
  LaneMask mask;
  __builtin_memcpy(&mask, values, sizeof(mask));
  return mask;
}

VITRINE_INLINE void StoreMask(LaneMask mask, void* values)
{
  __builtin_memcpy(values, &mask, sizeof(mask));
}

/** Stores 32-bit integers interleaved: the first lanes of a, b, c and d, then the second ones, and so on. */
VITRINE_INLINE void StoreInterleaved(LaneMask a, LaneMask b, LaneMask c, LaneMask d, void* values)
{
  const LaneMask lowA = __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
  const LaneMask lowC = __builtin_shufflevector(c, d, 0, 8, 1, 9, 2, 10, 3, 11);
  const LaneMask highA = __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
  const LaneMask highC = __builtin_shufflevector(c, d, 4, 12, 5, 13, 6, 14, 7, 15);
  const LaneMask all[] = { __builtin_shufflevector(lowA, lowC, 0, 1, 8, 9, 2, 3, 10, 11),
    __builtin_shufflevector(lowA, lowC, 4, 5, 12, 13, 6, 7, 14, 15),
    __builtin_shufflevector(highA, highC, 0, 1, 8, 9, 2, 3, 10, 11),
    __builtin_shufflevector(highA, highC, 4, 5, 12, 13, 6, 7, 14, 15) };
  __builtin_memcpy(values, all, sizeof(all));
}

/** Loads a column of a matrix. */
VITRINE_INLINE DoubleLanes LoadDoubles(const double* values)
{
  DoubleLanes lanes;
  __builtin_memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

/** Returns the absolute values. */
VITRINE_INLINE DoubleLanes SizeOf(DoubleLanes a)
{
  return a > -a ? a : -a;
}

/** Rounds doubles to floats and stores them. */
VITRINE_INLINE void StoreAsFloats(DoubleLanes lanes, float* values)
{
  using FourFloats = float __attribute__((vector_size(16)));
  const FourFloats floats = __builtin_convertvector(lanes, FourFloats);
  __builtin_memcpy(values, &floats, sizeof(floats));
}

VITRINE_INLINE void StoreDoubles(DoubleLanes lanes, double* values)
{
  __builtin_memcpy(values, &lanes, sizeof(lanes));
}

/** Returns the absolute value of a float or a double. */
template <class Number>
VITRINE_INLINE std::enable_if_t<std::is_floating_point_v<Number>, Number> SizeOf(Number a)
{
  return std::abs(a);
}

template <class Number>
VITRINE_INLINE std::enable_if_t<std::is_floating_point_v<Number>, Number> GreatestOf(
  Number a, Number b)
{
  return a > b ? a : b;
}

}

#endif
