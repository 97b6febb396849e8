// What all lights have given, reflected.
  Lo = vitrineLightSumAt(VITRINE_LIGHT_SUM_DIFFUSE);
