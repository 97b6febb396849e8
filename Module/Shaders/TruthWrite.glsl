// Writes one sample of each pixel of the yardstick's picture into the target.
uniform sampler2D source;
#if VITRINE_SAMPLES > 0
uniform int sampleNumber;
#endif

layout(location = 0) out vec4 outColor;

void main()
{
#if VITRINE_SAMPLES > 0
  if (gl_SampleID != sampleNumber)
  {
    discard;
  }
#endif
  outColor = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
