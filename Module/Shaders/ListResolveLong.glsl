// A-buffer, resolving lists of any length, block by block.
//
// P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex Scenes, The Visual Computer 30 (2014).
#include "ListRead.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// The walk over the list: the node to read next, slot -1 at its end.
uvec2 head;
uint page;
int slot;

void startWalk()
{
  page = head.x;
  slot = nodesInFirstPage(head.y) - 1;
}

bool isWalking()
{
  return slot >= 0;
}

uvec4 nextNode()
{
  uvec4 node = texelFetch(nodes, int(nodeIndex(page, uint(max(slot, 0)))));
  --slot;
  if (slot == -1)
  {
    uint before = nextPage(page);
    slot = before == VITRINE_END ? -1 : VITRINE_PAGE_SIZE - 1;
    page = before == VITRINE_END ? page : before;
  }
  return node;
}

#define NEXT_FRAGMENT(f) \
  { \
    bool there = isWalking(); \
    uvec4 node = nextNode(); \
    f = unpackNode(there && IN_SAMPLE(node), node); \
  }

#include "CompositeBlocks.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  head = loadHeadToDraw(pixel);
  precise vec3 color;
  precise float transmittance;
  compositeBlocks(color, transmittance);
  writeOver(pixel, color, transmittance);
}
