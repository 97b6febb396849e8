// Replaces VTK's text for a light: reads the sum of reflected radiance of all lights.
  Lo = vitrineLightSumAt(VITRINE_LIGHT_SUM_DIFFUSE);
