  uvec2 vitrineList = vitrineLightListAt(vertexVC);
  for (uint vitrinePlace = 0u; vitrinePlace < vitrineList.y; ++vitrinePlace)
  {
    vitrineTakeLight(vitrineList.x + vitrinePlace);
