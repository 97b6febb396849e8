// The fine codes of alphas and colours in [0, 1] (SharedLayout.h), of which compact nodes keep the coarse part. All
// fragments are ordered by them, so each program must compute the same: products and sums are not joined.
//
// VITRINE_FINE_COLORS is defined where they are used: in targets with colours in [0, 1], but where light is added. Any
// number of such fragments may add up, so only the share of their rounding is small.
#include "SharedLayout.h"

#if defined(VITRINE_COMPACT_NODES) || \
  (defined(VITRINE_HALF_FLOAT) && defined(VITRINE_FIXED_POINT_TARGET) && !defined(VITRINE_ADDITIVE))
#define VITRINE_FINE_COLORS

uint vitrineFineAlpha(float a)
{
  uint halfStep = 1u << (VITRINE_ALPHA_SHIFT - 1);
  return (floatBitsToUint(a + VITRINE_ALPHA_OFFSET) - (VITRINE_ALPHA_BASE - halfStep)) >> VITRINE_ALPHA_SHIFT;
}

float vitrineAlphaOf(uint fine)
{
  return uintBitsToFloat((fine << VITRINE_ALPHA_SHIFT) + VITRINE_ALPHA_BASE) - VITRINE_ALPHA_OFFSET;
}

ivec3 vitrineFineColors(vec3 c)
{
  precise vec3 steps = min(c, 1.0) * VITRINE_FINE_COLOR_STEPS;
  return ivec3(steps + 0.5);
}
#endif
