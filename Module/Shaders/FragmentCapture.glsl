// What every method that stores fragments does with one before it is stored. Joined to the fragment
// shaders of VTK's mappers at //VTK::DepthPeeling::Dec.
//
// VITRINE_WRITES_DEPTH         the mapper's shader writes gl_FragDepth: early tests would ignore that
// VITRINE_SAMPLES n            samples of the target, 0 if it is single-sampled
// VITRINE_POST_DEPTH_COVERAGE  gl_SampleMaskIn tells the samples that pass the depth test
// VITRINE_FIXED_POINT_TARGET   the target clamps colours to [0, 1] before it blends
// VITRINE_ADDITIVE             some mappers' fragments are added to what is behind them, and hide nothing of it
// VITRINE_LEAST_ALPHA a        alphas below may be stored as 0; by default none but 0 itself
// VITRINE_OPAQUE_DEPTH_STEPS s steps of a depth buffer of at most 24 bits, else 0.0
// VITRINE_OPAQUE_INTEGERS      the depth buffer has more bits, and comes as integers of 32
// VITRINE_OPAQUE_DEPTH_LOSS l  what any other depth buffer may lose when it is sampled
//
// A method that rasterises into a target of its own, where hidden fragments must not reach the tests, defines before:
// VITRINE_LATE_TESTS           the opaque depth is compared here alone
// VITRINE_PIXEL p              the pixel of the opaque depth
// VITRINE_RASTER_DEPTH z       the depth that the rasteriser has there

#if defined(VITRINE_WRITES_DEPTH) || defined(VITRINE_LATE_TESTS) || \
  (VITRINE_SAMPLES > 0 && !defined(VITRINE_POST_DEPTH_COVERAGE))
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
uniform usamplerBuffer vitrineOpaqueDepth; // row by row
uniform int vitrineOpaqueWidth;
#else
uniform sampler2D vitrineOpaqueDepth;
#endif

// True if opaque geometry hides the depth `z` in sample `s`, as GL_LEQUAL decides in the depth buffer's own steps.
#ifdef VITRINE_OPAQUE_INTEGERS
// llvmpipe stores 31 bits, rounded down, twice; 1.0 is one less. As a float that is what it came from, as it is where a
// driver stores the nearest of 32 bits: a float has no more than 24 of them.
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
// The pixels to draw. The scissor test does not cut them out, since llvmpipe loses samples along its edges.
uniform ivec2 vitrineRegionFirst;
uniform ivec2 vitrineRegionEnd;
#endif

// The samples of the pixel in which a fragment of depth `z` is seen, one bit each.
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

// Colours as the target blends them: NaN counts as 0, and a fixed-point target clamps (OpenGL 4.5, 17.3.8).
float vitrineColorComponent(float c)
{
#ifdef VITRINE_FIXED_POINT_TARGET
  return c > 0.0 ? min(c, 1.0) : 0.0;
#else
  return c > 0.0 ? min(c, 65504.0) : 0.0;
#endif
}

#ifdef VITRINE_ADDITIVE
uniform int vitrineAdds; // whether this mapper's fragments are
#ifndef VITRINE_LEAST_ALPHA
#define VITRINE_LEAST_ALPHA 0.0
#endif

// An alpha of 0 says that the colour is premultiplied and added. So others of that alpha have no colour.
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

// Window depth in [0, 1]; floats that are not negative order as their bits do.
float vitrineDepth(float z)
{
  return z > 0.0 ? min(z, 1.0) : 0.0;
}

// The fragment's depth. One that the mapper's shader wrote is tested here, not in the depth buffer: what the depth
// test would throw away after the shader has stored it must not be, so there it counts as nearest.
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
