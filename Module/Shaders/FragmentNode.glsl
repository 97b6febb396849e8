// The layout of a node, a stored fragment of VITRINE_NODE_WORDS words:
//
// depth   1 word       bits of the window depth; with a tolerance (Coincidence.glsl) the near end of the interval
// colour  1 or 2 words RGBA8, or four 16-bit floats (PackedColor.glsl)
// extra   0 or 1 word  coverage; with a tolerance always there: coverage and extent
//
// With VITRINE_COMPACT_NODES depth and colour share two words (CompactNode.glsl).
//
// Nodes are texels of buffer textures, which may be far larger than shader storage blocks. No format has three words,
// so the third word of such a node is in a second buffer.
//
// With VITRINE_PART_WORDS each node has a word more, in a buffer of its own: its part and side (PartRead.glsl).

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
