  // Linked-list A-buffer, fill pass: appends the fragment to its pixel's list. The allocator and the heads continue to
  // count when the pool is full, so the need of the frame is known even if it does not fit.
  {
#include "TakeFragment.glsl"
#ifdef VITRINE_FRAMEBUFFER_FETCH
    uint vitrinePage = vitrineHead.x;
    uint vitrineSlot = vitrineHead.y & uint(vitrinePageSize - 1);
    if (vitrineSlot == 0u)
    {
      uint vitrineNew = vitrineTakePage();
      if (vitrineNew != VITRINE_END)
      {
        imageStore(vitrineLinks, int(vitrineNew), uvec4(vitrinePage));
      }
      vitrinePage = vitrineNew;
    }
    if (vitrinePage != VITRINE_END)
    {
      vitrineStoreNode(vitrineNodeIndex(vitrinePage, vitrineSlot, uint(vitrinePageSize)), vitrineZ,
        vitrineColor(gl_FragData[0]), vitrineSamples);
    }
    vitrineHead = uvec2(vitrinePage, vitrineHead.y + 1u);
#else
    ivec2 vitrinePixel = ivec2(gl_FragCoord.xy);
    ivec2 vitrineHeadTexel = ivec2(vitrinePixel.x, 2 * vitrinePixel.y);
    imageAtomicAdd(vitrineHeads, vitrineHeadTexel + ivec2(0, 1), 1u);
    uint vitrineNew = vitrineTakePage();
    if (vitrineNew != VITRINE_END)
    {
      // The image holds node numbers plus one, so clearing it to 0 empties all lists.
      uint vitrineNext = imageAtomicExchange(vitrineHeads, vitrineHeadTexel, vitrineNew + 1u) - 1u;
      imageStore(vitrineLinks, int(vitrineNew), uvec4(vitrineNext));
      vitrineStoreNode(vitrineNew, vitrineZ, vitrineColor(gl_FragData[0]), vitrineSamples);
    }
#endif
  }
