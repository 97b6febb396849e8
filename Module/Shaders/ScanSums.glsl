// The sums of the shaders that place packed lists, for all levels in one buffer. Level 0 has the number of fragments,
// or the predicted room, of each block. A sum of the next level is that of VITRINE_SCAN_FANOUT sums of this level.
//
// A scan from the last level down replaces the sums by the places where blocks begin. G. E. Blelloch: Prefix Sums and
// Their Applications, CMU-CS-90-190, 1990: a reduction up and down a tree, here of a larger arity.
#include "SharedLayout.h"

layout(std430, binding = VITRINE_BINDING_SUMS) buffer SumBuffer
{
  uint sums[];
};

uniform ivec2 blockFirst;
uniform ivec2 blockCount;
uniform int ofBlocks; // index in `sums` of the room of one pixel of each block, if it was predicted

// Returns the sum, or the largest word on overflow. Counts of one frame may exceed 2^32, places do not.
uint addSaturating(uint a, uint b)
{
  uint c;
  uint sum = uaddCarry(a, b, c);
  return c == 0u ? sum : 0xffffffffu;
}
