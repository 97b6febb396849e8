// Packed lists, compute shader: predicts the room of each pixel in this frame. The room is the longest list that the
// last frame had in the pixel's block and its eight neighbours. It has a reserve if such rooms were too small lately.
// It reads the blocks' longest lists. It writes level 0 of the sums, and beside it the room of one pixel of each block.
#include "ScanBlocks.glsl"

// For each block.
layout(r32ui, binding = VITRINE_IMAGE_BLOCKS) readonly uniform uimage2D longestLists;

uniform int blocks;
uniform int hasReserve;

void main()
{
  FOR_ONE_OF(block, blocks)
  ivec2 last = blockFirst + blockCount - 1;
  uint room = 0u;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      room = max(room, imageLoad(longestLists, clamp(blockAt(block) + ivec2(x, y), blockFirst, last)).x);
    }
  }
  room += hasReserve != 0 && room > 0u ? room / 4u + 2u : 0u;
  room = min(room, VITRINE_LARGEST_COUNT);
  sums[ofBlocks + block] = room;
  sums[block] = room * uint(VITRINE_BLOCK_SIZE * VITRINE_BLOCK_SIZE);
}
