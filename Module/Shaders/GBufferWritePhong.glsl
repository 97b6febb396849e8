// Writes the inputs of VTK's Phong shading to the G-buffer, instead of lighting. gl_FragData[0] is white times the
// textures.
  bool vitrineHasNumber = vitrineMaterial >= 0.0;
  gl_FragData[1] = vec4(normalVCVSOutput, vitrineHasNumber ? vitrineMaterial : specularPower);
  gl_FragData[2] = vec4(diffuseColor, gl_FragData[0].r);
  gl_FragData[3] = vec4(specularColor, gl_FragData[0].g);
  gl_FragData[4] = vec4(ambientColor, gl_FragData[0].b);
  gl_FragData[0] = vec4(vertexVC.xyz, vitrineHasNumber ? VITRINE_SHOWS_MATERIAL : VITRINE_SHOWS_PHONG);
