// Packed lists, compute shader: the way down of the prefix sum. It reads the places of the next level and replaces the
// sums of this level by places.
#include "ScanBlocks.glsl"

uniform int level;
uniform int count;
uniform int nextLevel;
uniform int nextIsTotal; // 1 if the next level is the sum of all, whose place is 0

void main()
{
  FOR_ONE_OF(i, (count + VITRINE_SCAN_FANOUT - 1) / VITRINE_SCAN_FANOUT)
  int end = min((i + 1) * VITRINE_SCAN_FANOUT, count);
  uint place = nextIsTotal == 1 ? 0u : sums[nextLevel + i];
  for (int k = i * VITRINE_SCAN_FANOUT; k < end; ++k)
  {
    uint sum = sums[level + k];
    sums[level + k] = place;
    place = addSaturating(place, sum);
  }
}
