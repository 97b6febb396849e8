// The order in which the lists of pixels lie in a packed buffer: blocks of VITRINE_BLOCK_SIZE x VITRINE_BLOCK_SIZE
// pixels row by row, and the pixels of a block row by row. Core/PackedOrder.h is the same in C++.
#include "SharedLayout.h"

// The pixel whose list lies before that of `pixel`, which is not the first pixel of the first block, where
// `count` blocks from `first` on have lists.
ivec2 pixelBefore(ivec2 pixel, ivec2 first, ivec2 count)
{
  const int side = VITRINE_BLOCK_SIZE;
  ivec2 inBlock = pixel & (side - 1);
  if (inBlock.x > 0)
  {
    return pixel - ivec2(1, 0);
  }
  if (inBlock.y > 0)
  {
    return pixel + ivec2(side - 1, -1);
  }
  ivec2 block = pixel / side;
  block = block.x > first.x ? block - ivec2(1, 0) : ivec2(first.x + count.x - 1, block.y - 1);
  return block * side + side - 1;
}
