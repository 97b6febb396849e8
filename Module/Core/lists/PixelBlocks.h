/**
 * Divides a picture into square blocks of pixels, in row-major order.
 */
#ifndef VITRINE_CORE_LISTS_PIXEL_BLOCKS_H
#define VITRINE_CORE_LISTS_PIXEL_BLOCKS_H

#include "Core/geometry/PixelRegion.h"

namespace vitrine
{

/** A rectangle of blocks: column and row of the first block, and the numbers of columns and rows. */
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

/** Returns the blocks of `side` x `side` pixels that `region` touches. */
BlockRange BlocksOf(const PixelRegion& region, int side);

/** Returns the pixels of these blocks. Some may lie outside the image. */
PixelRegion PixelsOf(const BlockRange& blocks, int side);

}
#endif
