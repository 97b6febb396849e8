// How a list is cut into runs that are sorted, each by itself, and then merged: at most VITRINE_MAX_RUNS of them, of one
// block of VITRINE_RUN_PAGES pages or, in long lists, of several. The first run may be shorter.

// The blocks of so many pages, of which the first may have fewer.
int blocksOf(int pages)
{
  return (pages + VITRINE_RUN_PAGES - 1) / VITRINE_RUN_PAGES;
}

// The pages of a run in a list of so many pages.
int pagesOfRun(int pages)
{
  return (blocksOf(pages) + VITRINE_MAX_RUNS - 1) / VITRINE_MAX_RUNS * VITRINE_RUN_PAGES;
}

int pagesOfFirstRun(int pages)
{
  return (pages - 1) % pagesOfRun(pages) + 1;
}
