// Replaces VTK's text for a light: reads the diffuse and specular sums of all lights.
  diffuse = vitrineLightSumAt(VITRINE_LIGHT_SUM_DIFFUSE);
  specular = vitrineLightSumAt(VITRINE_LIGHT_SUM_SPECULAR);
