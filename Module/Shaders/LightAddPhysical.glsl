// What one light gives, reflected.
  gl_FragData[0] = vec4(Lo, 1.0);
  gl_FragData[1] = vec4(0.0);
  return;
