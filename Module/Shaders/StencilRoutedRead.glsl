// Stencil routing: reads the fragments of a pixel in order of arrival, from colours, depths and counts.
//
// K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
//
// VITRINE_ROUTED_SAMPLES k  fragments that one geometry pass took, each in a sample of the pass's layer
#define VITRINE_FLOAT_KEYS
#define VITRINE_FLOAT_COLORS
#define VITRINE_NO_DEPTH 3.0e38
#include "Registers.glsl"

#if VITRINE_ROUTED_SAMPLES > 1
#define ROUTED_IMAGES sampler2DMSArray
#define ROUTED_LAYER(i) ((i) / VITRINE_ROUTED_SAMPLES)
#define ROUTED_SAMPLE(i) (VITRINE_ROUTED_SAMPLES - 1 - (i) % VITRINE_ROUTED_SAMPLES)
#else
#define ROUTED_IMAGES sampler2DArray
#define ROUTED_LAYER(i) (i)
#define ROUTED_SAMPLE(i) 0 // mipmap level
#endif

uniform ROUTED_IMAGES routedColors;
uniform ROUTED_IMAGES routedDepths;
uniform sampler2D pixelCounts;
uniform ivec2 firstPixel; // first pixel of the counts in the target
uniform ivec2 binRange;   // pixels to draw have more fragments than x, up to y
uniform int keptLayers;   // maximum number of layers of a pixel

// Returns the number of fragments of the pixel. Discards pixels that another draw resolves.
int loadCountToDraw(ivec2 pixel)
{
  int count = int(texelFetch(pixelCounts, pixel - firstPixel, 0).r * 255.0 + 0.5);
  count = min(count, keptLayers);
  if (count <= binRange.x || count > binRange.y)
  {
    discard;
  }
  return count;
}

// Returns fragment i of the pixel's `count`. Places after the last fragment may hold anything.
Fragment loadFragment(ivec2 pixel, int i, int count)
{
  bool there = i < count;
  ivec3 place = ivec3(pixel, ROUTED_LAYER(there ? i : 0));
  float depth = texelFetch(routedDepths, place, ROUTED_SAMPLE(there ? i : 0)).r;
  vec4 color = texelFetch(routedColors, place, ROUTED_SAMPLE(there ? i : 0));
  Fragment f;
  f.key = there ? depth : NO_KEY;
  f.color = there ? color : vec4(0.0);
  return f;
}
