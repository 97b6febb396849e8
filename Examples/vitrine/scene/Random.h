/**
 * Random numbers that are the same on every machine, for generated scenes.
 *
 * SplitMix64: G. L. Steele, D. Lea, C. H. Flood: Fast Splittable Pseudorandom Number Generators,
 * OOPSLA 2014.
 */
#ifndef VITRINE_RANDOM_H
#define VITRINE_RANDOM_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace program
{

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }

  std::uint64_t Next()
  {
    this->State += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

  /** A number in [0, 1), a multiple of 2^-53. */
  double Unit() { return static_cast<double>(this->Next() >> 11) * 0x1.0p-53; }

  double Between(double low, double high) { return low + (high - low) * this->Unit(); }

  /** An integer in [0, count). Its bias is below 2^-32 for counts below 2^32. */
  std::size_t Below(std::size_t count) { return static_cast<std::size_t>(this->Next() % count); }

  /** Put the items into random order (Fisher and Yates). */
  template <typename T>
  void Shuffle(std::vector<T>& items)
  {
    for (std::size_t i = items.size(); i > 1; --i)
    {
      std::swap(items[i - 1], items[this->Below(i)]);
    }
  }

private:
  std::uint64_t State;
};

}
#endif
