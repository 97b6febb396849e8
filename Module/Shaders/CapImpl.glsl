  ivec2 vitrinePixel = ivec2(gl_FragCoord.xy) - vitrineCapPlace.yz;
  vec2 vitrineCapStep = fwidth(vitrineCapPoint);
  uvec2 vitrineSumHere = vitrineSumAt(vitrinePixel);
  if (vitrineSumHere == uvec2(0u))
  {
    discard;
  }
  bool vitrineInterferes = !vitrineIsOnePart(vitrineSumHere);
  int vitrineCutSlot = vitrineInterferes ? vitrineFirstOfTwo(vitrineSumHere) : int(vitrineSumHere.x);
  bool vitrineIsStriped = vitrineInterferes && (vitrineCapStyle.w == 1 || vitrineCutSlot == 0);
  int vitrineLookSlot = vitrineIsStriped ? 0 : vitrineCutSlot;
  uvec4 vitrineCutPart = texelFetch(vitrineCutParts, vitrineLookSlot);
  vec4 vitrineCutDiffuse = texelFetch(vitrineCutLooks, VITRINE_CUT_LOOK_TEXELS * vitrineLookSlot);
  vec3 vitrineCutAmbient = texelFetch(vitrineCutLooks, VITRINE_CUT_LOOK_TEXELS * vitrineLookSlot + 1).rgb;
  bool vitrineIsTranslucentCap = vitrineCutDiffuse.a < 1.0;
  if (vitrineIsTranslucentCap != (vitrineCapPlace.w == 1))
  {
    discard;
  }
  vitrineCapPart = texelFetch(vitrineCutParts, vitrineCutSlot).x;

  // The other planes that cut the part. A plane of those that remove together counts where all others remove.
  int vitrineOwnBit = 1 << vitrineCapPlace.x;
  int vitrineCutAny = int(vitrineCutPart.y) & ~vitrineOwnBit;
  int vitrineCutAll = int(vitrineCutPart.z);
  if ((vitrineCutAll & vitrineOwnBit) != 0)
  {
    vitrineCutAll &= ~vitrineOwnBit;
    if (vitrineIsCutAway(vitrineCutAny, 0) || (vitrineCutAll != 0 && !vitrineIsCutAway(0, vitrineCutAll)))
    {
      discard;
    }
  }
  else if (vitrineIsCutAway(vitrineCutAny, vitrineCutAll))
  {
    discard;
  }

  // Lines of neighbouring parts differ in direction and distance. Places do not depend on frames before, as numbers do.
  uint vitrineHatchTurn = vitrinePartHash(vitrineCutPart.w >> 8);
  vec2 vitrineHatchPoint = vitrineCapPoint / vitrineCapSpacing.x;
  vitrineHatchPoint.x = (vitrineHatchTurn & 1u) == 0u ? vitrineHatchPoint.x : -vitrineHatchPoint.x;
  vitrineHatchPoint *= 1.0 - 0.15 * float((vitrineHatchTurn >> 1) & 3u);
  float vitrineHatchBlur = (vitrineCapStep.x + vitrineCapStep.y) / vitrineCapSpacing.x * 0.7;
  float vitrineCapLine = vitrineHatch(int(vitrineCutPart.w & 255u), vitrineHatchPoint, vitrineHatchBlur);
  if (vitrineIsStriped)
  {
    vitrineCapLine = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y + vitrineCapSpacing.z) / 12.0));
  }
  bool vitrineIsCapEdge = false;
  int vitrineEdgeWidth = vitrineCapStyle.x;
  for (int y = -vitrineEdgeWidth; y <= vitrineEdgeWidth; ++y)
  {
    for (int x = -vitrineEdgeWidth; x <= vitrineEdgeWidth; ++x)
    {
      if (abs(x) + abs(y) <= vitrineEdgeWidth)
      {
        vitrineIsCapEdge = vitrineIsCapEdge || vitrineSumAt(vitrinePixel + ivec2(x, y)) != vitrineSumHere;
      }
    }
  }
