// Shell's sort with the gaps 2^p 3^q, with which an element moves one step at most in each pass.
//
// V. R. Pratt: Shellsort and Sorting Networks, Stanford 1972 (also Knuth, TAOCP 3, 5.2.1).
#include "SortHarness.glsl"

const int gaps[VITRINE_SHELL_GAP_COUNT] = int[](VITRINE_SHELL_GAPS); // descending

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
  for (int g = 0; g < VITRINE_SHELL_GAP_COUNT; ++g)
  {
    for (int i = 0; i + gaps[g] < count; ++i)
    {
      COMPARE_EXCHANGE_AT(i, i + gaps[g])
    }
  }
}
