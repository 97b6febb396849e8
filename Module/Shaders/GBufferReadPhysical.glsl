// Replaces the shape's surface by the pixel's, before VTK's physically based shading. Reads the G-buffer; sets the
// mapper's variables.
  vec4 vitrinePlace = vitrineGBufferAt(VITRINE_GBUFFER_PLACE);
  vec4 vitrineNormal = vitrineGBufferAt(VITRINE_GBUFFER_NORMAL);
  vec4 vitrineBase = vitrineGBufferAt(VITRINE_GBUFFER_BASE);
  vec4 vitrineGloss = vitrineGBufferAt(VITRINE_GBUFFER_GLOSS);
  vec4 vitrineOwn = vitrineGBufferAt(VITRINE_GBUFFER_OWN);
  if (vitrinePlace.w != VITRINE_SHOWS_PHYSICAL)
  {
    discard;
  }
  vertexVC = vec4(vitrinePlace.xyz, 1.0);
  normalVCVSOutput = vitrineNormal.xyz;
  roughnessUniform = vitrineNormal.w;
  diffuseColor = vitrineBase.xyz;
  metallicUniform = vitrineBase.w;
  edgeTintUniform = vitrineGloss.xyz;
  baseF0Uniform = vitrineGloss.w;
  aoStrengthUniform = vitrineOwn.w;
