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
#ifdef VITRINE_SOFTWARE
uniform int vitrineSubPoolPages; // capacity of a sub-pool; the last ones may have fewer pages, or none
#endif

#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(location = 1) inout uvec2 vitrineHead; // newest page, number of fragments so far
uniform int vitrinePageSize;
#else
// For each pixel, in two rows: newest node + 1, number of fragments.
layout(r32ui, binding = VITRINE_IMAGE_HEADS) coherent uniform uimage2D vitrineHeads;
#endif

// Returns a free page, or VITRINE_END if the pool has none. If the bin's sub-pool is full, the next one is asked, so
// the pool is full only when all are. Behind them comes one without pages: its counter tells whether pages are missing.
// It is asked at once where a counter alone proves that more pages are needed than the pool has.
//
// Llvmpipe runs each atomic operation and store for all fragments of a vector one by one, even where none takes part.
// So here is only one.
uint vitrineTakePage()
{
#ifdef VITRINE_SOFTWARE
  const uint subPools = uint(VITRINE_SUB_POOLS);
  uint pages = uint(vitrineSubPoolPages);
  ivec2 bin = ivec2(gl_FragCoord.xy) / VITRINE_BIN_SIZE;
  uint subPool = uint(bin.x + 4 * bin.y) % subPools;
  uint page = VITRINE_END;
  for (uint asked = 1u; asked <= subPools + 1u; ++asked)
  {
    uint taken = atomicAdd(vitrineCounters.NextPage[subPool * uint(VITRINE_COUNTER_STRIDE)], 1u);
    uint found = subPool * pages + taken;
    page = taken < pages && found < uint(vitrinePages) ? found : VITRINE_END;
    if (page != VITRINE_END || subPool == subPools)
    {
      break;
    }
    subPool = asked == subPools || taken >= uint(vitrinePages) ? subPools : (subPool + 1u) % subPools;
  }
  return page;
#else
  uint page = atomicAdd(vitrineCounters.NextPage[0], 1u);
  if (page >= uint(vitrinePages))
  {
    vitrineCounters.NextPage[VITRINE_PAGES_MISSING] = 1u;
    page = VITRINE_END;
  }
  return page;
#endif
}
