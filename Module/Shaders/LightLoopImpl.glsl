  // Begins the loop over the lights of the fragment's cluster, before VTK's text for one light.
  //
  // A pixel finds the lights that reach it, of 32 at once, and then takes these in turn. So pixels that are drawn
  // together evaluate the formulas as often as the pixel with the most lights.
  uvec2 vitrineList = vitrineLightListAt(vertexVC);
  uint vitrineBegin = vitrineList.x, vitrineEnd = vitrineList.x + vitrineList.y;
  if (vitrineBegin < vitrineEnd) do
  {
    uint vitrineReaching = vitrineReachingOf(vitrineBegin, vitrineEnd, vertexVC.xyz);
    if (vitrineReaching != 0u) do
    {
      vitrineTakeLight(vitrineBegin + vitrineLowestOf(vitrineReaching));
