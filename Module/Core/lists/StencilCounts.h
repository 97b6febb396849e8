/**
 * What a stencil tells of a frame in which every fragment decremented it, down to 0 at most.
 */
#ifndef VITRINE_CORE_LISTS_STENCIL_COUNTS_H
#define VITRINE_CORE_LISTS_STENCIL_COUNTS_H

#include "Core/geometry/PixelRegion.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** In sum, by one value of the stencil for each pixel. */
struct StencilCounts
{
  std::int64_t Fragments =
    0;                   ///< of all pixels; what comes after the stencil reached 0 is not counted
  std::int64_t Lost = 0; ///< of them, those after the last layer of their pixel that is kept
  std::int64_t Covered = 0;   ///< pixels with fragments
  std::int64_t Saturated = 0; ///< pixels in which the stencil reached 0
  int LayersMax = 0;          ///< most in one pixel
};

/**
 * Count by the stencil's values, given those that it began with and the number of layers that are kept of each pixel. `values`
 * are replaced by the number of fragments.
 */
StencilCounts CountFragments(
  int layers, const std::vector<std::uint8_t>& startValues, std::vector<std::uint8_t>& values);

/** Where pixels with how many fragments lie. */
class CountedRegions
{
public:
  CountedRegions() = default;

  /** Of `width` x `counts.size() / width` pixels, row by row. */
  CountedRegions(const std::vector<std::uint8_t>& counts, int width);

  /** The smallest rectangle around the pixels with `first` to `last` fragments; empty if there are none. */
  PixelRegion Around(int first, int last = LargestCount) const;

  static constexpr int LargestCount = 255;

private:
  struct Box
  {
    int Left = 0;
    int Bottom = 0;
    int Right = 0; // beyond the last pixel; 0 of an empty box
    int Top = 0;

    void Include(const Box& other);
  };
  std::array<Box, LargestCount + 1> Boxes; // of pixels with exactly so many
};

}

#endif
