// The smallest known sorting network, unrolled: every index is a constant, so the list needs no memory.
#include "SortHarness.glsl"

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
  //Vitrine::Network
}
