// Packed lists, filling: declarations for the fragment shaders of VTK's mappers.
//
// VITRINE_FRAMEBUFFER_FETCH  heads are a colour attachment that the shader reads and writes in order of
//                            arrival; else they are an image set by atomics
#include "SharedLayout.h"
#include "FragmentCapture.glsl"
#include "FragmentNodeStore.glsl"

#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(location = 1) inout uvec2 vitrineHead; // where the room ends, where the next fragment goes
#else
layout(r32ui, binding = VITRINE_IMAGE_HEADS) coherent uniform uimage2D vitrineHeads; // the same, in two rows
#endif

// The place of the pixel's next fragment, and the end of its room.
uvec2 vitrineTakePlace()
{
#ifdef VITRINE_FRAMEBUFFER_FETCH
  uvec2 taken = vitrineHead.yx;
  vitrineHead.y = taken.x + 1u;
  return taken;
#else
  ivec2 texel = ivec2(gl_FragCoord.xy) * ivec2(1, 2);
  return uvec2(imageAtomicAdd(vitrineHeads, texel + ivec2(0, 1), 1u), imageLoad(vitrineHeads, texel).x);
#endif
}
