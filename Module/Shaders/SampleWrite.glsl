// Writes pixels of an image to the target. The sample mask chooses the sample. The region is clipped here. The scissor
// test is not used, since llvmpipe then loses samples of some pixels along its edges and draws samples of others
// outside.
//
// VITRINE_SAMPLE_DEPTH  the pixels are depths
uniform sampler2D source;
uniform ivec2 regionFirst;
uniform ivec2 regionEnd;

#ifndef VITRINE_SAMPLE_DEPTH
layout(location = 0) out vec4 outColor;
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (any(lessThan(pixel, regionFirst)) || any(greaterThanEqual(pixel, regionEnd)))
  {
    discard;
  }
#ifdef VITRINE_SAMPLE_DEPTH
  gl_FragDepth = texelFetch(source, pixel, 0).r;
#else
  outColor = texelFetch(source, pixel, 0);
#endif
}
