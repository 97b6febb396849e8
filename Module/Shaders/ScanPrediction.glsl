// Packed lists: the room that a block's pixels may need in the next frame, which makes level 0 of the sums: each as much
// as the longest list that this frame had in the block and its eight neighbours. Kept beside is the room of one pixel.
#include "ScanBlocks.glsl"

layout(r32ui, binding = VITRINE_IMAGE_BLOCKS) readonly uniform uimage2D longestLists; // of each block

uniform int blocks;

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
  room = min(room, VITRINE_LARGEST_COUNT);
  sums[ofBlocks + block] = room;
  sums[block] = room * uint(VITRINE_BLOCK_SIZE * VITRINE_BLOCK_SIZE);
}
