// A-buffer, resolve pass for lists that are too long for VITRINE_MAX_RUNS runs of one network, first half. It divides
// the list into VITRINE_MAX_RUNS longer runs and sorts each in place, block by block. It reads and writes nodes.
//
// Each round walks over the rest of the run and keeps its nearest block in registers. It then stores that block where
// the walk began: a selection sort of blocks.
//
// It follows the register-based block sort of P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex
// Scenes, The Visual Computer 30 (2014). The merge is K. E. Batcher's bitonic merge, AFIPS 1968.
#define VITRINE_KEEP_EXTRA
#include "ListRead.glsl"
#include "ListRuns.glsl"
#include "Registers.glsl"
#define FETCH_NODE(index) loadNode(index)
#define NODE_ACCESS
#include "RunPages.glsl"

// Reads the images. A texel fetch might miss the nodes that this invocation stored.
uvec4 loadNode(uint index)
{
  uvec4 node = imageLoad(vitrineNodes, int(index));
#if VITRINE_NODE_WORDS == 3
  node.z = imageLoad(vitrineThirdWords, int(index)).x;
#endif
  return node;
}

void main()
{
  uvec2 head = loadHeadOfLongList(ivec2(gl_FragCoord.xy));

  //Vitrine::Declare

  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  int pages = pagesOfList(head.y);
  int absent = absentPages(pages);
  int blocksLeft = blocksOf(pagesOfFirstRun(pages));
  for (int left = blocksOf(pages); left > 0 && page != VITRINE_END; --left)
  {
    uint firstPage = page;
    int firstFilled = filled;
    int firstAbsent = absent;

    //Vitrine::ClearNearest

    // The first block becomes the nearest without a merge, and its place is free.
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
