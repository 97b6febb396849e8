#ifndef VITRINE_CORE_LISTS_SCREEN_BANDS_H
#define VITRINE_CORE_LISTS_SCREEN_BANDS_H

#include "Core/geometry/PixelRegion.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** How to draw a picture in parts that each fit into a pool. */
struct BandPlan
{
  /** Rectangles without overlap, by rows and then columns, each with some need. Empty if !Fits. */
  std::vector<PixelRegion> Bands;
  /** The largest need of a single pixel. */
  std::uint64_t LargestPixel = 0;
  /** False if a pixel alone needs more than the capacity, so that no plan exists. */
  bool Fits = true;
};

/**
 * Splits a picture into rectangles whose pixels need no more than `capacity` together. Whole rows
 * are packed greedily into horizontal bands; a row that is too large for one is cut along x. Each
 * pixel with a need lies in exactly one rectangle; rectangles are cut down to the columns and rows
 * that have a need.
 *
 * Two successive bands of whole rows need more than the capacity together, so there are less than
 * twice as many as the least number possible.
 *
 * @param need      what each pixel needs, in units of the pool; row by row, width * height values
 * @param width     of the picture in pixels, may be 0
 * @param height    of the picture in pixels, may be 0
 * @param capacity  of the pool, in the same unit
 */
BandPlan PlanBands(
  const std::vector<std::uint32_t>& need, int width, int height, std::uint64_t capacity);

/** As above, for the part of the picture that lies in `region`; what lies outside is left out. */
BandPlan PlanBands(const std::vector<std::uint32_t>& need, int width, int height,
  std::uint64_t capacity, const PixelRegion& region);

}

#endif
