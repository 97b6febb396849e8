// A-buffer, lists of more than VITRINE_MAX_RUNS runs of VITRINE_RUN_SIZE nodes, first half: sort that many longer runs in
// place, block by block. Each round walks over what is left of the run, keeps its nearest block in registers, and puts
// it where the walk began: a selection sort of blocks.
//
// After the register-based block sort of P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of
// Complex Scenes, The Visual Computer 30 (2014); the merge is K. E. Batcher's bitonic one, AFIPS 1968.
#define VITRINE_KEEP_EXTRA
#include "ListRead.glsl"
#include "ListRuns.glsl"
#include "Registers.glsl"
#define FETCH_NODE(index) loadNode(index)
#define NODE_ACCESS
#include "RunPages.glsl"

// Not by texel, where what this invocation stored may not be seen.
uvec4 loadNode(uint index)
{
  uint word = index * uint(VITRINE_NODE_WORDS);
  uvec4 node = uvec4(nodeWords[word], nodeWords[word + 1u], 0u, 0u);
#if VITRINE_NODE_WORDS > 2
  node.z = nodeWords[word + 2u];
#endif
#if VITRINE_NODE_WORDS > 3
  node.w = nodeWords[word + 3u];
#endif
  return node;
}

void main()
{
  uvec2 head = loadHeadToDraw(ivec2(gl_FragCoord.xy));

  //Vitrine::Declare

  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  int pages = pagesOfList(head.y);
  int absent = absentPages(pages);
  int blocksLeft = blocksOf(pagesOfFirstRun(pages));
  while (page != VITRINE_END)
  {
    uint firstPage = page;
    int firstFilled = filled;
    int firstAbsent = absent;

    //Vitrine::ClearNearest

    // The first block becomes the nearest as it is, and its place is free.
    for (int block = 0; block < blocksLeft; ++block)
    {
      //Vitrine::Load

      //Vitrine::Sort

      //Vitrine::Merge

      //Vitrine::Store
    }

    page = firstPage;
    filled = firstFilled;
    absent = firstAbsent;
    //Vitrine::StoreNearest

    blocksLeft = blocksLeft > 1 ? blocksLeft - 1 : blocksOf(pagesOfRun(pages));
  }
}
