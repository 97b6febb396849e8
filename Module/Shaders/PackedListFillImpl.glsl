  // Packed lists: store the fragment in its pixel's room. Places count on past the end of the room: what the frame
  // needs is known even when it does not fit, and nothing is written outside.
  {
    float vitrineZ = vitrineTakeDepth();
    uint vitrineSamples = vitrineCoverage(vitrineZ);
#if defined(VITRINE_TESTS_DEPTH) || VITRINE_SAMPLES > 0
    if (vitrineSamples == 0u)
    {
      discard;
    }
#endif
    uvec2 vitrinePlace = vitrineTakePlace();
    if (vitrinePlace.x < vitrinePlace.y)
    {
      vitrineStoreNode(vitrinePlace.x, vitrineZ, vitrineColor(gl_FragData[0]), vitrineSamples);
    }
  }
