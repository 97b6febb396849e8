// Packs a depth and a colour into two words, and unpacks them. Reads a window depth and a colour in [0, 1]. The words
// hold 26 bits of depth, 12 of alpha and 26 of three colours. The first word is the sort key. With the second word,
// fragments of equal depth are ordered by alpha, blue, green, red.
//
// Alphas and colours are the coarse codes of FineColor.glsl, which is included before. So fragments have the order of
// other nodes.
// - Alpha has 8 bits of mantissa and 16 exponents. Its rounding makes less than 0.54/255 of a picture
//   (docs/develop/error-bounds.md).
// - A colour has 406 levels. Its rounding error is below a third of 1/255.
//
// VITRINE_ADDITIVE: an alpha of 0 marks an additive colour. Another colour whose alpha rounds to 0 is stored as black.

#include "CompactDepth.glsl"

#if defined(VITRINE_COINCIDENCE) || defined(VITRINE_EXPANDS_DEPTH) || defined(VITRINE_HIDDEN_DEPTHS)
float vitrineExpandDepth(uint key)
{
  uint steps = key >> 6;
  return steps < (1u << 23) ? float(steps) * (1.0 / VITRINE_DEPTH_STEPS) : uintBitsToFloat(steps + VITRINE_DEPTH_BASE);
}
#endif

uvec2 vitrinePackNode(float z, vec4 c)
{
  uint alpha = (vitrineFineAlpha(c.a) + (1u << (VITRINE_FINE_ALPHA_BITS - 1))) >> VITRINE_FINE_ALPHA_BITS;
  ivec3 q = (vitrineFineColors(c.rgb) + (1 << (VITRINE_FINE_COLOR_BITS - 1))) >> VITRINE_FINE_COLOR_BITS;
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
    vitrineAlphaOf(alpha << VITRINE_FINE_ALPHA_BITS));
}
