// Packed lists, compute shader: sums the fragments that the last fill counted in each block. It reads heads and writes
// level 0 of the sums.
#include "ScanBlocks.glsl"
#include "PackedHeads.glsl"

uniform int blocks;

void main()
{
  FOR_ONE_OF(block, blocks)
  ivec2 corner = blockAt(block) * VITRINE_BLOCK_SIZE;
  uint sum = 0u;
  for (int y = 0; y < VITRINE_BLOCK_SIZE; ++y)
  {
    for (int x = 0; x < VITRINE_BLOCK_SIZE; ++x)
    {
      ivec2 pixel = corner + ivec2(x, y);
      sum += isInRegion(pixel) ? loadCount(pixel) : 0u;
    }
  }
  sums[block] = sum;
}
