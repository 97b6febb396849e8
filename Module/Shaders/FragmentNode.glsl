// A fragment as it is stored, a node, is VITRINE_NODE_WORDS words: the bits of its window depth and its colour (RGBA8 in
// one word or four 16-bit floats in two), or both in two words (CompactNode.glsl), and, where the target is
// multisampled, its coverage. With a tolerance for coincidence (Coincidence.glsl) the depth is the near end of an interval,
// and the last word is always there: coverage and extent.

#ifdef VITRINE_HALF_FLOAT
#define VITRINE_COLOR_WORDS 2
#else
#define VITRINE_COLOR_WORDS 1
#endif

#if VITRINE_SAMPLES > 0 || defined(VITRINE_COINCIDENCE)
#define VITRINE_NODE_HAS_EXTRA
#endif
#ifdef VITRINE_NODE_HAS_EXTRA
#define VITRINE_NODE_WORDS (2 + VITRINE_COLOR_WORDS)
#else
#define VITRINE_NODE_WORDS (1 + VITRINE_COLOR_WORDS)
#endif
