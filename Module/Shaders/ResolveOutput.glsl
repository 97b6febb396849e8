// The end of a resolve pass. It reads the backdrop and writes the composited colour over it, in float, with a single
// rounding. Blending in the target would round three times in 8 bits.
//
// VITRINE_ALL_SAMPLES  the shader runs once for a pixel. Its outputs are the colours of the samples, one image each.
#ifdef VITRINE_ALL_SAMPLES
uniform sampler2DMS backdrop;
#define IN_SAMPLE(node) true
#define FRAGMENT_IN_SAMPLE(f) true

layout(location = 0) out vec4 outColors[VITRINE_SAMPLES]; // premultiplied

#define WRITE_SAMPLE(s, reds, greens, blues, transmittances, i) \
  outColors[s] = vec4(reds[i], greens[i], blues[i], 1.0 - transmittances[i]) + \
    transmittances[i] * texelFetch(backdrop, pixel, s);
#define WRITE_TWO(s, i) \
  WRITE_SAMPLE(s, red0, green0, blue0, left0, i) \
  WRITE_SAMPLE(s + 1, red0, green0, blue0, left0, i + 1)
#define WRITE_FOUR_MORE \
  WRITE_SAMPLE(4, red1, green1, blue1, left1, 0) \
  WRITE_SAMPLE(5, red1, green1, blue1, left1, 1) \
  WRITE_SAMPLE(6, red1, green1, blue1, left1, 2) \
  WRITE_SAMPLE(7, red1, green1, blue1, left1, 3)
#if VITRINE_SAMPLES == 8
#define WRITE_COMPOSITE WRITE_TWO(0, 0) WRITE_TWO(2, 2) WRITE_FOUR_MORE
#elif VITRINE_SAMPLES == 4
#define WRITE_COMPOSITE WRITE_TWO(0, 0) WRITE_TWO(2, 2)
#else
#define WRITE_COMPOSITE WRITE_TWO(0, 0)
#endif
#else
#if VITRINE_SAMPLES > 0
uniform sampler2DMS backdrop;
#define LOAD_BACKDROP(pixel) texelFetch(backdrop, pixel, gl_SampleID)
#define IN_SAMPLE(node) ((nodeExtra(node) >> uint(gl_SampleID) & 1u) != 0u)
#define FRAGMENT_IN_SAMPLE(f) ((f.extra >> uint(gl_SampleID) & 1u) != 0u)
#else
uniform sampler2D backdrop;
#define LOAD_BACKDROP(pixel) texelFetch(backdrop, pixel, 0)
#define IN_SAMPLE(node) true
#define FRAGMENT_IN_SAMPLE(f) true
#endif

out vec4 outColor; // premultiplied

void writeOver(vec4 behind, vec3 color, float transmittance)
{
  outColor = vec4(color, 1.0 - transmittance) + transmittance * behind;
}
#ifndef TELL_BOUND
#define TELL_BOUND(pixel, behind)
#define TELL_HIDDEN(pixel)
#endif
#define WRITE_COMPOSITE \
  vec4 behind = LOAD_BACKDROP(pixel); \
  writeOver(behind, color, transmittance); \
  TELL_HIDDEN(pixel) \
  TELL_BOUND(pixel, behind)
#endif
