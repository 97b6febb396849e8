// A-buffer, resolve pass for lists that are too long for one network, second half. It reads the sorted runs of
// ListSortRuns.glsl or ListSortLongRuns.glsl, merges them all at once, and writes the composited colour. The nearest
// fragment of each run is in registers.
//
// Runs are in groups, and each group knows its nearest run. So a fragment costs a look at the groups and at the runs of
// one group: a tournament of two rounds. Neighbouring pixels mostly take fragments from the same group.
#define VITRINE_KEEP_EXTRA
#include "ListRead.glsl"
#include "ListRuns.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// A run in the merge: its nearest remaining fragment, and the position of the fragment after that. The fields of
// `place`, from the lowest bit on:
//
//   4 bits   slot in the page
//   4 bits   number of nodes in the page
//   19 bits  number of pages left, including this one
//   5 bits   number of the run
struct Run
{
  Fragment head;
  uint page;
  uint place;
};
#define PLACE(slot, filled, left, number) \
  (uint(slot) | (uint(filled) << 4) | ((uint(left) & VITRINE_MOST_PAGES) << 8) | (uint(number) << 27))
#define VITRINE_MOST_PAGES 0x7ffffu

#define DECLARE_RUN(r) Run r; r.head = unpackNode(false, uvec4(0u)); r.page = VITRINE_END; r.place = 0u;

// Returns run a if s is true, else run b. It uses selects, since branches are slower in a software rasteriser.
Run selectRun(bool s, Run a, Run b)
{
  Run r;
  r.head = selectFragment(s, a.head, b.head);
  r.page = s ? a.page : b.page;
  r.place = s ? a.place : b.place;
  return r;
}

// Makes a the run with the nearer first fragment.
#define TAKE_NEARER(a, b) \
  a = selectRun(b.head.key < a.head.key || (b.head.key == a.head.key && colorAbove(a.head, b.head)), b, a);

#define PUT_BACK(r, i) r = selectRun(number == i, run, r);

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 head = loadHeadOfLongList(pixel);

  //Vitrine::Declare

  // The next run to start: `runPages` pages from `page` on.
  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  int pages = pagesOfList(head.y);
  int runPages = pagesOfFirstRun(pages);
  uint started = 0u;

  DECLARE_COMPOSITE
  // A turn starts a run or takes a fragment, and the last one finds none. So a link that leads back loops no longer.
  uint turnsLeft = head.y + uint(VITRINE_MAX_RUNS) + 1u;
  while (turnsLeft-- > 0u)
  {
    Run run;
    if (page != VITRINE_END)
    {
      run.page = page;
      run.place = PLACE(0, filled, runPages, started);
      ++started;
      for (int i = 0; i < runPages; ++i)
      {
        page = nextPage(page);
      }
      filled = VITRINE_PAGE_SIZE;
      runPages = pagesOfRun(pages);
    }
    else
    {
      //Vitrine::FindNearest
      if (run.head.key == NO_KEY)
      {
        break;
      }
      if (FRAGMENT_IN_SAMPLE(run.head))
      {
        BLEND_NEXT(run.head)
      }
    }

    // Advance the run by one fragment.
    bool valid = run.page != VITRINE_END;
    uint slot = run.place & 0xfu;
    uint left = (run.place >> 8) & VITRINE_MOST_PAGES;
    uint number = run.place >> 27;
    uvec4 node = fetchNode(nodeIndex(valid ? run.page : 0u, slot));
    bool pageDone = slot + 1u == ((run.place >> 4) & 0xfu);
    uint next = pageDone && left > 1u ? nextPage(valid ? run.page : 0u) : VITRINE_END;
    run.page = valid && pageDone ? next : run.page;
    run.place = pageDone ? PLACE(0, VITRINE_PAGE_SIZE, left - 1u, number) : run.place + 1u;
    run.head = unpackNode(valid, node);
    //Vitrine::PutBack
  }
  BLEND_REST

  WRITE_COMPOSITE
}
