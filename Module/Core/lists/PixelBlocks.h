/**
 * Square blocks of pixels, in which a picture is taken row by row.
 */
#ifndef VITRINE_CORE_LISTS_PIXEL_BLOCKS_H
#define VITRINE_CORE_LISTS_PIXEL_BLOCKS_H

#include "Core/geometry/PixelRegion.h"

namespace vitrine
{

/** Blocks of pixels: the first one's column and row, and the number of columns and rows. */
struct BlockRange
{
  int First[2] = { 0, 0 };
  int Count[2] = { 0, 0 };

  bool operator==(const BlockRange& other) const
  {
    return this->First[0] == other.First[0] && this->First[1] == other.First[1] &&
      this->Count[0] == other.Count[0] && this->Count[1] == other.Count[1];
  }
  int Size() const { return this->Count[0] * this->Count[1]; }
};

/** The blocks of `side` pixels a side that `region` touches. */
BlockRange BlocksOf(const PixelRegion& region, int side);

/** The pixels of these blocks, some of which may lie beyond the image. */
PixelRegion PixelsOf(const BlockRange& blocks, int side);

}
#endif
