// The words of HiddenDepth.glsl.
#include "SharedLayout.h"

// The next depth behind 1.
#define VITRINE_HIDDEN_BASE 0x3f800001u

uint depthBitsOf(uint word)
{
  return VITRINE_HIDDEN_BASE - word;
}

// Returns the bits of the next depth behind among those that fragments keep (CompactDepth.glsl). The depth test sees
// them before that, so all that is kept at `bits` passes it there.
uint nextKeptDepth(uint bits)
{
  float z = uintBitsToFloat(bits);
  return z < VITRINE_FIRST_FLOAT_DEPTH ? floatBitsToUint(z + 1.0 / VITRINE_DEPTH_STEPS)
    : z < VITRINE_LAST_DEPTH           ? bits + 1u
                                       : VITRINE_HIDDEN_BASE - 1u;
}

// Returns the word of the next depth behind, so that what is at the depth is not behind it.
uint wordOfDepth(uint bits)
{
  return VITRINE_HIDDEN_BASE - nextKeptDepth(bits);
}
