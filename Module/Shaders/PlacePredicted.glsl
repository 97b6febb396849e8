// Packed lists: give each pixel of a block the room that ScanPrediction.glsl found, and none beyond the end of the
// buffer.
#include "ScanBlocks.glsl"
#include "PackedHeads.glsl"

uniform int blocks;
uniform uint capacity; // of the buffer, in nodes

void main()
{
  const int pixels = VITRINE_BLOCK_SIZE * VITRINE_BLOCK_SIZE;
  FOR_ONE_OF(i, blocks * pixels)
  int block = i / pixels;
  int inBlock = i % pixels;
  uint room = sums[ofBlocks + block];
  uint place = addSaturating(sums[block], room * uint(inBlock));
  ivec2 pixel = blockAt(block) * VITRINE_BLOCK_SIZE + ivec2(inBlock % VITRINE_BLOCK_SIZE, inBlock / VITRINE_BLOCK_SIZE);
  storeRoom(pixel, min(addSaturating(place, room), capacity), min(place, capacity));
}
