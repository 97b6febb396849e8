// A-buffer, resolve pass for lists of up to VITRINE_BIN nodes. It reads a pixel's list into named registers, sorts it
// by an unrolled network, and writes the composited colour.
//
// P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex Scenes, The Visual Computer 30 (2014):
// sorting in registers, in bins by depth complexity.
//
// VITRINE_BLENDS_IN_TURN  each turn of a loop composites the first register, and moves all others down by one
#include "ListRead.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// The first `filled` nodes of `page` are valid. Only the first page may be partly filled.
#define LOAD(f, slot) \
  { \
    uvec4 node = fetchNode(nodeIndex(page, uint(slot))); \
    f = unpackNode(slot < filled && IN_SAMPLE(node), node); \
  }
#define NEXT_PAGE \
  page = filled > 0 ? nextPage(page) : VITRINE_END; \
  filled = page == VITRINE_END ? 0 : VITRINE_PAGE_SIZE; \
  page = filled > 0 ? page : 0u;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 head = loadHeadToDraw(pixel);

  //Vitrine::Declare

  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  //Vitrine::Load

  //Vitrine::Sort

  bool disordered;
  do
  {
    disordered = false;
    //Vitrine::OrderTies
  } while (disordered);

  DECLARE_COMPOSITE
#ifdef VITRINE_BLENDS_IN_TURN
  for (int turn = 0; f0.key != NO_KEY && turn < VITRINE_BIN; ++turn)
  {
    BLEND_NEXT(f0)
    //Vitrine::Advance
  }
#else
  //Vitrine::Blend
#endif
  BLEND_LIST

  WRITE_COMPOSITE
}
