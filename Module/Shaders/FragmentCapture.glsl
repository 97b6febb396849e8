// Prepares a fragment for all methods that store fragments. It reads the depth and colour of a mapper's fragment and
// the opaque depth; it yields the depth, colour and coverage to store. It is joined to the fragment shaders of
// VTK's mappers at //VTK::DepthPeeling::Dec.
//
// VITRINE_WRITES_DEPTH         the mapper's shader writes gl_FragDepth, which early tests would ignore
// VITRINE_SAMPLES n            samples of the target, 0 if it is single-sampled
// VITRINE_POST_DEPTH_COVERAGE  gl_SampleMaskIn has the samples that pass the depth test
// VITRINE_FIXED_POINT_TARGET   the target clamps colours to [0, 1] before it blends
// VITRINE_ADDITIVE             some mappers' fragments are additive: they hide nothing behind them
// VITRINE_LEAST_ALPHA a        smaller alphas may be stored as 0; the default is 0
// VITRINE_OPAQUE_DEPTH_STEPS s steps of a depth buffer of at most 24 bits, else 0.0
// VITRINE_OPAQUE_INTEGERS      the depth buffer has more bits, and is read as 32-bit integers
// VITRINE_OPAQUE_DEPTH_LOSS l  largest loss of other depth buffers when they are sampled
//
// A method may rasterise into a target of its own, where hidden fragments must not reach the tests. Before this file it
// defines:
// VITRINE_LATE_TESTS           the opaque depth is only compared here
// VITRINE_PIXEL p              the pixel of the opaque depth
// VITRINE_RASTER_DEPTH z       the rasteriser's depth at that pixel
// VITRINE_TAKES_HIDDEN         there is no opaque depth: hidden fragments are taken, too

#include "SharedLayout.h"

#if !defined(VITRINE_TAKES_HIDDEN) && \
  (defined(VITRINE_WRITES_DEPTH) || defined(VITRINE_LATE_TESTS) || \
    (VITRINE_SAMPLES > 0 && !defined(VITRINE_POST_DEPTH_COVERAGE)))
#define VITRINE_TESTS_DEPTH
#endif
#ifndef VITRINE_LATE_TESTS
#define VITRINE_PIXEL ivec2(gl_FragCoord.xy)
#define VITRINE_RASTER_DEPTH gl_FragCoord.z
#endif

#if !defined(VITRINE_WRITES_DEPTH) && !defined(VITRINE_LATE_TESTS)
layout(early_fragment_tests) in;
#if VITRINE_SAMPLES > 0 && defined(VITRINE_POST_DEPTH_COVERAGE)
layout(post_depth_coverage) in;
#endif
#endif

#ifdef VITRINE_TESTS_DEPTH
#if VITRINE_SAMPLES > 0
uniform sampler2DMS vitrineOpaqueDepth;
#elif defined(VITRINE_OPAQUE_INTEGERS)
uniform usamplerBuffer vitrineOpaqueDepth; // depths in row-major order
uniform int vitrineOpaqueWidth;
#else
uniform sampler2D vitrineOpaqueDepth;
#endif

// Returns true if opaque geometry hides the depth `z` in sample `s`. The comparison is GL_LEQUAL in the depth buffer's
// own steps.
#ifdef VITRINE_OPAQUE_INTEGERS
// Llvmpipe stores twice the depth in 31 bits, rounded down; 1.0 is one less. Converted to a float, the stored integer
// is the original value again. This also holds if a driver stores the nearest 32-bit integer, since a float has only 24
// significant bits.
bool vitrineHidden(float z, int s)
{
  ivec2 pixel = VITRINE_PIXEL;
  uint opaque = texelFetch(vitrineOpaqueDepth, pixel.y * vitrineOpaqueWidth + pixel.x).r;
  return 2.0 * floor(z * exp2(31.0)) > float(opaque);
}
#else
bool vitrineHidden(float z, int s)
{
  float opaque = texelFetch(vitrineOpaqueDepth, VITRINE_PIXEL, s).r;
  if (VITRINE_OPAQUE_DEPTH_STEPS > 0.0)
  {
    return roundEven(z * VITRINE_OPAQUE_DEPTH_STEPS) > roundEven(opaque * VITRINE_OPAQUE_DEPTH_STEPS);
  }
  return z > opaque + VITRINE_OPAQUE_DEPTH_LOSS;
}
#endif
#endif

#if VITRINE_SAMPLES > 0
// The region of pixels to draw. The scissor test is not used, since llvmpipe loses samples along its edges.
uniform ivec2 vitrineRegionFirst;
uniform ivec2 vitrineRegionEnd;
#endif

// Returns the samples of the pixel in which a fragment of depth `z` is visible, one bit each.
uint vitrineCoverage(float z)
{
#if VITRINE_SAMPLES > 0
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool inRegion = all(greaterThanEqual(pixel, vitrineRegionFirst)) && all(lessThan(pixel, vitrineRegionEnd));
  uint covered = inRegion ? uint(gl_SampleMaskIn[0]) : 0u;
#ifdef VITRINE_TESTS_DEPTH
  for (int s = 0; s < VITRINE_SAMPLES; ++s)
  {
    covered &= vitrineHidden(z, s) ? ~(1u << uint(s)) : ~0u;
  }
#endif
  return covered;
#elif defined(VITRINE_TESTS_DEPTH)
  return vitrineHidden(z, 0) ? 0u : 1u;
#else
  return 1u;
#endif
}

// Returns a colour as the target blends it: NaN counts as 0, and a fixed-point target clamps (OpenGL 4.5, 17.3.8).
float vitrineColorComponent(float c)
{
#ifdef VITRINE_FIXED_POINT_TARGET
  return c > 0.0 ? min(c, 1.0) : 0.0;
#else
  return c > 0.0 ? min(c, 65504.0) : 0.0;
#endif
}

#ifdef VITRINE_ADDITIVE
uniform int vitrineAdds; // nonzero if this mapper's fragments are additive
#ifndef VITRINE_LEAST_ALPHA
#define VITRINE_LEAST_ALPHA 0.0
#endif

// An alpha of 0 marks a premultiplied, additive colour. So other fragments of this alpha get no colour.
vec4 vitrineAddedOrSeen(vec4 c)
{
  return vitrineAdds != 0 ? vec4(c.a * c.rgb, 0.0) : vec4(c.a > VITRINE_LEAST_ALPHA ? c.rgb : vec3(0.0), c.a);
}
#else
#define vitrineAddedOrSeen(c) c
#endif

vec4 vitrineColor(vec4 c)
{
  vec4 clamped = vec4(vitrineColorComponent(c.r), vitrineColorComponent(c.g), vitrineColorComponent(c.b),
    c.a > 0.0 ? min(c.a, 1.0) : 0.0);
  return vitrineAddedOrSeen(clamped);
}

// Clamps a window depth to [0, 1]. Floats that are not negative have the order of their bits.
float vitrineDepth(float z)
{
  return z > 0.0 ? min(z, 1.0) : 0.0;
}

// Returns a depth as it is kept: nodes of either kind must tell the same order. Depths of 1/128 and more are as they
// are but for the last ones.
float vitrineKeptDepth(float z)
{
  return z < VITRINE_FIRST_FLOAT_DEPTH ? floor(z * VITRINE_DEPTH_STEPS) * (1.0 / VITRINE_DEPTH_STEPS)
                                       : min(z, VITRINE_LAST_DEPTH);
}

// Returns the fragment's depth. A depth that the mapper's shader writes is tested here. The depth buffer's test comes
// after the store and must not discard the fragment, so the written depth becomes 0, the nearest.
#ifdef VITRINE_WRITES_DEPTH
float vitrineTakeDepth()
{
  float z = vitrineDepth(gl_FragDepth);
  gl_FragDepth = 0.0;
  return z;
}
#else
float vitrineTakeDepth()
{
  return vitrineDepth(VITRINE_RASTER_DEPTH);
}
#endif

#ifdef VITRINE_COINCIDENCE
#include "Coincidence.glsl"
#endif
