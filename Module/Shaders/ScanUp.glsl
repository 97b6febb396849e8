// Packed lists, compute shader: the way up of the prefix sum. It reads the sums of this level and writes the next
// level, each the sum of VITRINE_SCAN_FANOUT.
#include "ScanBlocks.glsl"

uniform int level;     // start of this level's sums
uniform int count;     // number of this level's sums
uniform int nextLevel; // start of the next level's sums

void main()
{
  FOR_ONE_OF(i, (count + VITRINE_SCAN_FANOUT - 1) / VITRINE_SCAN_FANOUT)
  int end = min((i + 1) * VITRINE_SCAN_FANOUT, count);
  uint sum = 0u;
  for (int k = i * VITRINE_SCAN_FANOUT; k < end; ++k)
  {
    sum = addSaturating(sum, sums[level + k]);
  }
  sums[nextLevel + i] = sum;
}
