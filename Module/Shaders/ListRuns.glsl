// Divides a list into runs, which are sorted one by one and then merged. There are at most VITRINE_MAX_RUNS runs. A run
// is one block of VITRINE_RUN_PAGES pages, or several in long lists. The first run may be shorter.

// Returns the number of blocks of a list. The first block may have fewer pages.
int blocksOf(int pages)
{
  return (pages + VITRINE_RUN_PAGES - 1) / VITRINE_RUN_PAGES;
}

// Returns the number of pages in each run of a list, except the first.
int pagesOfRun(int pages)
{
  return (blocksOf(pages) + VITRINE_MAX_RUNS - 1) / VITRINE_MAX_RUNS * VITRINE_RUN_PAGES;
}

int pagesOfFirstRun(int pages)
{
  return (pages - 1) % pagesOfRun(pages) + 1;
}
