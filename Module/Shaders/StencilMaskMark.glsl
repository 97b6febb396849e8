// Stencil masks, mark pass. It reads composited layers, their sums and the counts, and writes how much a pixel differs
// from its neighbours, in quarters.
//
// Korostelev, Dolgovesov, Mazurok, 2011: neighbours are compared by the sum of their layers' depths, the
// parity of their number (closed bodies have an even one), and colour. Each failed test adds an error value. A test
// fails if it fails with most neighbours, since along every edge it fails with some.
//
// Another test needs no neighbours: the group holds as many layers as the stencil counted at the pixel's centre. If the
// pixel has no layers, or more than the group holds, there is nothing to repair.
#include "StencilMasks.glsl"

uniform sampler2D layerColors; // composited colour, premultiplied; transmittance
uniform sampler2D layerSums;   // sum of depths, number of layers
uniform sampler2D pixelCounts;
uniform ivec2 lastPixel;
uniform float depthLimit; // smallest difference of sums of depths that fails
uniform float colorLimit; // smallest distance of colours that fails

//VTK::Output::Dec

// Returns the number of fragments close to the centre of a pixel, at most 255.
float countOf(ivec2 pixel)
{
  return floor(texelFetch(pixelCounts, pixel, 0).r * 255.0 + 0.5);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = texelFetch(layerColors, pixel, 0).rgb;
  vec2 sums = texelFetch(layerSums, pixel, 0).xy;
  float layers = float(VITRINE_GROUP.x * VITRINE_GROUP.y);
  float count = countOf(pixel);
  bool complete = sums.y == min(count, layers);
  bool asksNeighbours = complete && count > 0.0 && count <= layers;

  vec3 failures = vec3(0.0); // failed tests of depth, parity, colour
  int end = asksNeighbours ? 9 : 0; // includes the pixel itself, which passes all tests
  for (int i = 0; i < end; ++i)
  {
    // The picture's edge pixels are repeated outside.
    ivec2 neighbour = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), lastPixel);
    vec2 theirs = texelFetch(layerSums, neighbour, 0).xy;
    vec3 theirColor = texelFetch(layerColors, neighbour, 0).rgb;
    failures += vec3(greaterThanEqual(
      vec3(abs(sums.x - theirs.x), mod(sums.y + theirs.y, 2.0), distance(color, theirColor)),
      vec3(depthLimit, 1.0, colorLimit)));
  }
  vec3 failed = step(vec3(VITRINE_MARK_NEIGHBOURS), failures);
  float error = complete || count > layers ? dot(failed, vec3(0.25, 0.75, 0.5)) : VITRINE_MOST_ERROR;
  gl_FragData[0] = vec4(error * 4.0 / 255.0);
}
