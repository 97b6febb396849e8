// What all lights have given.
  diffuse = vitrineLightSumAt(VITRINE_LIGHT_SUM_DIFFUSE);
  specular = vitrineLightSumAt(VITRINE_LIGHT_SUM_SPECULAR);
