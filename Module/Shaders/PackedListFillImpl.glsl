  // Packed lists: store the fragment in its pixel's room. Fragments are counted on past the end of the room: what the
  // frame needs is known even when it does not fit, and nothing is written outside.
  {
#include "TakeFragment.glsl"
    uint vitrinePlace = vitrineTakePlace();
    if (vitrinePlace != VITRINE_END)
    {
      vitrineStoreNode(vitrinePlace, vitrineZ, vitrineColor(gl_FragData[0]), vitrineSamples);
    }
  }
