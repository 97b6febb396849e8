  // Packed lists, fill pass: stores the fragment in its pixel's room. Counting continues past the end of the room, so
  // the need of the frame is known even if it does not fit. Nothing is written outside.
  {
#include "TakeFragment.glsl"
    uint vitrinePlace = vitrineTakePlace();
    if (vitrinePlace != VITRINE_END)
    {
      vitrineStoreNode(vitrinePlace, vitrineZ, vitrineColor(gl_FragData[0]), vitrineSamples);
    }
  }
