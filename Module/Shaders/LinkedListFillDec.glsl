// Linked-list A-buffer, fill pass: declarations for the fragment shaders of VTK's mappers. It reads and writes heads,
// links and the counters, and writes nodes. Core/lists/README.md draws the buffers.
//
// J. C. Yang, J. Hensley, H. Gruen, N. Thibieroz: Real-Time Concurrent Linked List Construction on the GPU, EGSR 2010.
// Pages of several nodes are from C. Crassin: OpenGL 4.0+ ABuffer V2.0: Linked lists of fragment pages, 2010.
//
// VITRINE_FRAMEBUFFER_FETCH  heads are a colour attachment that the shader reads and writes in order of arrival; else
//                            they are an image set by atomics, and pages hold one node
#include "SharedLayout.h"
#include "FragmentCapture.glsl"
#include "FragmentNodeStore.glsl"
#include "NodePool.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer VitrineCounterBuffer
{
  VitrineCounters vitrineCounters;
};
layout(r32ui, binding = VITRINE_IMAGE_LINKS) writeonly uniform uimageBuffer vitrineLinks;
uniform int vitrinePages; // capacity of the pool

#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(location = 1) inout uvec2 vitrineHead; // newest page, number of fragments so far
uniform int vitrinePageSize;
#else
// For each pixel, in two rows: newest node + 1, number of fragments.
layout(r32ui, binding = VITRINE_IMAGE_HEADS) coherent uniform uimage2D vitrineHeads;
#endif
