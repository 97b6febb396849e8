// Replaces the shape's surface by the pixel's, before VTK's Phong shading. Reads the G-buffer; sets the mapper's
// variables.
  vec4 vitrinePlace = vitrineGBufferAt(VITRINE_GBUFFER_PLACE);
  vec4 vitrineNormal = vitrineGBufferAt(VITRINE_GBUFFER_NORMAL);
#if defined(VITRINE_HAS_ONLY_MATERIALS)
  if (vitrinePlace.w != VITRINE_SHOWS_MATERIAL)
  {
    discard;
  }
  VitrineMaterialValues vitrineValues = vitrineMaterialAt(int(vitrineNormal.w));
#else
  VitrineMaterialValues vitrineValues = vitrineValuesAt(vitrinePlace.w, vitrineNormal.w);
#ifndef VITRINE_ADDS_LIGHT
  if (vitrinePlace.w == VITRINE_SHOWS_FINISHED)
  {
    gl_FragData[0] = vitrineValues.Base;
    return;
  }
#endif
  if (vitrinePlace.w != VITRINE_SHOWS_PHONG && vitrinePlace.w != VITRINE_SHOWS_MATERIAL)
  {
    discard;
  }
#endif
  vertexVC = vec4(vitrinePlace.xyz, 1.0);
  normalVCVSOutput = vitrineNormal.xyz;
  specularPower = vitrineValues.SpecularPower;
  diffuseColor = vitrineValues.Base.xyz;
  specularColor = vitrineValues.Gloss.xyz;
  ambientColor = vitrineValues.Own.xyz;
  vec3 vitrineFactor = vec3(vitrineValues.Base.w, vitrineValues.Gloss.w, vitrineValues.Own.w);
