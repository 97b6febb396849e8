// Stencil masks, repair pass. It reads the composited layers, their errors and the counts, and writes the repaired
// picture over the backdrop. A marked pixel becomes the mean of itself and its 12 nearest neighbours, weighted by
// distance and by their errors. Neighbours with the least error count fully. The backdrop is each pixel's own.
//
// Korostelev, Dolgovesov, Mazurok, 2011.
//
// VITRINE_SHOW_MARKS  shows the errors as grey
#include "StencilMasks.glsl"
#include "ResolveOutput.glsl"

uniform sampler2D layerColors;
uniform sampler2D layerErrors; // output of StencilMaskMark.glsl
uniform sampler2D pixelCounts;
uniform ivec2 firstPixel;      // first pixel of the layers in the target
uniform ivec2 lastPixel;       // last pixel of the layers

float errorOf(ivec2 pixel)
{
  return floor(texelFetch(layerErrors, pixel, 0).r * 255.0 + 0.5) * 0.25;
}

// The 12 nearest neighbours.
const ivec2 steps[12] = ivec2[12](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1),
  ivec2(1, -1), ivec2(-1, -1), ivec2(2, 0), ivec2(-2, 0), ivec2(0, 2), ivec2(0, -2));

ivec2 neighbourOf(ivec2 pixel, int i)
{
  return clamp(pixel + steps[i], ivec2(0), lastPixel);
}

// Returns true if both pixels have as many fragments at their centres. Neighbours across an edge show something else.
bool isAlike(ivec2 pixel, ivec2 neighbour)
{
  return texelFetch(pixelCounts, neighbour, 0).r == texelFetch(pixelCounts, pixel, 0).r;
}

// Returns the layers of a pixel, repaired by the first `count` neighbours. The count is 0 for an unmarked pixel.
// Software rasterisers run both sides of a branch, but only the needed turns of a loop.
vec4 repaired(ivec2 pixel, int count)
{
  float least = VITRINE_MOST_ERROR;
  for (int i = 0; i < count; ++i)
  {
    ivec2 neighbour = neighbourOf(pixel, i);
    least = isAlike(pixel, neighbour) ? min(least, errorOf(neighbour)) : least;
  }
  vec4 own = texelFetch(layerColors, pixel, 0);
  vec4 sum = own;
  float weights = 1.0;
  for (int i = 0; i < count; ++i)
  {
    ivec2 neighbour = neighbourOf(pixel, i);
    float weight = exp(-0.5 * float(steps[i].x * steps[i].x + steps[i].y * steps[i].y));
    weight *= errorOf(neighbour) == least ? 1.0 : VITRINE_WORSE_NEIGHBOUR;
    weight = isAlike(pixel, neighbour) ? weight : 0.0;
    sum += weight * texelFetch(layerColors, neighbour, 0);
    weights += weight;
  }
  // If no neighbour is better, nothing is gained.
  return least < VITRINE_MARKED ? sum / weights : own;
}

void main()
{
  ivec2 target = ivec2(gl_FragCoord.xy);
  ivec2 pixel = target - firstPixel;
  float error = errorOf(pixel);
#ifdef VITRINE_SHOW_MARKS
  writeOver(LOAD_BACKDROP(target), vec3(error / VITRINE_MOST_ERROR), 0.0);
#else
  vec4 layers = repaired(pixel, error >= VITRINE_MARKED ? 12 : 0);
  if (layers == vec4(0.0, 0.0, 0.0, 1.0))
  {
    discard;
  }
  writeOver(LOAD_BACKDROP(target), layers.rgb, layers.a);
#endif
}
