// Writes one light's reflected radiance, to be added.
  gl_FragData[0] = vec4(Lo, 1.0);
  gl_FragData[1] = vec4(0.0);
  return;
