// Loads a run's nodes into registers page by page, and stores them back in place. The nodes of a run then ascend from
// its first page to its last.
//
// A block of registers has VITRINE_RUN_PAGES pages. If the number of a list's pages is not a multiple, its first block
// has fewer. Only the first page may be partly filled.
//
// FETCH_NODE(index)  reads a node
// NODE_ACCESS        memory qualifiers of the nodes' buffers
#include "NodeImages.glsl"

#ifdef VITRINE_SORTS_PARTS
layout(r32ui, binding = VITRINE_IMAGE_PARTS) uniform uimageBuffer vitrineParts;
#define LOAD_PART(f, index) f.part = imageLoad(vitrineParts, int(index)).x;
#define STORE_PART(f, index) imageStore(vitrineParts, int(index), uvec4(f.part));
#else
#define LOAD_PART(f, index)
#define STORE_PART(f, index)
#endif

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
    uint index = nodeIndex(slot < 0 ? 0u : p.page, uint(max(slot, 0))); \
    uvec4 node = FETCH_NODE(index); \
    f = unpackNode(true, slot < 0 ? uvec4(0u) : node); \
    LOAD_PART(f, index) \
  }

#define STORE(f, p, i) \
  if (i >= p.empty) \
  { \
    storeNode(nodeIndex(p.page, uint(i - p.empty)), f); \
  }

void storeNode(uint index, Fragment f)
{
  STORE_PART(f, index)
#ifdef VITRINE_NODE_HAS_EXTRA
  uint extra = f.extra;
#else
  uint extra = 0u;
#endif
#ifdef VITRINE_HALF_FLOAT
  vitrineStoreWords(index, uvec4(f.key, f.redGreen, f.blueAlpha, extra));
#else
  vitrineStoreWords(index, uvec4(f.key, f.color, extra, 0u));
#endif
}

// Returns the number of pages missing from the first block of a list.
int absentPages(int pages)
{
  return (VITRINE_RUN_PAGES - pages % VITRINE_RUN_PAGES) % VITRINE_RUN_PAGES;
}
