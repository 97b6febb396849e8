// Writes a finished surface to the G-buffer: one that already has its colour, read from gl_FragData[0].
  gl_FragData[1] = vec4(0.0);
  gl_FragData[2] = gl_FragData[0];
  gl_FragData[3] = vec4(0.0);
  gl_FragData[4] = vec4(0.0);
  gl_FragData[0] = vec4(vec3(0.0), VITRINE_SHOWS_FINISHED);
