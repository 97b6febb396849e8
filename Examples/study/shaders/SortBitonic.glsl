// Batcher's bitonic sort, of as many elements as the next power of two: those behind the list's end have NO_KEY.
//
// K. E. Batcher: Sorting networks and their applications. AFIPS 1968.
#include "SortHarness.glsl"

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
  int size = 1;
  while (size < count)
  {
    size *= 2;
  }
  for (int run = 2; run <= size; run *= 2)
  {
    for (int stride = run / 2; stride > 0; stride /= 2)
    {
      for (int k = 0; k < size / 2; ++k)
      {
        int i = indexWithoutBit(k, stride);
        bool descends = (i & run) != 0;
        int nearer = descends ? i + stride : i;
        int farther = descends ? i : i + stride;
        COMPARE_EXCHANGE_AT(nearer, farther)
      }
    }
  }
}
