  for (int plane = 0; plane < VITRINE_SECTION_PLANES; ++plane)
  {
    vitrineSectionDistances[plane / 4][plane % 4] = dot(vitrineSectionPlanes[plane], VITRINE_SECTION_VERTEX);
  }
