  // Packed lists: store the fragment in its pixel's room. Fragments are counted on past the end of the room: what the
  // frame needs is known even when it does not fit, and nothing is written outside.
  {
    float vitrineZ = vitrineTakeDepth();
    uint vitrineSamples = vitrineCoverage(vitrineZ);
#if defined(VITRINE_TESTS_DEPTH) || VITRINE_SAMPLES > 0
    if (vitrineSamples == 0u)
    {
      discard;
    }
#endif
    uint vitrinePlace = vitrineTakePlace();
    if (vitrinePlace != VITRINE_END)
    {
      vitrineStoreNode(vitrinePlace, vitrineZ, vitrineColor(gl_FragData[0]), vitrineSamples);
    }
  }
