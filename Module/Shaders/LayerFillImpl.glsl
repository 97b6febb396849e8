  // Capture of layers: writes the fragment.
  {
#include "TakeFragment.glsl"
    uint vitrineAt = atomicAdd(vitrineCaptured.Fragments, 1u);
    if (vitrineAt == 0xffffffffu)
    {
      atomicAdd(vitrineCaptured.Wraps, 1u);
    }
    if (vitrineAt < uint(vitrineLayers.length()))
    {
      ivec2 vitrineAway = ivec2(gl_FragCoord.xy) - vitrineLayerFirst;
      vec4 vitrineSeen = vitrineColor(gl_FragData[0]);
      vitrineLayers[vitrineAt].Pixel = uint(vitrineAway.y * vitrineLayerWidth + vitrineAway.x);
      vitrineLayers[vitrineAt].Depth = vitrineZ;
      vitrineLayers[vitrineAt].Red = vitrineSeen.r;
      vitrineLayers[vitrineAt].Green = vitrineSeen.g;
      vitrineLayers[vitrineAt].Blue = vitrineSeen.b;
      vitrineLayers[vitrineAt].Alpha = vitrineSeen.a;
      vitrineLayers[vitrineAt].Coverage = vitrineSamples;
      vitrineLayers[vitrineAt].Part = vitrinePartAndSide;
      vitrineLayers[vitrineAt].Kind = uint(vitrineLayerKind);
      vitrineLayers[vitrineAt].Primitive = uint(gl_PrimitiveID);
    }
  }
