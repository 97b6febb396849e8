// Linked-list A-buffer, filling: declarations for the fragment shaders of VTK's mappers.
//
// J. C. Yang, J. Hensley, H. Gruen, N. Thibieroz: Real-Time Concurrent Linked List Construction on the
// GPU, EGSR 2010; with pages of several nodes in place of single ones after C. Crassin: OpenGL 4.0+
// ABuffer V2.0: Linked lists of fragment pages, 2010.
//
// VITRINE_FRAMEBUFFER_FETCH  heads are a colour attachment that the shader reads and writes in order of
//                            arrival; else they are an image set by atomics, and pages hold one node
#include "SharedLayout.h"
#include "FragmentCapture.glsl"
#include "FragmentNodeStore.glsl"
#include "NodePool.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer VitrineCounterBuffer
{
  VitrineCounters vitrineCounters;
};
layout(std430, binding = VITRINE_BINDING_LINKS) writeonly buffer VitrineLinkBuffer
{
  uint vitrineLinks[];
};

#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(location = 1) inout uvec2 vitrineHead; // newest page, fragments so far
uniform int vitrinePageSize;
#else
layout(r32ui, binding = VITRINE_IMAGE_HEADS) coherent uniform uimage2D vitrineHeads; // a pixel: newest node + 1, count
#endif
