  if (vitrineIsCutAway(vitrineSectionMasks.x, vitrineSectionMasks.y))
  {
    discard;
  }
