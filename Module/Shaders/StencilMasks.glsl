// What the groups of the stencil masks hold.
//
// VITRINE_GROUP ivec2(w, h)  pixels of the larger target that take the layers of one pixel

// The depth of a place without a fragment; depths in view space end far below.
#define VITRINE_NO_DEPTH 3.0e38
