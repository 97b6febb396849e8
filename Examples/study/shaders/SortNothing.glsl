// What it takes to load and store the lists: the floor under every sort's time.
#include "SortHarness.glsl"

void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count)
{
}
