  // X-ray: the more a face of a chosen part is turned to the eye, the less opaque it is.
  if (vitrineNumber != 0u)
  {
#if defined(VITRINE_NORMAL)
    float vitrineFacing = abs(dot(VITRINE_NORMAL, vitrineTowardsEye()));
#else
    float vitrineFacing = abs(dot(vitrineFaceNormal(vitrineSlope), vitrineTowardsEye()));
#endif
    float vitrineRim = pow(clamp(1.0 - vitrineFacing, 1e-6, 1.0), vitrineXRay.y);
    // Opaque parts have this opacity, so that they are drawn among translucent ones.
    float vitrineOwn = gl_FragData[0].a > VITRINE_XRAY_OPAQUE ? 1.0 : gl_FragData[0].a;
    gl_FragData[0].a = vitrineOwn * mix(vitrineXRay.x, 1.0, vitrineRim);
  }
