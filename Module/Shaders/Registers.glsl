// Fragments in named registers, and the operations of a sort on them. A register without a fragment sorts last and
// blends as nothing.
//
// VITRINE_COMPACT_NODES  keys and colours are the words of CompactNode.glsl
// VITRINE_FLOAT_KEYS     keys are depths, for GLSL versions without access to the bits of a float; else their bits
// VITRINE_FLOAT_COLORS   colours are floats; else they are packed, with the same order
#include "FineColor.glsl"
#ifdef VITRINE_COMPACT_NODES
#include "CompactNode.glsl"
#else
#include "PackedColor.glsl"
#endif

#ifdef VITRINE_FLOAT_KEYS
#define KEY float
#define NO_KEY VITRINE_NO_DEPTH
#define PRECISE
#else
#define KEY uint
#define PRECISE precise
#ifdef VITRINE_COMPACT_NODES
#define NO_KEY 0xffffffc0u // no depth, and an alpha of 0
#else
#define NO_KEY 0xffffffffu
#endif
#endif

#ifdef VITRINE_FLOAT_COLORS
#define COLOR vec4
#define NO_COLOR vec4(0.0)
#else
#define COLOR uint
#define NO_COLOR 0u
#endif

// VITRINE_KEEP_EXTRA   if the target is multisampled, registers carry the node's last word, too
// VITRINE_ALL_SAMPLES  likewise, since the list is composited into all samples of a pixel at once
// VITRINE_COINCIDENCE  they always carry it; of fragments of equal depth and colour, the larger word is farther
#if defined(VITRINE_COINCIDENCE) || defined(VITRINE_ALL_SAMPLES) || (defined(VITRINE_KEEP_EXTRA) && VITRINE_SAMPLES > 0)
#define EXTRA_MEMBER uint extra;
#define EXCHANGE_EXTRA(a, b, s) \
  { \
    uint t = s ? b.extra : a.extra; b.extra = s ? a.extra : b.extra; a.extra = t; \
  }
#define SET_EXTRA(f, node) f.extra = nodeExtra(node);
#define SELECT_EXTRA(f, s, a, b) f.extra = s ? a.extra : b.extra;
#else
#define EXTRA_MEMBER
#define EXCHANGE_EXTRA(a, b, s)
#define SET_EXTRA(f, node)
#define SELECT_EXTRA(f, s, a, b)
#endif
// VITRINE_SORTS_PARTS  registers carry the words of parts, since nodes are sorted in place. Of fragments that are equal
//                      otherwise, the larger word is farther.
#ifdef VITRINE_SORTS_PARTS
#define PART_MEMBER uint part;
#define EXCHANGE_PART(a, b, s) \
  { \
    uint t = s ? b.part : a.part; b.part = s ? a.part : b.part; a.part = t; \
  }
#define CLEAR_PART(f) f.part = 0u;
#define SELECT_PART(f, s, a, b) f.part = s ? a.part : b.part;
#else
#define PART_MEMBER
#define EXCHANGE_PART(a, b, s)
#define CLEAR_PART(f)
#define SELECT_PART(f, s, a, b)
#endif
#ifdef VITRINE_COINCIDENCE
#define OR_EXTRA_ABOVE(same, a, b) || (same && a.extra > b.extra)
#define AND_SAME_EXTRA(a, b) && a.extra == b.extra
#else
#define OR_EXTRA_ABOVE(same, a, b)
#define AND_SAME_EXTRA(a, b)
#endif

#ifdef VITRINE_HALF_FLOAT

struct Fragment
{
  KEY key;         // bits of the window depth
  uint redGreen;   // as packed by PackedColor.glsl
  uint blueAlpha;
  EXTRA_MEMBER
  PART_MEMBER
};

uint nodeExtra(uvec4 node)
{
  return node.w;
}
Fragment unpackNode(bool valid, uvec4 node)
{
  Fragment f;
  f.key = valid ? node.x : NO_KEY;
  f.redGreen = valid ? node.y : 0u;
  f.blueAlpha = valid ? node.z : 0u;
  SET_EXTRA(f, node)
  CLEAR_PART(f)
  return f;
}
vec4 fragmentColor(Fragment f)
{
  return vitrineUnpackColor(uvec2(f.redGreen, f.blueAlpha));
}
bool packedAbove(Fragment a, Fragment b)
{
  return a.blueAlpha > b.blueAlpha || (a.blueAlpha == b.blueAlpha && a.redGreen > b.redGreen)
    OR_EXTRA_ABOVE(a.blueAlpha == b.blueAlpha && a.redGreen == b.redGreen, a, b);
}
#ifdef VITRINE_FINE_COLORS
uint coarseBlueAlpha(Fragment f)
{
  return (f.blueAlpha + VITRINE_COARSE_ALPHA_COLOR_ROUNDING) & VITRINE_COARSE_ALPHA_COLOR_MASK;
}
uint coarseRedGreen(Fragment f)
{
  return (f.redGreen + VITRINE_COARSE_COLORS_ROUNDING) & VITRINE_COARSE_COLORS_MASK;
}
bool colorAbove(Fragment a, Fragment b)
{
  uvec2 coarseA = uvec2(coarseBlueAlpha(a), coarseRedGreen(a));
  uvec2 coarseB = uvec2(coarseBlueAlpha(b), coarseRedGreen(b));
  return coarseA.x > coarseB.x ||
    (coarseA.x == coarseB.x && (coarseA.y > coarseB.y || (coarseA.y == coarseB.y && packedAbove(a, b))));
}
#else
#define colorAbove(a, b) packedAbove(a, b)
#endif
Fragment selectFragment(bool s, Fragment a, Fragment b)
{
  Fragment f;
  f.key = s ? a.key : b.key;
  f.redGreen = s ? a.redGreen : b.redGreen;
  f.blueAlpha = s ? a.blueAlpha : b.blueAlpha;
  SELECT_EXTRA(f, s, a, b)
  SELECT_PART(f, s, a, b)
  return f;
}
bool sameFragment(Fragment a, Fragment b)
{
  return a.key == b.key && a.redGreen == b.redGreen && a.blueAlpha == b.blueAlpha AND_SAME_EXTRA(a, b);
}

#define EXCHANGE_COLOR(a, b, s) \
  { \
    uint t = s ? b.redGreen : a.redGreen; b.redGreen = s ? a.redGreen : b.redGreen; a.redGreen = t; \
    t = s ? b.blueAlpha : a.blueAlpha; b.blueAlpha = s ? a.blueAlpha : b.blueAlpha; a.blueAlpha = t; \
    EXCHANGE_EXTRA(a, b, s) \
    EXCHANGE_PART(a, b, s) \
  }

#else

struct Fragment
{
  KEY key;     // depth
  COLOR color; // packed by PackedColor.glsl, or as floats
  EXTRA_MEMBER
  PART_MEMBER
};

#ifndef VITRINE_FLOAT_KEYS
uint nodeExtra(uvec4 node)
{
  return node.z;
}
Fragment unpackNode(bool valid, uvec4 node)
{
  Fragment f;
  f.key = valid ? node.x : NO_KEY;
  f.color = valid ? node.y : 0u;
  SET_EXTRA(f, node)
  CLEAR_PART(f)
  return f;
}
#endif
#ifdef VITRINE_FLOAT_COLORS
vec4 fragmentColor(Fragment f)
{
  return f.color;
}
bool colorAbove(Fragment a, Fragment b)
{
  vec4 above = step(0.0, a.color - b.color) - step(0.0, b.color - a.color);
  return dot(above, vec4(1.0, 2.0, 4.0, 8.0)) > 0.0;
}
#else
vec4 fragmentColor(Fragment f)
{
#ifdef VITRINE_COMPACT_NODES
  return vitrineUnpackNodeColor(uvec2(f.key, f.color));
#else
  return vitrineUnpackColor(f.color);
#endif
}
bool colorAbove(Fragment a, Fragment b)
{
  return a.color > b.color OR_EXTRA_ABOVE(a.color == b.color, a, b);
}
#endif
Fragment selectFragment(bool s, Fragment a, Fragment b)
{
  Fragment f;
  f.key = s ? a.key : b.key;
  f.color = s ? a.color : b.color;
  SELECT_EXTRA(f, s, a, b)
  SELECT_PART(f, s, a, b)
  return f;
}
bool sameFragment(Fragment a, Fragment b)
{
  return a.key == b.key && a.color == b.color AND_SAME_EXTRA(a, b);
}

#define EXCHANGE_COLOR(a, b, s) \
  { \
    COLOR t = s ? b.color : a.color; b.color = s ? a.color : b.color; a.color = t; \
    EXCHANGE_EXTRA(a, b, s) \
    EXCHANGE_PART(a, b, s) \
  }

#endif

#define DECLARE(f) Fragment f;
#define MOVE(to, from) to = from;
#ifdef VITRINE_FLOAT_KEYS
#define CLEAR(f) f.key = NO_KEY; f.color = NO_COLOR;
#else
#define CLEAR(f) f = unpackNode(false, uvec4(0u));
#endif

// Exchanges a and b if s is true. s must be true if b is nearer.
#define EXCHANGE(a, b, s) \
  { \
    KEY near = min(a.key, b.key); b.key = max(a.key, b.key); a.key = near; \
    EXCHANGE_COLOR(a, b, s) \
  }

// Orders a and b by depth only.
#define COMPARE_EXCHANGE(a, b) \
  { \
    bool s = a.key > b.key; \
    EXCHANGE(a, b, s) \
  }

// Orders a and b by depth, and by colour if the depths are equal.
#define COMPARE_EXCHANGE_FULL(a, b) \
  { \
    bool s = a.key > b.key || (a.key == b.key && colorAbove(a, b)); \
    EXCHANGE(a, b, s) \
  }

// Orders a and b, which are neighbours after a sort by depth, by colour if their depths are equal.
#define ORDER_TIE(a, b) \
  { \
    bool s = a.key == b.key && colorAbove(a, b); \
    disordered = disordered || s; \
    EXCHANGE_COLOR(a, b, s) \
  }

// VITRINE_ADDITIVE: a colour of alpha 0 is premultiplied and additive.
#ifdef VITRINE_ADDITIVE
#define COLOR_WEIGHT(c) (c.a > 0.0 ? c.a : 1.0)
#else
#define COLOR_WEIGHT(c) c.a
#endif

// Composites front to back. `color` is premultiplied, `transmittance` is the share of light from behind. Both are
// precise, so all programs composite the same list to the same bits.
#define BLEND_COLOR(c) \
  { \
    color += transmittance * COLOR_WEIGHT(c) * c.rgb; \
    transmittance -= transmittance * c.a; \
  }

// DECLARE_COMPOSITE declares `color` and `transmittance`. BLEND composites the fragment of a register, and BLEND_LIST
// completes all registers. BLEND_NEXT composites the next fragment of a list, and BLEND_REST completes the list. With
// VITRINE_BLENDS_IN_TURN, BLEND_LIST is BLEND_REST.
//
// VITRINE_ERROR_BOUND  the error of the composite is bounded along with it. It excludes VITRINE_ALL_SAMPLES and
//                      VITRINE_COINCIDENCE.
// VITRINE_HIDDEN_DEPTHS  the depth behind which a pixel hides all is found along with these
#ifdef VITRINE_ERROR_BOUND
#include "ErrorBound.glsl"
#else
#define DECLARE_BOUND
#define TAKE_BOUND(f, c)
#define TELL_BOUND(pixel, behind)
#endif
#ifdef VITRINE_HIDDEN_DEPTHS
#include "HiddenDepth.glsl"
#else
#define DECLARE_HIDDEN
#define TAKE_HIDDEN(f, c)
#define TELL_HIDDEN(pixel)
#endif
#ifdef VITRINE_ALL_SAMPLES
#include "SampleBlend.glsl"
#else
#define DECLARE_COMPOSITE \
  precise vec3 color = vec3(0.0); \
  precise float transmittance = 1.0; \
  DECLARE_HIDDEN \
  DECLARE_BOUND
#endif
#ifdef VITRINE_COINCIDENCE
#include "CoincidentGroup.glsl"
#else
#ifndef VITRINE_ALL_SAMPLES
#define BLEND(f) \
  { \
    vec4 c = fragmentColor(f); \
    TAKE_HIDDEN(f, c) \
    TAKE_BOUND(f, c) \
    BLEND_COLOR(c) \
  }
#endif
#define BLEND_NEXT(f) BLEND(f)
#define BLEND_LIST
#define BLEND_REST
#endif

// Returns a fragment that no other one precedes in depth and colour.
Fragment nearestOfAll()
{
  Fragment f;
#ifdef VITRINE_FLOAT_KEYS
  f.key = 0.0;
  f.color = NO_COLOR;
#else
  f = unpackNode(true, uvec4(0u));
#endif
  return f;
}
