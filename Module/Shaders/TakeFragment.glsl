    // Part of a fill: reads the fragment's depth and the samples that it covers. A fragment that is hidden in all
    // samples is discarded. With a tolerance for coincidence, the depth is the interval's near end, and the samples'
    // word has the extent.
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
#else
    vitrineZ = vitrineKeptDepth(vitrineZ);
#endif
