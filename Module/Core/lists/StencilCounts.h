/**
 * Evaluates a stencil that each fragment of a frame decremented, down to 0.
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

/** Sums over all pixels, from one stencil value for each pixel. */
struct StencilCounts
{
  std::int64_t Fragments = 0; ///< all fragments, except those after the stencil reached 0
  std::int64_t Lost = 0;      ///< fragments among these that exceed their pixel's number of layers
  std::int64_t Covered = 0;   ///< pixels with fragments
  std::int64_t Saturated = 0; ///< pixels whose stencil reached 0
  int LayersMax = 0;          ///< largest number of fragments in one pixel
};

/**
 * Counts fragments from the stencil's start and end values and the number of layers kept in each pixel. `values` is
 * replaced by the number of fragments.
 */
StencilCounts CountFragments(
  int layers, const std::vector<std::uint8_t>& startValues, std::vector<std::uint8_t>& values);

/** Finds the regions of pixels with given numbers of fragments. */
class CountedRegions
{
public:
  CountedRegions() = default;

  /**
   * @param counts  the number of fragments of each pixel, row by row
   * @param width   the width of the picture in pixels
   */
  CountedRegions(const std::vector<std::uint8_t>& counts, int width);

  /**
   * Returns the smallest rectangle around all pixels with `first` to `last` fragments. It is empty if there are none.
   */
  PixelRegion Around(int first, int last = LargestCount) const;

  static constexpr int LargestCount = 255;

private:
  struct Box
  {
    int Left = 0;
    int Bottom = 0;
    int Right = 0; // one past the last pixel; 0 if the box is empty
    int Top = 0;

    void Include(const Box& other);
  };
  std::array<Box, LargestCount + 1> Boxes; // by number of fragments
};

}

#endif
