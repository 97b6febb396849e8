// Sorts many short lists, one in each pixel: loads the pixel's list into an array, sorts it by depth, and reads it in
// order. Each Sort*.glsl defines a sort; this file gives all of them the same input and output. The output is the
// list itself with VITRINE_SORT_STORE, else its checksum (study/sorts/ListChecksum), which takes far less time.
//
// To be timed, a list is sorted several times, each time anew from what was loaded and with other bits of its keys
// flipped, so that they come in another order: loading takes longer than a small network.
//
// The lists are interleaved, so that neighbouring pixels read and write neighbouring words: element i of list l stands
// at i * listCount + l. Behind its end a list is filled up with NO_KEY.
#include "SharedLayout.h"
#include "SortLayout.h"
#include "Registers.glsl"

uniform usamplerBuffer lists;   // key, payload
uniform usamplerBuffer lengths;
uniform int listCount;
uniform int repeats;

#ifdef VITRINE_SORT_STORE
layout(std430, binding = VITRINE_BINDING_CAPTURE) writeonly buffer SortedBuffer
{
  uvec2 sortedLists[];
};
#else
layout(location = 0) out uvec2 checksum;
#endif

// Sort list[0] to list[count - 1] by key, nearest first. All behind them have NO_KEY.
void vitrineSort(inout Fragment list[VITRINE_SORT_SIZE], int count);

// Order elements i and j of the list, i first.
#define COMPARE_EXCHANGE_AT(i, j) \
  { \
    Fragment a = list[i]; \
    Fragment b = list[j]; \
    COMPARE_EXCHANGE(a, b) \
    list[i] = a; \
    list[j] = b; \
  }

// The k-th index, counted from 0, whose bit `stride` is not set.
int indexWithoutBit(int k, int stride)
{
  return 2 * k - (k & (stride - 1));
}

#define LOAD(i) loaded[i] = unpackNode(true, texelFetch(lists, i * listCount + number));
#define TAKE(i) list[i] = loaded[i]; list[i].key ^= loaded[i].key == NO_KEY ? 0u : flipped;
#ifdef VITRINE_SORT_STORE
#define STORE(i) sortedLists[i * listCount + number] = uvec2(list[i].key, list[i].color);
#else
#define STORE(i) \
  checksum = uvec2(checksum.x * VITRINE_CHECKSUM_FACTOR + list[i].key, \
    checksum.y + (list[i].key + VITRINE_CHECKSUM_KEY) * (list[i].color + VITRINE_CHECKSUM_PAYLOAD));
#endif

void main()
{
  int number = int(gl_FragCoord.y) * VITRINE_SORT_ROW + int(gl_FragCoord.x);
  int count = int(texelFetch(lengths, number).x);

  Fragment loaded[VITRINE_SORT_SIZE];
  Fragment list[VITRINE_SORT_SIZE];
  //Vitrine::Load
#ifndef VITRINE_SORT_STORE
  checksum = uvec2(0u);
#endif
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    uint flipped = uint(repeat) * VITRINE_CHECKSUM_FACTOR & 0x7fffffffu;
    //Vitrine::Take
    vitrineSort(list, count);
    //Vitrine::Store
  }
}
