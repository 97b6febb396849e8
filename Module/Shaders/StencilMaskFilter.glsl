// Stencil masks, repairing: marked pixels take the mean of themselves and the 12 nearest neighbours, weighted by
// distance and by how good those are. Neighbours with the least error count fully. The backdrop is each pixel's own.
//
// S. Korostelev, Yu. Dolgovesov, B. Mazurok, 2011.
//
// VITRINE_SHOW_MARKS  the errors themselves, as grey
#include "StencilMasks.glsl"
#include "ResolveOutput.glsl"

uniform sampler2D layerColors;
uniform sampler2D layerErrors; // of StencilMaskMark.glsl
uniform sampler2D pixelCounts;
uniform ivec2 firstPixel;      // of the target, where the layers begin
uniform ivec2 lastPixel;       // of the layers

float errorOf(ivec2 pixel)
{
  return floor(texelFetch(layerErrors, pixel, 0).r * 255.0 + 0.5) * 0.25;
}

// One of the 12 nearest, with as many fragments at its centre: what lies across an edge is another picture.
bool isNeighbour(ivec2 pixel, ivec2 offset)
{
  int steps = abs(offset.x) + abs(offset.y);
  ivec2 neighbour = clamp(pixel + offset, ivec2(0), lastPixel);
  return (steps == 1 || steps == 2) &&
    texelFetch(pixelCounts, neighbour, 0).r == texelFetch(pixelCounts, pixel, 0).r;
}

vec4 repaired(ivec2 pixel)
{
  float least = VITRINE_MOST_ERROR;
  for (int y = -2; y <= 2; ++y)
  {
    for (int x = -2; x <= 2; ++x)
    {
      ivec2 offset = ivec2(x, y);
      float error = errorOf(clamp(pixel + offset, ivec2(0), lastPixel));
      least = isNeighbour(pixel, offset) ? min(least, error) : least;
    }
  }
  vec4 sum = texelFetch(layerColors, pixel, 0);
  float weights = 1.0;
  for (int y = -2; y <= 2; ++y)
  {
    for (int x = -2; x <= 2; ++x)
    {
      ivec2 offset = ivec2(x, y);
      ivec2 neighbour = clamp(pixel + offset, ivec2(0), lastPixel);
      float weight = exp(-0.5 * float(x * x + y * y));
      weight *= errorOf(neighbour) == least ? 1.0 : VITRINE_WORSE_NEIGHBOUR;
      weight = isNeighbour(pixel, offset) ? weight : 0.0;
      sum += weight * texelFetch(layerColors, neighbour, 0);
      weights += weight;
    }
  }
  // Where no neighbour is any better, nothing is won.
  return least < VITRINE_MARKED ? sum / weights : texelFetch(layerColors, pixel, 0);
}

void main()
{
  ivec2 target = ivec2(gl_FragCoord.xy);
  ivec2 pixel = target - firstPixel;
  float error = errorOf(pixel);
#ifdef VITRINE_SHOW_MARKS
  writeOver(target, vec3(error / VITRINE_MOST_ERROR), 0.0);
#else
  vec4 layers = texelFetch(layerColors, pixel, 0);
  if (error >= VITRINE_MARKED)
  {
    layers = repaired(pixel);
  }
  if (layers == vec4(0.0, 0.0, 0.0, 1.0))
  {
    discard;
  }
  writeOver(target, layers.rgb, layers.a);
#endif
}
