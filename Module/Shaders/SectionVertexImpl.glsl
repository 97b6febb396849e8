  for (int plane = 0; plane < VITRINE_SECTION_PLANES; ++plane)
  {
    vitrineSectionDistances[plane] = dot(vitrineSectionPlanes[plane], VITRINE_SECTION_VERTEX);
  }
