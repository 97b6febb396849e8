    // Within a fill: the depth of the fragment and the samples that it covers; one that is hidden in all goes no further.
    float vitrineZ = vitrineTakeDepth();
    uint vitrineSamples = vitrineCoverage(vitrineZ);
#if defined(VITRINE_TESTS_DEPTH) || VITRINE_SAMPLES > 0
    if (vitrineSamples == 0u)
    {
      discard;
    }
#endif
