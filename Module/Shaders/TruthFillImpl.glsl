  // Method `truth`, fill pass: writes the fragment unchanged.
  {
#include "TakeFragment.glsl"
    uint vitrineAt = atomicAdd(vitrineCaptured.Fragments, 1u);
    if (vitrineAt == 0xffffffffu)
    {
      // Further fragments overwrite the first ones. The count reveals that, and they are drawn again in parts.
      atomicAdd(vitrineCaptured.Wraps, 1u);
    }
    if (vitrineAt < uint(vitrineCapture.length()))
    {
      uint vitrinePixel = uint(int(gl_FragCoord.y) * vitrineTargetWidth + int(gl_FragCoord.x));
#ifdef VITRINE_ADDITIVE
      vitrinePixel |= vitrineAdds != 0 ? VITRINE_ADDED_FRAGMENT : 0u;
#endif
      vitrineCapture[vitrineAt].Pixel = vitrinePixel;
      vitrineCapture[vitrineAt].Depth = vitrineZ;
      vitrineCapture[vitrineAt].Red = gl_FragData[0].r;
      vitrineCapture[vitrineAt].Green = gl_FragData[0].g;
      vitrineCapture[vitrineAt].Blue = gl_FragData[0].b;
      vitrineCapture[vitrineAt].Alpha = gl_FragData[0].a;
#ifdef VITRINE_COINCIDENCE
      vitrineCapture[vitrineAt].Coverage = vitrineSamples & VITRINE_COVERAGE_MASK;
      vitrineCapture[vitrineAt].Extent = uintBitsToFloat(vitrineSamples & VITRINE_EXTENT_MASK);
#else
      vitrineCapture[vitrineAt].Coverage = vitrineSamples;
      vitrineCapture[vitrineAt].Extent = 0.0;
#endif
    }
  }
