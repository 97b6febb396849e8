// Sums of the next level: each of VITRINE_SCAN_FANOUT of this one.
#include "ScanBlocks.glsl"

uniform int level;     // where this level's sums begin
uniform int count;     // how many they are
uniform int nextLevel; // where the next level's begin

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
