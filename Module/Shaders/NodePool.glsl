// The node pool: pages of VITRINE_PAGE_SIZE nodes, linked per pixel from the newest page to the oldest.
//
// A node is VITRINE_NODE_WORDS words: the bits of its window depth, its colour (RGBA8 in one word or
// four 16-bit floats in two), and, where the target is multisampled, its coverage.

#ifdef VITRINE_HALF_FLOAT
#define VITRINE_COLOR_WORDS 2
#else
#define VITRINE_COLOR_WORDS 1
#endif

#if VITRINE_SAMPLES > 0
#define VITRINE_NODE_WORDS (2 + VITRINE_COLOR_WORDS)
#else
#define VITRINE_NODE_WORDS (1 + VITRINE_COLOR_WORDS)
#endif

// Where node `slot` of `page` lies in the pool, in nodes.
uint vitrineNodeIndex(uint page, uint slot, uint pageSize)
{
  uint group = page >> VITRINE_INTERLEAVE_SHIFT;
  uint lane = page & ((1u << VITRINE_INTERLEAVE_SHIFT) - 1u);
  return ((group * pageSize + slot) << VITRINE_INTERLEAVE_SHIFT) + lane;
}
