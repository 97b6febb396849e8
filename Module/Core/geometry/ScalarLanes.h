#ifndef VITRINE_CORE_GEOMETRY_SCALAR_LANES_H
#define VITRINE_CORE_GEOMETRY_SCALAR_LANES_H

#include <cstdint>
#include <functional>
#include <type_traits>

namespace vitrine
{

/**
 * A vector of numbers as an array, for compilers without vectors of their own. Its operators work lane by lane and give
 * the same numbers as the vector extension of GCC and Clang. A number on either side of an operator counts for all
 * lanes.
 */
template <class Number, int Count>
struct ScalarLanes
{
  /** The result of a comparison: all bits of a lane are 1 or 0. */
  using MaskNumber = std::conditional_t<sizeof(Number) == 4, std::int32_t, std::int64_t>;
  using Mask = ScalarLanes<MaskNumber, Count>;

  ScalarLanes() = default;

  ScalarLanes(Number value)
  {
    for (Number& lane : this->All)
    {
      lane = value;
    }
  }

  template <class... Numbers, class = std::enable_if_t<sizeof...(Numbers) == Count>>
  ScalarLanes(Numbers... values)
    : All{ static_cast<Number>(values)... }
  {
  }

  Number& operator[](int lane) { return this->All[lane]; }
  const Number& operator[](int lane) const { return this->All[lane]; }

  ScalarLanes operator-() const { return Map<ScalarLanes>(*this, *this, Negated()); }
  ScalarLanes operator~() const { return Map<ScalarLanes>(*this, *this, Inverted()); }

  friend ScalarLanes operator+(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::plus<>());
  }
  friend ScalarLanes operator-(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::minus<>());
  }
  friend ScalarLanes operator*(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::multiplies<>());
  }
  friend ScalarLanes operator/(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::divides<>());
  }
  friend ScalarLanes operator&(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::bit_and<>());
  }
  friend ScalarLanes operator|(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::bit_or<>());
  }
  friend ScalarLanes operator^(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<ScalarLanes>(a, b, std::bit_xor<>());
  }

  friend Mask operator<(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::less<>>());
  }
  friend Mask operator>(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::greater<>>());
  }
  friend Mask operator<=(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::less_equal<>>());
  }
  friend Mask operator>=(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::greater_equal<>>());
  }
  friend Mask operator==(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::equal_to<>>());
  }
  friend Mask operator!=(const ScalarLanes& a, const ScalarLanes& b)
  {
    return Map<Mask>(a, b, Compared<std::not_equal_to<>>());
  }

  ScalarLanes& operator+=(const ScalarLanes& other) { return *this = *this + other; }
  ScalarLanes& operator-=(const ScalarLanes& other) { return *this = *this - other; }
  ScalarLanes& operator*=(const ScalarLanes& other) { return *this = *this * other; }
  ScalarLanes& operator&=(const ScalarLanes& other) { return *this = *this & other; }
  ScalarLanes& operator|=(const ScalarLanes& other) { return *this = *this | other; }

  struct Negated
  {
    Number operator()(Number a, Number) const { return -a; }
  };
  struct Inverted
  {
    Number operator()(Number a, Number) const { return ~a; }
  };
  template <class Comparison>
  struct Compared
  {
    MaskNumber operator()(Number a, Number b) const { return Comparison()(a, b) ? -1 : 0; }
  };

  /** Returns work(a[i], b[i]) in each lane i. */
  template <class Result, class Work>
  static Result Map(const ScalarLanes& a, const ScalarLanes& b, const Work& work)
  {
    Result result;
    for (int lane = 0; lane < Count; ++lane)
    {
      result[lane] = work(a[lane], b[lane]);
    }
    return result;
  }

  Number All[Count]; ///< not set by the constructor without arguments
};

/** Returns a[i] where the mask is set and b[i] elsewhere, in each lane i. */
template <class Number, class MaskNumber, int Count>
ScalarLanes<Number, Count> Chosen(const ScalarLanes<MaskNumber, Count>& mask,
  const ScalarLanes<Number, Count>& a, const ScalarLanes<Number, Count>& b)
{
  ScalarLanes<Number, Count> chosen;
  for (int lane = 0; lane < Count; ++lane)
  {
    chosen[lane] = mask[lane] != 0 ? a[lane] : b[lane];
  }
  return chosen;
}

template <class Number>
Number Chosen(bool condition, const Number& a, const Number& b)
{
  return condition ? a : b;
}

/** Returns the lanes at some places of a, behind which those of b are counted. */
template <int... Places, class Number, int Count>
ScalarLanes<Number, sizeof...(Places)> Shuffled(
  const ScalarLanes<Number, Count>& a, const ScalarLanes<Number, Count>& b)
{
  ScalarLanes<Number, sizeof...(Places)> shuffled;
  int lane = 0;
  for (const int place : { Places... })
  {
    shuffled[lane++] = place < Count ? a[place] : b[place - Count];
  }
  return shuffled;
}

/** Returns the lanes as other numbers. Fractions are cut off where those are integers. */
template <class To, class Number, int Count>
To Converted(const ScalarLanes<Number, Count>& lanes)
{
  To converted;
  for (int lane = 0; lane < Count; ++lane)
  {
    converted[lane] = static_cast<std::remove_reference_t<decltype(converted[lane])>>(lanes[lane]);
  }
  return converted;
}

}

#endif
