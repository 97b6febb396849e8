// A-buffer, resolve pass for lists that are too long for one network, first half. It sorts runs of VITRINE_RUN_SIZE
// nodes in place, each by a network over registers. It reads and writes nodes.
//
// P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex Scenes, The Visual Computer 30 (2014):
// sorted blocks go back to the list's own nodes.
#define VITRINE_KEEP_EXTRA
#include "ListRead.glsl"
#include "ListRuns.glsl"
#include "Registers.glsl"
#define FETCH_NODE(index) fetchNode(index)
#define NODE_ACCESS writeonly
#include "RunPages.glsl"

void main()
{
  uvec2 head = loadHeadOfLongList(ivec2(gl_FragCoord.xy));

  //Vitrine::Declare

  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  int pages = pagesOfList(head.y);
  int absent = absentPages(pages);
  for (int left = blocksOf(pages); left > 0 && page != VITRINE_END; --left)
  {
    //Vitrine::Load

    //Vitrine::Sort

    //Vitrine::Store
  }
}
