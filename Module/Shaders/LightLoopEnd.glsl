// Ends the loops that LightLoopImpl.glsl begins.
      vitrineReaching &= vitrineReaching - 1u;
    } while (vitrineReaching != 0u);
    vitrineBegin += VITRINE_LIGHTS_AT_ONCE;
  } while (vitrineBegin < vitrineEnd);
