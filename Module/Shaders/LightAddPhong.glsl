// Writes one light's diffuse and specular sums, before the material is applied, to be added.
  gl_FragData[0] = vec4(diffuse, 1.0);
  gl_FragData[1] = vec4(specular, 1.0);
  return;
