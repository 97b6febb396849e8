// Packed lists: the number of fragments that the last fill counted in each block, which makes level 0 of the sums. Kept
// beside is where the block's first list began in that fill, since PlaceCounted.glsl changes the heads of all at once.
#include "ScanBlocks.glsl"
#include "PackedHeads.glsl"
#include "PackedOrder.glsl"

uniform int blocks;

void main()
{
  FOR_ONE_OF(block, blocks)
  ivec2 corner = blockAt(block) * VITRINE_BLOCK_SIZE;
  uint start = block == 0 ? 0u : loadRoom(pixelBefore(corner, blockFirst, blockCount)).x;
  sums[ofBlocks + block] = start;

  uint sum = 0u;
  for (int y = 0; y < VITRINE_BLOCK_SIZE; ++y)
  {
    for (int x = 0; x < VITRINE_BLOCK_SIZE; ++x)
    {
      uvec2 room = loadRoom(corner + ivec2(x, y));
      sum = addSaturating(sum, room.y - start);
      start = room.x;
    }
  }
  sums[block] = sum;
}
