// What one light gives, before the material takes it.
  gl_FragData[0] = vec4(diffuse, 1.0);
  gl_FragData[1] = vec4(specular, 1.0);
  return;
