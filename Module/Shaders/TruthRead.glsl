// Reads one sample of each pixel of the backdrop for the yardstick.
#if VITRINE_SAMPLES > 0
uniform sampler2DMS source;
#else
uniform sampler2D source;
#endif
uniform int sampleNumber; // 0 of a single-sampled backdrop, which is its level

layout(location = 0) out vec4 outColor;

void main()
{
  outColor = texelFetch(source, ivec2(gl_FragCoord.xy), sampleNumber);
}
