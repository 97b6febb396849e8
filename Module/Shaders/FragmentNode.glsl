// A fragment as it is stored, a node, is VITRINE_NODE_WORDS words: the bits of its window depth and its colour (RGBA8 in
// one word or four 16-bit floats in two), or both in two words (CompactNode.glsl), and, where the target is
// multisampled, its coverage.

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
