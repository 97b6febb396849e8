// A-buffer, resolving lists of any length, block by block: each round walks the whole list,
// sorts blocks of VITRINE_MERGE_BLOCK nodes by a network and merges each into the nearest block so far of
// what lies behind the last round's; then it composites that block. It needs registers only, no memory.
//
// After the register-based block sort of P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of
// Complex Scenes, The Visual Computer 30 (2014); the merge is K. E. Batcher's bitonic one, AFIPS 1968.
#include "ListRead.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// The walk: the node to read next, slot -1 at the end of the list.
uint page;
int slot;

// The farthest fragment composited so far, and how many equal to it were.
Fragment last;
uint lastDone = 0u;
uint lastSeen;

void startWalk(uvec2 head)
{
  page = head.x;
  slot = nodesInFirstPage(head.y) - 1;
  lastSeen = 0u;
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

// True if the fragment was not composited in an earlier round.
bool isLeft(Fragment f)
{
  bool same = sameFragment(f, last);
  lastSeen += same ? 1u : 0u;
  return f.key > last.key || (f.key == last.key && colorAbove(f, last)) || (same && lastSeen > lastDone);
}

#define LOAD(f) \
  { \
    bool there = slot >= 0; \
    uvec4 node = nextNode(); \
    f = unpackNode(there && IN_SAMPLE(node), node); \
    f = unpackNode(f.key != NO_KEY && isLeft(f), node); \
  }

#define COUNT_SAME(f) same += sameFragment(f, last) ? 1u : 0u;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 head = loadHeadToDraw(pixel);

  //Vitrine::Declare

  precise vec3 color = vec3(0.0);
  precise float transmittance = 1.0;
  bool more = true;
  last = unpackNode(true, uvec4(0u));
  while (more)
  {
    //Vitrine::ClearNearest

    startWalk(head);
    while (slot >= 0)
    {
      //Vitrine::LoadBlock

      //Vitrine::SortBlock

      //Vitrine::MergeBlock
    }

    //Vitrine::Blend

    // The block's last register is its farthest fragment; if it is empty the list is done.
    //Vitrine::LastOfBlock
    more = blockLast.key != NO_KEY;
    uint same = sameFragment(blockLast, last) ? lastDone : 0u;
    last = blockLast;
    //Vitrine::CountSame
    lastDone = same;
  }

  writeOver(pixel, color, transmittance);
}
