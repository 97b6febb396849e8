  // The mask of outlines: writes the number of the part in 24 bits, and marks the fragment in the last channel.
  {
    uint vitrineMasked = vitrineNumber;
    if (vitrineMasked == 0u)
    {
      discard;
    }
    uvec3 vitrineBytes = uvec3(vitrineMasked, vitrineMasked >> 8, vitrineMasked >> 16) & 255u;
    gl_FragData[0] = vec4(vec3(vitrineBytes) / 255.0, 1.0);
  }
