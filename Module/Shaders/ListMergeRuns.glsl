// A-buffer, lists too long for one network, second half: merge the runs that ListSortRuns.glsl or ListSortLongRuns.glsl
// sorted, all at once, with each run's nearest fragment in registers, and composite on the way.
//
// The runs are in groups, each of which knows its nearest run. So a fragment costs a look at the groups and at
// the runs of one group: a tournament of two rounds. Neighbouring pixels mostly take from the same group.
#define VITRINE_KEEP_EXTRA
#include "ListRead.glsl"
#include "ListRuns.glsl"
#include "Registers.glsl"
#include "ResolveOutput.glsl"

// A run being merged: its nearest fragment left, and where the one after that is. `place` holds, from the lowest
// bits on: the slot in the page, the nodes in the page, the pages left, this one included, and the run's number.
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

// Run a where s holds, else run b: selects, since a software rasteriser pays more for branches.
Run selectRun(bool s, Run a, Run b)
{
  Run r;
  r.head = selectFragment(s, a.head, b.head);
  r.page = s ? a.page : b.page;
  r.place = s ? a.place : b.place;
  return r;
}

// Make a the run whose nearest fragment is the nearer.
#define TAKE_NEARER(a, b) \
  a = selectRun(b.head.key < a.head.key || (b.head.key == a.head.key && colorAbove(a.head, b.head)), b, a);

#define PUT_BACK(r, i) r = selectRun(number == i, run, r);

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 head = loadHeadToDraw(pixel);

  //Vitrine::Declare

  // The next run of the list to start: `runPages` pages from `page`.
  uint page = head.x;
  int filled = nodesInFirstPage(head.y);
  int pages = pagesOfList(head.y);
  int runPages = pagesOfFirstRun(pages);
  uint started = 0u;

  precise vec3 color = vec3(0.0);
  precise float transmittance = 1.0;
  while (true)
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
    uvec4 node = texelFetch(nodes, int(nodeIndex(valid ? run.page : 0u, slot)));
    bool pageDone = slot + 1u == ((run.place >> 4) & 0xfu);
    uint next = pageDone && left > 1u ? nextPage(valid ? run.page : 0u) : VITRINE_END;
    run.page = valid && pageDone ? next : run.page;
    run.place = pageDone ? PLACE(0, VITRINE_PAGE_SIZE, left - 1u, number) : run.place + 1u;
    run.head = unpackNode(valid, node);
    //Vitrine::PutBack
  }
  BLEND_REST

  writeOver(pixel, color, transmittance);
}
