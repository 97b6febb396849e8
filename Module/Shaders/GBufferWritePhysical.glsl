// Writes the inputs of VTK's physically based shading to the G-buffer, instead of lighting.
  gl_FragData[1] = vec4(normalVCVSOutput, roughness);
  gl_FragData[2] = vec4(albedo, metallic);
  gl_FragData[3] = vec4(edgeTintUniform, baseF0Uniform);
  gl_FragData[4] = vec4(emissiveColor, aoStrengthUniform);
  gl_FragData[0] = vec4(vertexVC.xyz, VITRINE_SHOWS_PHYSICAL);
