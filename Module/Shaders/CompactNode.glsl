// A depth and a colour in two words: 26 bits of depth, 12 of alpha, 26 of three colours. The first word is the key that
// sorts; with the second, fragments of equal depth order by alpha, blue, green, red. For colours from 0 to 1.
//
// From 1/128 on, window depths are kept to the bit, but for the last three, which become one; nearer ones in steps of 2^-30,
// a 64th of a 24-bit depth buffer's. Alpha has 8 bits of mantissa below 16 exponents: its rounding, which layers add up,
// stays below a quarter of 1/255 in a stack of any number of equal ones. A colour is one of 406 levels, whose cubes just
// fit: its rounding stays below a third.
//
// VITRINE_ADDITIVE: alpha 0 is that of a colour that is added. What has another alpha, which is kept as 0, is kept as black.

// From here on depths are taken by their bits, before by steps; the largest is one less than a register's without a
// fragment.
#define VITRINE_FIRST_FLOAT_DEPTH 0.0078125
#define VITRINE_DEPTH_STEPS 1073741824.0
#define VITRINE_DEPTH_BASE (0x3c000000u - (1u << 23))
#define VITRINE_LARGEST_DEPTH ((1u << 26) - 2u)

// Alpha is taken by the bits of a little more than itself, so that the bits of 0 are the base.
#define VITRINE_ALPHA_OFFSET (1.0 / 32768.0)
#define VITRINE_ALPHA_BASE 0x38000000u

#define VITRINE_COLOR_LEVELS 406

uint vitrineCompactDepth(float z)
{
  uint steps = z < VITRINE_FIRST_FLOAT_DEPTH ? uint(int(z * VITRINE_DEPTH_STEPS))
                                             : floatBitsToUint(z) - VITRINE_DEPTH_BASE;
  return min(steps, VITRINE_LARGEST_DEPTH);
}

#ifdef VITRINE_COINCIDENCE
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
  // A float has too few bits for the division: what it says is made a little less, and then right or one too small.
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
