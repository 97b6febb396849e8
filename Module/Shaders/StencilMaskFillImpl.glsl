  // Stencil masks: colour and depth. The stencil lets them through to one pixel of the group; what opaque geometry hides
  // must not get there, since a failed stencil test counts before the depth is tested.
  {
    float vitrineZ = vitrineTakeDepth();
    if (vitrineCoverage(vitrineZ) == 0u)
    {
      discard;
    }
    gl_FragData[0] = vitrineColor(gl_FragData[0]);
    gl_FragData[1] = vec4(vitrineToView(vitrineZ), 0.0, 0.0, 0.0);
  }
