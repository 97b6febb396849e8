// Packs the colour of a node, and unpacks it. As unsigned words, packed colours are ordered by alpha, blue, green, red.
//
// VITRINE_HALF_FLOAT: four codes of 16 bits in two words.
//   With VITRINE_FINE_COLORS they are those of FineColor.glsl, which is included before.
//   Otherwise they are floats. A colour has no sign, so its bit goes to the mantissa: 5 bits of exponent, 11 of
//   mantissa, half the rounding error of IEEE's half float. Values below the smallest exponent become 0.
// Otherwise: RGBA8 in one word.
//
// VITRINE_ADDITIVE: an alpha of 0 marks an additive colour. Another colour whose alpha rounds to 0 is stored as 0.
//
// Shifts and integer additions replace packHalf2x16 and its kin. These are several times slower in software
// rasterisers, and their rounding depends on the driver.
#ifdef VITRINE_ADDITIVE
#define VITRINE_IS_LOST(alpha, code) (alpha > 0.0 && code == 0)
#else
#define VITRINE_IS_LOST(alpha, code) false
#endif

#if defined(VITRINE_HALF_FLOAT) && defined(VITRINE_FINE_COLORS)

uvec2 vitrinePackColor(vec4 c)
{
  uint alpha = vitrineFineAlpha(c.a);
  ivec3 q = vitrineFineColors(c.rgb);
  return uvec2(uint(q.r | (q.g << 16)), uint(q.b) | (alpha << 16));
}

vec4 vitrineUnpackColor(uvec2 p)
{
  vec3 q = vec3(ivec3(int(p.x & 0xffffu), int(p.x >> 16), int(p.y & 0xffffu)));
  return vec4(q * (1.0 / VITRINE_FINE_COLOR_STEPS), vitrineAlphaOf(p.y >> 16));
}

#elif defined(VITRINE_HALF_FLOAT)

// The exponents (IEEE single, biased by 127) at which the 16-bit exponent 0 begins. Alpha and clamped colours are at
// most 1, so all codes can lie below 1. Colours of a floating-point target reach 65504.
#define VITRINE_UNIT_EXPONENT 96u
#ifdef VITRINE_FIXED_POINT_TARGET
#define VITRINE_COLOR_EXPONENT VITRINE_UNIT_EXPONENT
#else
#define VITRINE_COLOR_EXPONENT 111u
#endif

uint vitrinePack16(float x, uint exponent)
{
  return uint(max(int((floatBitsToUint(x) + 0x800u) >> 12) - int(exponent << 11), 0));
}

// The bits of a code are a float that is 2^exponent times too small. Code 0 yields 0.
float vitrineUnpack16(uint packed16, uint exponent)
{
  return uintBitsToFloat(packed16 << 12) * uintBitsToFloat((exponent + 127u) << 23);
}

uvec2 vitrinePackColor(vec4 c)
{
  uint alpha = vitrinePack16(c.a, VITRINE_UNIT_EXPONENT);
  uvec2 colors = uvec2(vitrinePack16(c.r, VITRINE_COLOR_EXPONENT) | (vitrinePack16(c.g, VITRINE_COLOR_EXPONENT) << 16),
    vitrinePack16(c.b, VITRINE_COLOR_EXPONENT) | (alpha << 16));
  return VITRINE_IS_LOST(c.a, int(alpha)) ? uvec2(0u) : colors;
}

vec4 vitrineUnpackColor(uvec2 p)
{
  return vec4(vitrineUnpack16(p.x & 0xffffu, VITRINE_COLOR_EXPONENT),
    vitrineUnpack16(p.x >> 16, VITRINE_COLOR_EXPONENT), vitrineUnpack16(p.y & 0xffffu, VITRINE_COLOR_EXPONENT),
    vitrineUnpack16(p.y >> 16, VITRINE_UNIT_EXPONENT));
}

#else

uint vitrinePackColor(vec4 c)
{
  ivec4 q = ivec4(min(c, 1.0) * 255.0 + 0.5);
  return VITRINE_IS_LOST(c.a, q.a) ? 0u : uint(q.r | (q.g << 8) | (q.b << 16) | (q.a << 24));
}

vec4 vitrineUnpackColor(uint p)
{
  int q = int(p);
  return vec4(ivec4(q & 255, (q >> 8) & 255, (q >> 16) & 255, int(p >> 24))) * (1.0 / 255.0);
}

#endif
