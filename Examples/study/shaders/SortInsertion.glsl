// Insertion sort (Knuth, The Art of Computer Programming 3, 5.2.1, Algorithm S).
#include "SortHarness.glsl"

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
  for (int i = 1; i < count; ++i)
  {
    Fragment f = list[i];
    int place = i;
    while (place > 0)
    {
      Fragment before = list[place - 1];
      if (before.key <= f.key)
      {
        break;
      }
      list[place] = before;
      --place;
    }
    list[place] = f;
  }
}
