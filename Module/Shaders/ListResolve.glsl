// A-buffer, resolving lists of up to VITRINE_BIN nodes: load into named registers, sort by an
// unrolled network, composite.
//
// P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex Scenes, The Visual Computer 30
// (2014): sorting in registers, in bins by depth complexity.
#include "ListRead.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// Nodes of `page` are valid up to `filled`; the first page alone may be partly filled.
#define LOAD(f, slot) \
  { \
    uvec4 node = texelFetch(nodes, int(nodeIndex(page, uint(slot)))); \
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

  precise vec3 color = vec3(0.0);
  precise float transmittance = 1.0;
  //Vitrine::Blend
  BLEND_LIST

  writeOver(pixel, color, transmittance);
}
