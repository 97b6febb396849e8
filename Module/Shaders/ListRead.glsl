// Reads the lists that a fill pass has stored, from the first page of a list to its last. All pages but the first are
// full. The storage defines what a page is and which one is next.
//
// VITRINE_PACKED_LISTS  lists are successive nodes of a packed buffer; else linked pages of a pool
#include "SharedLayout.h"
#include "FragmentNode.glsl"

uniform usampler2D heads;
uniform usamplerBuffer nodes; // one texel for each node
#if VITRINE_NODE_WORDS == 3
uniform usamplerBuffer thirdWords;
#endif

#ifdef VITRINE_PACKED_LISTS
#include "PackedListRead.glsl"
#else
#include "LinkedListRead.glsl"
#endif

// Returns the words of a node.
uvec4 fetchNode(uint index)
{
  uvec4 node = texelFetch(nodes, int(index));
#if VITRINE_NODE_WORDS == 3
  node.z = texelFetch(thirdWords, int(index)).x;
#endif
  return node;
}

#ifndef VITRINE_IN_COMPUTE
// Returns the head of the pixel. Discards pixels without fragments.
uvec2 loadHeadToDraw(ivec2 pixel)
{
  uvec2 head = loadHead(pixel);
  if (head.y == 0u)
  {
    discard;
  }
  return head;
}

// The same for programs whose loops depend on the number of fragments. It is at most that of the buffer's nodes, even
// if the head is corrupt.
uvec2 loadHeadOfLongList(ivec2 pixel)
{
  uvec2 head = loadHeadToDraw(pixel);
  head.y = min(head.y, uint(textureSize(nodes)));
  return head;
}
#endif

// Returns the number of nodes in the first page of a list of `count` fragments.
int nodesInFirstPage(uint count)
{
  return int((count - 1u) & uint(VITRINE_PAGE_SIZE - 1)) + 1;
}

int pagesOfList(uint count)
{
  return int((count + uint(VITRINE_PAGE_SIZE - 1)) / uint(VITRINE_PAGE_SIZE));
}
