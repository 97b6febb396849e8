// A-buffer, after the resolve pass of a multisampled target: writes each sample of a pixel that has fragments. It reads
// the colours that the resolve left in an image for each sample.
#include "ListRead.glsl"

uniform sampler2DArray sampleColors; // a layer for each sample

out vec4 outColor; // premultiplied

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  loadHeadToDraw(pixel);
  outColor = texelFetch(sampleColors, ivec3(pixel, gl_SampleID), 0);
}
