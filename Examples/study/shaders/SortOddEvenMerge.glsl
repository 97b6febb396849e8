// Batcher's odd-even merge sort for any number of elements.
//
// K. E. Batcher: Sorting networks and their applications. AFIPS 1968; D. E. Knuth, The Art of Computer Programming 3,
// 5.2.2, Algorithm M, whose letters these are.
#include "SortHarness.glsl"

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
  int top = 1;
  while (2 * top < count)
  {
    top *= 2;
  }
  for (int p = top; p > 0; p /= 2)
  {
    int r = 0;
    int d = p;
    for (int q = top; q >= p; q /= 2)
    {
      // All i with (i & p) == r.
      for (int k = 0; indexWithoutBit(k, p) + r + d < count; ++k)
      {
        int i = indexWithoutBit(k, p) + r;
        COMPARE_EXCHANGE_AT(i, i + d)
      }
      d = q - p;
      r = p;
    }
  }
}
