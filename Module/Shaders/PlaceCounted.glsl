// Packed lists, compute shader: gives each pixel room for the fragments that the last fill counted, but none beyond the
// end of the buffer. It reads the scanned sums of ScanCounts.glsl and the counts; it writes heads.
#include "ScanBlocks.glsl"
#include "PackedHeads.glsl"

uniform int blocks;
uniform uint capacity; // capacity of the buffer in nodes

void main()
{
  FOR_ONE_OF(block, blocks)
  ivec2 corner = blockAt(block) * VITRINE_BLOCK_SIZE;
  uint place = sums[block];
  for (int y = 0; y < VITRINE_BLOCK_SIZE; ++y)
  {
    for (int x = 0; x < VITRINE_BLOCK_SIZE; ++x)
    {
      ivec2 pixel = corner + ivec2(x, y);
      if (!isInRegion(pixel))
      {
        continue;
      }
      uint count = loadCount(pixel);
      uint start = min(place, capacity);
      storeRoom(pixel, start, min(count, capacity - start));
      place = addSaturating(place, count);
    }
  }
}
