// Fragments in named registers, and what a sort does with them. A register without a fragment sorts last and
// blends as nothing.
#include "PackedColor.glsl"

#define NO_KEY 0xffffffffu

#ifdef VITRINE_HALF_FLOAT

struct Fragment
{
  uint key;        // bits of the window depth
  uint redGreen;   // as PackedColor.glsl packs
  uint blueAlpha;
};

Fragment unpackNode(bool valid, uvec4 node)
{
  return Fragment(valid ? node.x : NO_KEY, valid ? node.y : 0u, valid ? node.z : 0u);
}
uint nodeCoverage(uvec4 node)
{
  return node.w;
}
vec4 fragmentColor(Fragment f)
{
  return vitrineUnpackColor(uvec2(f.redGreen, f.blueAlpha));
}
bool colorAbove(Fragment a, Fragment b)
{
  return a.blueAlpha > b.blueAlpha || (a.blueAlpha == b.blueAlpha && a.redGreen > b.redGreen);
}
bool sameFragment(Fragment a, Fragment b)
{
  return a.key == b.key && a.redGreen == b.redGreen && a.blueAlpha == b.blueAlpha;
}

#define EXCHANGE_COLOR(a, b, s) \
  { \
    uint t = s ? b.redGreen : a.redGreen; b.redGreen = s ? a.redGreen : b.redGreen; a.redGreen = t; \
    t = s ? b.blueAlpha : a.blueAlpha; b.blueAlpha = s ? a.blueAlpha : b.blueAlpha; a.blueAlpha = t; \
  }

#else

struct Fragment
{
  uint key;   // bits of the window depth
  uint color; // as PackedColor.glsl packs
};

Fragment unpackNode(bool valid, uvec4 node)
{
  return Fragment(valid ? node.x : NO_KEY, valid ? node.y : 0u);
}
uint nodeCoverage(uvec4 node)
{
  return node.z;
}
vec4 fragmentColor(Fragment f)
{
  return vitrineUnpackColor(f.color);
}
bool colorAbove(Fragment a, Fragment b)
{
  return a.color > b.color;
}
bool sameFragment(Fragment a, Fragment b)
{
  return a.key == b.key && a.color == b.color;
}

#define EXCHANGE_COLOR(a, b, s) \
  { \
    uint t = s ? b.color : a.color; b.color = s ? a.color : b.color; a.color = t; \
  }

#endif

#define DECLARE(f) Fragment f;
#define CLEAR(f) f = unpackNode(false, uvec4(0u));

// Exchange a and b where s holds, given that s holds wherever b is the nearer.
#define EXCHANGE(a, b, s) \
  { \
    uint near = min(a.key, b.key); b.key = max(a.key, b.key); a.key = near; \
    EXCHANGE_COLOR(a, b, s) \
  }

// Order a and b by depth alone.
#define COMPARE_EXCHANGE(a, b) \
  { \
    bool s = a.key > b.key; \
    EXCHANGE(a, b, s) \
  }

// Order a and b by depth and, where it is equal, by colour.
#define COMPARE_EXCHANGE_FULL(a, b) \
  { \
    bool s = a.key > b.key || (a.key == b.key && colorAbove(a, b)); \
    EXCHANGE(a, b, s) \
  }

// Order a and b, neighbours after a sort by depth, by colour where their depths are equal.
#define ORDER_TIE(a, b) \
  { \
    bool s = a.key == b.key && colorAbove(a, b); \
    disordered = disordered || s; \
    EXCHANGE_COLOR(a, b, s) \
  }

// Composite front to back: `color` is premultiplied, `transmittance` what still shows behind.
#define BLEND(f) \
  { \
    vec4 c = fragmentColor(f); \
    color += transmittance * c.a * c.rgb; \
    transmittance -= transmittance * c.a; \
  }
