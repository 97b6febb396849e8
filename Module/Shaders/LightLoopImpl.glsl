  // Of some lights at once, pixels find those that reach them, and each takes its own of these in turn: pixels that are drawn together go through the formulas as often
  // as the one that most lights reach.
  uvec2 vitrineList = vitrineLightListAt(vertexVC);
  uint vitrineBegin = vitrineList.x, vitrineEnd = vitrineList.x + vitrineList.y;
  if (vitrineBegin < vitrineEnd) do
  {
    uint vitrineReaching = vitrineReachingOf(vitrineBegin, vitrineEnd, vertexVC.xyz);
    if (vitrineReaching != 0u) do
    {
      vitrineTakeLight(vitrineBegin + vitrineLowestOf(vitrineReaching));
