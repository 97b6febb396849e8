// A window depth in 26 bits. The code keeps the order of depths. Depths from 1/128 on are exact, except that 1 and the
// last two before it become one. Nearer depths have steps of 2^-30, a 64th of a step of a 24-bit depth buffer.
// Fragments are taken with such depths (TakeFragment.glsl), so the code is exact for them.
#include "SharedLayout.h"

// From VITRINE_FIRST_FLOAT_DEPTH on the code is taken from the float's bits, below it is a number of steps. The largest
// code is one less than that of a register without a fragment.
#define VITRINE_DEPTH_BASE (0x3c000000u - (1u << 23))
#define VITRINE_LARGEST_DEPTH ((1u << 26) - 2u)

uint vitrineCompactDepth(float z)
{
  uint steps = z < VITRINE_FIRST_FLOAT_DEPTH ? uint(int(z * VITRINE_DEPTH_STEPS))
                                             : floatBitsToUint(z) - VITRINE_DEPTH_BASE;
  return min(steps, VITRINE_LARGEST_DEPTH);
}
