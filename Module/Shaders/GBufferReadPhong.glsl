// A pixel's surface in place of the shape's, before VTK's Phong shading of it.
  vec4 vitrinePlace = vitrineGBufferAt(VITRINE_GBUFFER_PLACE);
  vec4 vitrineNormal = vitrineGBufferAt(VITRINE_GBUFFER_NORMAL);
  vec4 vitrineBase = vitrineGBufferAt(VITRINE_GBUFFER_BASE);
  vec4 vitrineGloss = vitrineGBufferAt(VITRINE_GBUFFER_GLOSS);
  vec4 vitrineOwn = vitrineGBufferAt(VITRINE_GBUFFER_OWN);
#ifndef VITRINE_ADDS_LIGHT
  if (vitrinePlace.w == VITRINE_SHOWS_FINISHED)
  {
    gl_FragData[0] = vitrineBase;
    return;
  }
#endif
  if (vitrinePlace.w != VITRINE_SHOWS_PHONG)
  {
    discard;
  }
  vertexVC = vec4(vitrinePlace.xyz, 1.0);
  normalVCVSOutput = vitrineNormal.xyz;
  specularPower = vitrineNormal.w;
  diffuseColor = vitrineBase.xyz;
  specularColor = vitrineGloss.xyz;
  ambientColor = vitrineOwn.xyz;
  vec3 vitrineFactor = vec3(vitrineBase.w, vitrineGloss.w, vitrineOwn.w);
