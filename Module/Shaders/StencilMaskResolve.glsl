// Stencil masks, resolve pass. It reads a pixel's group into named registers, sorts it by an unrolled network, and
// writes the composited colour.
//
// Korostelev, Dolgovesov, Mazurok, 2011.
//
// VITRINE_KEEP_LAYERS  writes the composited layers and the inputs of the marks; else writes over the backdrop
#define VITRINE_FLOAT_KEYS
#include "StencilMasks.glsl"
#include "Registers.glsl"

uniform sampler2D groupColors;
uniform sampler2D groupDepths;
uniform ivec2 firstPixel; // pixel of the first group in the target

#ifdef VITRINE_KEEP_LAYERS
//VTK::Output::Dec
#else
#include "ResolveOutput.glsl"
#endif

#define LOAD(f, slot) \
  { \
    ivec2 texel = group + ivec2(slot % VITRINE_GROUP.x, slot / VITRINE_GROUP.x); \
    f.key = min(texelFetch(groupDepths, texel, 0).r, NO_KEY); \
    f.color = vitrinePackColor(texelFetch(groupColors, texel, 0)); \
    bool there = f.key < NO_KEY; \
    f.color = there ? f.color : 0u; \
    depthSum += there ? f.key : 0.0; \
    count += there ? 1.0 : 0.0; \
  }

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 group = (pixel - firstPixel) * VITRINE_GROUP;
  float depthSum = 0.0;
  float count = 0.0;

  //Vitrine::Declare

  //Vitrine::Load

#include "SortRegisters.glsl"

  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  //Vitrine::Blend

#ifdef VITRINE_KEEP_LAYERS
  gl_FragData[0] = vec4(color, transmittance);
  gl_FragData[1] = vec4(depthSum, count, 0.0, 0.0);
#else
  if (count == 0.0)
  {
    discard;
  }
  writeOver(LOAD_BACKDROP(pixel), color, transmittance);
#endif
}
