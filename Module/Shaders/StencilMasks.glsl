// Constants that the resolve, mark and repair passes of stencil masks share.
//
// VITRINE_GROUP ivec2(w, h)  pixels of the larger target that take the layers of one pixel

// The depth of a place without a fragment. It is far beyond all depths in view space.
#define VITRINE_NO_DEPTH 3.0e38

// The number of neighbours, of 8, with which a failing test counts as failed.
#define VITRINE_MARK_NEIGHBOURS 7.0

// The least error that is repaired, and the error of a pixel that fails every test.
#define VITRINE_MARKED 1.25
#define VITRINE_MOST_ERROR 1.5

// The weight of neighbours that are worse than the best.
#define VITRINE_WORSE_NEIGHBOUR 0.3
