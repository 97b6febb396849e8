// What the shaders share that find the places of packed lists: sums of the blocks' fragments.
//
// The sums of all levels lie in one buffer: level 0 has one for each block, and each of the next level's is that of
// VITRINE_SCAN_FANOUT. Scanned from the last level down they become the places where each begins. G. E. Blelloch: Prefix
// Sums and Their Applications, CMU-CS-90-190, 1990: a reduction up and down the tree, here of another arity.
#include "SharedLayout.h"

layout(std430, binding = VITRINE_BINDING_SUMS) buffer SumBuffer
{
  uint sums[];
};

uniform ivec2 blockFirst;
uniform ivec2 blockCount;
uniform int ofBlocks; // where in `sums` the room of a pixel of each block lies, where that was predicted

// The sum, or the largest word where there are more: counts of one frame may pass 2^32, places do not.
uint addSaturating(uint a, uint b)
{
  uint c;
  uint sum = uaddCarry(a, b, c);
  return c == 0u ? sum : 0xffffffffu;
}
