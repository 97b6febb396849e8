// Method `truth`, fragment shader: reads one sample of each pixel of the picture and writes it to the target. The
// region is clipped here. The scissor test is not used, since llvmpipe then loses samples of some pixels along its
// edges and draws samples of others outside.
uniform sampler2D source;
uniform ivec2 regionFirst;
uniform ivec2 regionEnd;
#if VITRINE_SAMPLES > 0
uniform int sampleNumber;
#endif

layout(location = 0) out vec4 outColor;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (any(lessThan(pixel, regionFirst)) || any(greaterThanEqual(pixel, regionEnd)))
  {
    discard;
  }
#if VITRINE_SAMPLES > 0
  if (gl_SampleID != sampleNumber)
  {
    discard;
  }
#endif
  outColor = texelFetch(source, pixel, 0);
}
