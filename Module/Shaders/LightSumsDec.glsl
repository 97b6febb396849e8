// Reads the sums over light volumes at the pixel, or at the shaded sample.
#if VITRINE_SAMPLES > 0
uniform sampler2DMSArray vitrineLightSums;
#else
uniform sampler2DArray vitrineLightSums;
#endif

vec3 vitrineLightSumAt(int layer)
{
  return texelFetch(vitrineLightSums, ivec3(ivec2(gl_FragCoord.xy), layer), VITRINE_SAMPLE).xyz;
}
