  vec2 vitrineSlope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
