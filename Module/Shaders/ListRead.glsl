// Reading the lists of fragments that a fill has stored: walks from a list's first page to its last, each but the
// first full. What a page is and where the next one lies is the storage's affair.
//
// VITRINE_PACKED_LISTS  lists are successive nodes of a packed buffer; else linked pages of a pool
#include "SharedLayout.h"
#include "FragmentNode.glsl"

uniform usampler2D heads;
uniform usamplerBuffer nodes; // one texel a node

#ifdef VITRINE_PACKED_LISTS
#include "PackedListRead.glsl"
#else
#include "LinkedListRead.glsl"
#endif

// The head of the pixel that is drawn, which is left as it is where it has no fragments.
uvec2 loadHeadToDraw(ivec2 pixel)
{
  uvec2 head = loadHead(pixel);
  if (head.y == 0u)
  {
    discard;
  }
  return head;
}

// Nodes in the first page of a list of `count` fragments.
int nodesInFirstPage(uint count)
{
  return int((count - 1u) & uint(VITRINE_PAGE_SIZE - 1)) + 1;
}

int pagesOfList(uint count)
{
  return int((count + uint(VITRINE_PAGE_SIZE - 1)) / uint(VITRINE_PAGE_SIZE));
}
