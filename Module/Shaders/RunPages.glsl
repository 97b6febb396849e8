// Loads a run's nodes into registers page by page, and stores them back in place. The nodes of a run then ascend from
// its first page to its last.
//
// A block of registers has VITRINE_RUN_PAGES pages. If the number of a list's pages is not a multiple, its first block
// has fewer. Only the first page may be partly filled.
//
// FETCH_NODE(index)  reads a node
// NODE_ACCESS        memory qualifiers of the buffer

layout(std430, binding = VITRINE_BINDING_NODES) NODE_ACCESS buffer NodeBuffer
{
  uint nodeWords[];
};

// The fragments of a page are in its last registers. The first `empty` registers have none.
struct RunPage
{
  uint page;
  int empty;
};

#define DECLARE_PAGE(p) RunPage p;

// Takes the next page of the list, or no page while `absent` pages are missing from the first block.
#define TAKE_PAGE(p) \
  p.page = absent > 0 ? VITRINE_END : page; \
  p.empty = p.page == VITRINE_END ? VITRINE_PAGE_SIZE : VITRINE_PAGE_SIZE - filled; \
  if (p.page != VITRINE_END) \
  { \
    page = nextPage(page); \
    filled = VITRINE_PAGE_SIZE; \
  } \
  --absent;

// Registers without a fragment sort first, so they stay where they were loaded.
#define LOAD(f, p, i) \
  { \
    int slot = i - p.empty; \
    uvec4 node = FETCH_NODE(nodeIndex(slot < 0 ? 0u : p.page, uint(max(slot, 0)))); \
    f = unpackNode(true, slot < 0 ? uvec4(0u) : node); \
  }

#define STORE(f, p, i) \
  if (i >= p.empty) \
  { \
    storeNode(nodeIndex(p.page, uint(i - p.empty)), f); \
  }

void storeNode(uint index, Fragment f)
{
  uint word = index * uint(VITRINE_NODE_WORDS);
  nodeWords[word] = f.key;
#ifdef VITRINE_HALF_FLOAT
  nodeWords[word + 1u] = f.redGreen;
  nodeWords[word + 2u] = f.blueAlpha;
#else
  nodeWords[word + 1u] = f.color;
#endif
#ifdef VITRINE_NODE_HAS_EXTRA
  nodeWords[word + uint(VITRINE_NODE_WORDS) - 1u] = f.extra;
#endif
}

// Returns the number of pages missing from the first block of a list.
int absentPages(int pages)
{
  return (VITRINE_RUN_PAGES - pages % VITRINE_RUN_PAGES) % VITRINE_RUN_PAGES;
}
