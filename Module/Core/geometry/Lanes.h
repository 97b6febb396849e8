#ifndef VITRINE_CORE_GEOMETRY_LANES_H
#define VITRINE_CORE_GEOMETRY_LANES_H

#include "Core/geometry/Bits.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Compilers without vectors, such as MSVC, compute lane by lane. VITRINE_SCALAR_LANES lets any compiler do so.
#if !defined(__GNUC__) && !defined(VITRINE_SCALAR_LANES)
#define VITRINE_SCALAR_LANES
#endif
#if defined(VITRINE_SCALAR_LANES)
#include "Core/geometry/ScalarLanes.h"
#endif

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
#if defined(__GNUC__)
#define VITRINE_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define VITRINE_INLINE __forceinline
#else
#define VITRINE_INLINE inline
#endif

/** Forces inlining of a lambda. It stands behind the parameters. */
#if defined(__GNUC__)
#define VITRINE_INLINED __attribute__((always_inline))
#else
#define VITRINE_INLINED
#endif

namespace vitrine
{

const int LaneCount = 8;

#if defined(VITRINE_SCALAR_LANES)

using Lanes = ScalarLanes<float, LaneCount>;
using LaneMask = Lanes::Mask;
using HalfLanes = ScalarLanes<float, LaneCount / 2>;
using HalfMask = HalfLanes::Mask;
using DoubleLanes = ScalarLanes<double, 4>;

#else

/** A vector of eight floats (the vector extension of GCC and Clang). */
using Lanes = float __attribute__((vector_size(4 * LaneCount)));

/** The result of a comparison of lanes: all bits of a lane are 1 or 0. */
using LaneMask = std::int32_t __attribute__((vector_size(4 * LaneCount)));

/** A vector of four floats, and the result of a comparison of two. */
using HalfLanes = float __attribute__((vector_size(4 * LaneCount / 2)));
using HalfMask = std::int32_t __attribute__((vector_size(4 * LaneCount / 2)));

/** A vector of four doubles, such as a column of a matrix. */
using DoubleLanes = double __attribute__((vector_size(32)));

/** Returns a[i] where the mask is set and b[i] elsewhere, in each lane i. A bool chooses between any two values. */
template <class Mask, class Value>
VITRINE_INLINE Value Chosen(Mask mask, Value a, Value b)
{
  return mask ? a : b;
}

/** Returns the lanes at some places of a, behind which those of b are counted. */
template <int... Places, class Vector>
VITRINE_INLINE auto Shuffled(Vector a, Vector b)
{
  return __builtin_shufflevector(a, b, Places...);
}

/** Returns the lanes as other numbers. Fractions are cut off where those are integers. */
template <class To, class Vector>
VITRINE_INLINE To Converted(Vector lanes)
{
  return __builtin_convertvector(lanes, To);
}

#endif

/** Returns the lanes at some places. */
template <int... Places, class Vector>
VITRINE_INLINE auto Shuffled(const Vector& a)
{
  return Shuffled<Places...>(a, a);
}

const std::size_t BytesOfLine = 64; ///< Size of a cache line in bytes.

/** Prefetches the cache line at an address. */
VITRINE_INLINE void Prefetch(const void* place)
{
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
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
  return Chosen(a < b, a, b);
}

/** Returns the maximum per lane, and b if either is NaN. */
VITRINE_INLINE Lanes GreatestOf(Lanes a, Lanes b)
{
  return Chosen(a > b, a, b);
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
  LaneMask bits;
  std::memcpy(&bits, &a, sizeof(bits));
  bits &= 0x7fffffff;
  std::memcpy(&a, &bits, sizeof(a));
  return a;
}

VITRINE_INLINE float LeastLane(Lanes a)
{
  a = LeastOf(a, Shuffled<4, 5, 6, 7, 0, 1, 2, 3>(a));
  a = LeastOf(a, Shuffled<2, 3, 0, 1, 6, 7, 4, 5>(a));
  a = LeastOf(a, Shuffled<1, 0, 3, 2, 5, 4, 7, 6>(a));
  return a[0];
}

VITRINE_INLINE float GreatestLane(Lanes a)
{
  return -LeastLane(-a);
}

VITRINE_INLINE float SumOfLanes(Lanes a)
{
  a += Shuffled<4, 5, 6, 7, 0, 1, 2, 3>(a);
  a += Shuffled<2, 3, 0, 1, 6, 7, 4, 5>(a);
  a += Shuffled<1, 0, 3, 2, 5, 4, 7, 6>(a);
  return a[0];
}

/** Returns a bit for each lane. The first lane has the lowest bit. */
VITRINE_INLINE unsigned BitsOf(LaneMask mask)
{
#if defined(__SSE__) && !defined(VITRINE_SCALAR_LANES)
  HalfLanes halves[2];
  std::memcpy(halves, &mask, sizeof(mask));
  return static_cast<unsigned>(
    __builtin_ia32_movmskps(halves[0]) | __builtin_ia32_movmskps(halves[1]) << 4);
#else
  LaneMask bits = mask & LaneMask{ 1, 2, 4, 8, 16, 32, 64, 128 };
  bits |= Shuffled<4, 5, 6, 7, 0, 1, 2, 3>(bits);
  bits |= Shuffled<2, 3, 0, 1, 6, 7, 4, 5>(bits);
  bits |= Shuffled<1, 0, 3, 2, 5, 4, 7, 6>(bits);
  return static_cast<unsigned>(bits[0]);
#endif
}

VITRINE_INLINE unsigned BitsOf(HalfMask mask)
{
#if defined(__SSE__) && !defined(VITRINE_SCALAR_LANES)
  HalfLanes lanes;
  std::memcpy(&lanes, &mask, sizeof(mask));
  return static_cast<unsigned>(__builtin_ia32_movmskps(lanes));
#else
  HalfMask bits = mask & HalfMask{ 1, 2, 4, 8 };
  bits |= Shuffled<2, 3, 0, 1>(bits);
  bits |= Shuffled<1, 0, 3, 2>(bits);
  return static_cast<unsigned>(bits[0]);
#endif
}

/** Returns the mask of the lanes whose bits are 1. */
VITRINE_INLINE LaneMask LaneBits(unsigned bits)
{
  const LaneMask ofLanes{ 1, 2, 4, 8, 16, 32, 64, 128 };
  return ((LaneMask{} + static_cast<std::int32_t>(bits)) & ofLanes) == ofLanes;
}

/** Returns the mask of the first `count` lanes. */
VITRINE_INLINE LaneMask FirstLanes(int count)
{
  return LaneMask{ 0, 1, 2, 3, 4, 5, 6, 7 } < LaneMask{} + count;
}

/** Returns values[lanes[i]] in each lane i. */
VITRINE_INLINE Lanes Picked(Lanes values, LaneMask lanes)
{
#if defined(__clang__) || defined(VITRINE_SCALAR_LANES)
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
  std::memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

/** Loads four consecutive floats of an object, from the float `first` on. */
template <class Thing>
VITRINE_INLINE HalfLanes LoadHalf(const Thing& thing, std::size_t first)
{
  HalfLanes lanes;
  std::memcpy(&lanes, reinterpret_cast<const char*>(&thing) + first * sizeof(float), sizeof(lanes));
  return lanes;
}

VITRINE_INLINE void StoreLanes(Lanes lanes, float* values)
{
  std::memcpy(values, &lanes, sizeof(lanes));
}

/** Loads eight consecutive 32-bit integers. They need no alignment. */
VITRINE_INLINE LaneMask LoadMask(const void* values)
{
  LaneMask mask;
  std::memcpy(&mask, values, sizeof(mask));
  return mask;
}

VITRINE_INLINE void StoreMask(LaneMask mask, void* values)
{
  std::memcpy(values, &mask, sizeof(mask));
}

/** Stores 32-bit integers interleaved: the first lanes of a, b, c and d, then the second ones, and so on. */
VITRINE_INLINE void StoreInterleaved(LaneMask a, LaneMask b, LaneMask c, LaneMask d, void* values)
{
  const LaneMask lowA = Shuffled<0, 8, 1, 9, 2, 10, 3, 11>(a, b);
  const LaneMask lowC = Shuffled<0, 8, 1, 9, 2, 10, 3, 11>(c, d);
  const LaneMask highA = Shuffled<4, 12, 5, 13, 6, 14, 7, 15>(a, b);
  const LaneMask highC = Shuffled<4, 12, 5, 13, 6, 14, 7, 15>(c, d);
  const LaneMask all[] = { Shuffled<0, 1, 8, 9, 2, 3, 10, 11>(lowA, lowC),
    Shuffled<4, 5, 12, 13, 6, 7, 14, 15>(lowA, lowC),
    Shuffled<0, 1, 8, 9, 2, 3, 10, 11>(highA, highC),
    Shuffled<4, 5, 12, 13, 6, 7, 14, 15>(highA, highC) };
  std::memcpy(values, all, sizeof(all));
}

/** Loads a column of a matrix. */
VITRINE_INLINE DoubleLanes LoadDoubles(const double* values)
{
  DoubleLanes lanes;
  std::memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

/** Returns the absolute values. */
VITRINE_INLINE DoubleLanes SizeOf(DoubleLanes a)
{
  return Chosen(a > -a, a, -a);
}

/** Rounds doubles to floats and stores them. */
VITRINE_INLINE void StoreAsFloats(DoubleLanes lanes, float* values)
{
  const HalfLanes floats = Converted<HalfLanes>(lanes);
  std::memcpy(values, &floats, sizeof(floats));
}

VITRINE_INLINE void StoreDoubles(DoubleLanes lanes, double* values)
{
  std::memcpy(values, &lanes, sizeof(lanes));
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
