/**
 * Splits a picture into bands that are drawn one after the other, if the memory is too small for all of it.
 */
#ifndef VITRINE_CORE_LISTS_SCREEN_BANDS_H
#define VITRINE_CORE_LISTS_SCREEN_BANDS_H

#include "Core/geometry/PixelRegion.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** A partition of a picture into bands that each fit into a pool. */
struct BandPlan
{
  /** Disjoint rectangles, ordered by row and then column. Each contains some need. Empty if !Fits. */
  std::vector<PixelRegion> Bands;
  /** The largest need of a single pixel. */
  std::uint64_t LargestPixel = 0;
  /** False if a single pixel needs more than the capacity, so no plan exists. */
  bool Fits = true;
};

/**
 * Splits a picture into rectangles whose pixels together need no more than `capacity`. Whole rows are packed greedily
 * into horizontal bands. A row that exceeds the capacity is cut along x. Each pixel with a need lies in exactly one
 * rectangle. Rectangles are shrunk to the columns and rows with a need.
 *
 * Two successive bands of whole rows together need more than the capacity. So there are fewer than twice as many as the
 * smallest possible number.
 *
 * @param need      the need of each pixel in units of the pool; width * height values, row by row
 * @param width     the width of the picture in pixels, may be 0
 * @param height    the height of the picture in pixels, may be 0
 * @param capacity  the capacity of the pool in units
 */
BandPlan PlanBands(
  const std::vector<std::uint32_t>& need, int width, int height, std::uint64_t capacity);

/** Splits only the part of the picture that lies in `region`. */
BandPlan PlanBands(const std::vector<std::uint32_t>& need, int width, int height,
  std::uint64_t capacity, const PixelRegion& region);

/**
 * Enlarges the bands of a plan until they cover `region`, for which they were planned, and returns them. They stay
 * disjoint, and their needs stay the same. So other needs in the same region lie in the bands as well.
 */
std::vector<PixelRegion> CoveringBands(
  const std::vector<PixelRegion>& bands, const PixelRegion& region);

}

#endif
