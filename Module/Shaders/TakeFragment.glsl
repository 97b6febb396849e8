    // Within a fill: the depth of the fragment and the samples that it covers; one that is hidden in all goes no further.
    // With a tolerance for coincidence, the near end of its interval of depths, and the samples with the extent.
#ifdef VITRINE_COINCIDENCE
    vitrineTakeSlopeOfWrittenDepth();
#endif
    float vitrineZ = vitrineTakeDepth();
    uint vitrineSamples = vitrineCoverage(vitrineZ);
#if defined(VITRINE_TESTS_DEPTH) || VITRINE_SAMPLES > 0
    if (vitrineSamples == 0u)
    {
      discard;
    }
#endif
#ifdef VITRINE_COINCIDENCE
    vitrineSamples |= vitrineTakeExtent(vitrineZ, gl_FragData[0].a);
#endif
