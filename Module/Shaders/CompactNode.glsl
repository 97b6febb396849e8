// A depth and a colour in two words: 25 bits of depth, 12 of alpha, 9 of each colour. The first word is the key that
// sorts; with the second, fragments of equal depth order by alpha, blue, green, red. For colours from 0 to 1.
//
// From 1/8 on, window depths are kept to the bit, but for the last three, which become one; nearer ones in steps of 2^-26,
// a quarter of a 24-bit depth buffer's. Alpha has 8 bits of mantissa below 16 exponents: its rounding, which layers add up,
// stays below a quarter of 1/255 in a stack of any number of equal ones, and so does that of a colour.

// From here on depths are taken by their bits, before by steps; the largest is one less than a register's without a
// fragment.
#define VITRINE_FIRST_FLOAT_DEPTH 0.125
#define VITRINE_DEPTH_STEPS 67108864.0
#define VITRINE_DEPTH_BASE (0x3e000000u - (1u << 23))
#define VITRINE_LARGEST_DEPTH ((1u << 25) - 2u)

// Alpha is taken by the bits of a little more than itself, so that the bits of 0 are the base.
#define VITRINE_ALPHA_OFFSET (1.0 / 32768.0)
#define VITRINE_ALPHA_BASE 0x38000000u

uint vitrineCompactDepth(float z)
{
  uint steps = z < VITRINE_FIRST_FLOAT_DEPTH ? uint(int(z * VITRINE_DEPTH_STEPS))
                                             : floatBitsToUint(z) - VITRINE_DEPTH_BASE;
  return min(steps, VITRINE_LARGEST_DEPTH);
}

#ifdef VITRINE_COINCIDENCE
float vitrineExpandDepth(uint steps)
{
  return steps < (1u << 23) ? float(steps) * (1.0 / VITRINE_DEPTH_STEPS) : uintBitsToFloat(steps + VITRINE_DEPTH_BASE);
}
#endif

uvec2 vitrinePackNode(float z, vec4 c)
{
  uint alpha = (floatBitsToUint(c.a + VITRINE_ALPHA_OFFSET) - (VITRINE_ALPHA_BASE - 0x4000u)) >> 15;
  ivec3 q = ivec3(min(c.rgb, 1.0) * 511.0 + 0.5);
  return uvec2((vitrineCompactDepth(z) << 7) | (alpha >> 5), (alpha << 27) | uint(q.r | (q.g << 9) | (q.b << 18)));
}

vec4 vitrineUnpackNodeColor(uvec2 node)
{
  uint alpha = ((node.x & 0x7fu) << 5) | (node.y >> 27);
  int q = int(node.y);
  return vec4(vec3(ivec3(q & 511, (q >> 9) & 511, (q >> 18) & 511)) * (1.0 / 511.0),
    uintBitsToFloat((alpha << 15) + VITRINE_ALPHA_BASE) - VITRINE_ALPHA_OFFSET);
}
