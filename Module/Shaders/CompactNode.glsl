// Packs a depth and a colour into two words, and unpacks them. Reads a window depth and a colour in [0, 1]. The words
// hold 26 bits of depth, 12 of alpha and 26 of three colours. The first word is the sort key. With the second word,
// fragments of equal depth are ordered by alpha, blue, green, red.
//
// - Alpha has 8 bits of mantissa and 16 exponents. The rounding errors of a stack of any number of equal layers add up
//   to less than a quarter of 1/255.
// - A colour has 406 levels, the largest number whose cube fits. Its rounding error is below a third of 1/255.
//
// VITRINE_ADDITIVE: an alpha of 0 marks an additive colour. Another colour whose alpha rounds to 0 is stored as black.

#include "CompactDepth.glsl"

// The alpha code is taken from the bits of alpha plus an offset, so that an alpha of 0 has the bits of the base.
#define VITRINE_ALPHA_OFFSET (1.0 / 32768.0)
#define VITRINE_ALPHA_BASE 0x38000000u

#define VITRINE_COLOR_LEVELS 406

#if defined(VITRINE_COINCIDENCE) || defined(VITRINE_EXPANDS_DEPTH) || defined(VITRINE_HIDDEN_DEPTHS)
float vitrineExpandDepth(uint key)
{
  uint steps = key >> 6;
  return steps < (1u << 23) ? float(steps) * (1.0 / VITRINE_DEPTH_STEPS) : uintBitsToFloat(steps + VITRINE_DEPTH_BASE);
}
#endif

uvec2 vitrinePackNode(float z, vec4 c)
{
  uint alpha = (floatBitsToUint(c.a + VITRINE_ALPHA_OFFSET) - (VITRINE_ALPHA_BASE - 0x4000u)) >> 15;
  ivec3 q = ivec3(min(c.rgb, 1.0) * float(VITRINE_COLOR_LEVELS - 1) + 0.5);
  int colors = (q.b * VITRINE_COLOR_LEVELS + q.g) * VITRINE_COLOR_LEVELS + q.r;
#ifdef VITRINE_ADDITIVE
  colors = c.a > 0.0 && alpha == 0u ? 0 : colors;
#endif
  return uvec2((vitrineCompactDepth(z) << 6) | (alpha >> 6), (alpha << 26) | uint(colors));
}

vec4 vitrineUnpackNodeColor(uvec2 node)
{
  uint alpha = ((node.x & 0x3fu) << 6) | (node.y >> 26);
  int colors = int(node.y & 0x3ffffffu);
  // A float has too few bits for the exact quotient. The estimate is lowered slightly, so it is right or one too small.
  int blueGreen = int(float(colors) * (1.0 / float(VITRINE_COLOR_LEVELS)) - 0.03);
  int red = colors - blueGreen * VITRINE_COLOR_LEVELS;
  int one = int(red >= VITRINE_COLOR_LEVELS);
  blueGreen += one;
  red -= one * VITRINE_COLOR_LEVELS;
  int blue = int((float(blueGreen) + 0.5) * (1.0 / float(VITRINE_COLOR_LEVELS)));
  ivec3 q = ivec3(red, blueGreen - blue * VITRINE_COLOR_LEVELS, blue);
  return vec4(vec3(q) * (1.0 / float(VITRINE_COLOR_LEVELS - 1)),
    uintBitsToFloat((alpha << 15) + VITRINE_ALPHA_BASE) - VITRINE_ALPHA_OFFSET);
}
