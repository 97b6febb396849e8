// Stencil routing, resolve pass for pixels with any number of fragments. It reads and sorts them block by block, and
// writes the composited colour.
//
// K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
#include "StencilRoutedRead.glsl"
#include "ResolveOutput.glsl"

// The walk over the pixel's fragments.
ivec2 pixel;
int count;
int next;

void startWalk()
{
  next = 0;
}

bool isWalking()
{
  return next < count;
}

#define NEXT_FRAGMENT(f) f = loadFragment(pixel, next++, count);

#include "CompositeBlocks.glsl"

void main()
{
  pixel = ivec2(gl_FragCoord.xy);
  count = loadCountToDraw(pixel);
  vec3 color;
  float transmittance;
  compositeBlocks(color, transmittance);
  writeOver(LOAD_BACKDROP(pixel), color, transmittance);
}
