// Packed lists: give each pixel room for as many fragments as the last fill counted, in places scanned from
// ScanCounts.glsl's sums, and none beyond the end of the buffer.
#include "ScanBlocks.glsl"
#include "PackedHeads.glsl"

uniform int blocks;
uniform uint capacity; // of the buffer, in nodes

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
