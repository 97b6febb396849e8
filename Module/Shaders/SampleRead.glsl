// Reads one sample of each pixel of an image and writes it to the output.
#if VITRINE_SAMPLES > 0
uniform sampler2DMS source;
#else
uniform sampler2D source;
#endif
uniform int sampleNumber; // 0 for a single-sampled backdrop, where it is the mipmap level

layout(location = 0) out vec4 outColor;

void main()
{
  outColor = texelFetch(source, ivec2(gl_FragCoord.xy), sampleNumber);
}
