// The words of HiddenDepth.glsl.
#include "SharedLayout.h"

// The next depth behind 1.
#define VITRINE_HIDDEN_BASE 0x3f800001u

uint depthBitsOf(uint word)
{
  return VITRINE_HIDDEN_BASE - word;
}

// Returns the word of the next depth behind, so that what is at the depth is not behind it.
uint wordOfDepth(uint bits)
{
  return VITRINE_HIDDEN_BASE - min(bits + 1u, VITRINE_HIDDEN_BASE - 1u);
}
