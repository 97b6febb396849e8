// What the resolve of stencil masks and the repair of its defects share.
//
// VITRINE_GROUP ivec2(w, h)  pixels of the larger target that take the layers of one pixel

// The depth of a place without a fragment; depths in view space end far below.
#define VITRINE_NO_DEPTH 3.0e38

// A test between neighbours fails where it does with so many of the 8.
#define VITRINE_MARK_NEIGHBOURS 7.0

// Errors from here on are repaired, and the error of a pixel that fails every test.
#define VITRINE_MARKED 1.25
#define VITRINE_MOST_ERROR 1.5

// The weight of neighbours that are worse than the best.
#define VITRINE_WORSE_NEIGHBOUR 0.3
