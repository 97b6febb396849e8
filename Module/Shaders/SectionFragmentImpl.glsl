  ivec2 vitrineMasksHere = vitrineSectionMasks;
#ifdef VITRINE_BLOCK
  if (vitrineSectionRow >= 0)
  {
    vitrineMasksHere = ivec2(texelFetch(vitrineBlockMasks, vitrineSectionRow + int(VITRINE_BLOCK + 0.5)).xy);
  }
#endif
  if (vitrineIsCutAway(vitrineMasksHere.x, vitrineMasksHere.y))
  {
    discard;
  }
