  vec3 vitrineLineColor = vitrineIsStriped ? vec3(1.0) : vitrineCapEdge.rgb;
  diffuseColor = mix(vitrineCutDiffuse.rgb, vitrineLineColor, vitrineCapLine);
  ambientColor = vitrineCutAmbient * (1.0 - vitrineCapLine);
  opacity = vitrineCutDiffuse.a;
  if (vitrineIsCapEdge)
  {
    diffuseColor = vitrineCapEdge.rgb;
    ambientColor = vec3(0.0);
    opacity = max(opacity, vitrineCapEdge.a);
  }
