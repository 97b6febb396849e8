// Packed lists, fill pass: declarations for the fragment shaders of VTK's mappers. It reads and writes heads, and
// writes nodes. Core/lists/README.md draws the buffers.
//
// VITRINE_FRAMEBUFFER_FETCH  heads are a colour attachment that the shader reads and writes in order of arrival; else
//                            they are an image set by atomics
#include "SharedLayout.h"
#include "FragmentCapture.glsl"
#include "FragmentNodeStore.glsl"

#ifdef VITRINE_FRAMEBUFFER_FETCH
// Start of the room, and in one word the number of fragments so far and the room.
layout(location = 1) inout uvec2 vitrineHead;
#else
// The same two words, in two rows.
layout(r32ui, binding = VITRINE_IMAGE_HEADS) coherent uniform uimage2D vitrineHeads;
layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer VitrineCounterBuffer
{
  VitrineCounters vitrineCounters;
};
#endif

// Returns the place of the pixel's next fragment in the buffer, or VITRINE_END if it has no room.
uint vitrineTakePlace()
{
  const uint one = 1u << VITRINE_COUNT_SHIFT;
#ifdef VITRINE_FRAMEBUFFER_FETCH
  uint start = vitrineHead.x;
  uint taken = vitrineHead.y;
  uint count = taken >> VITRINE_COUNT_SHIFT;
  vitrineHead.y = count < VITRINE_LARGEST_COUNT ? taken + one : taken;
#else
  ivec2 texel = ivec2(gl_FragCoord.xy) * ivec2(1, 2);
  uint taken = imageAtomicAdd(vitrineHeads, texel + ivec2(0, 1), one);
  uint start = imageLoad(vitrineHeads, texel).x;
  uint count = taken >> VITRINE_COUNT_SHIFT;
  if (count == VITRINE_LARGEST_COUNT)
  {
    atomicMax(vitrineCounters.LayersMax, VITRINE_LARGEST_COUNT); // the count wraps to 0
  }
#endif
  return count < (taken & (one - 1u)) ? start + count : VITRINE_END;
}
