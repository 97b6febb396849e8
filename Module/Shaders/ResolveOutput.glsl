// The end of a resolve pass. It reads the backdrop and writes the composited colour over it, in float, with a single
// rounding. Blending in the target would round three times in 8 bits.
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

void writeOver(ivec2 pixel, vec3 color, float transmittance)
{
  vec4 behind = LOAD_BACKDROP(pixel);
  outColor = vec4(color, 1.0 - transmittance) + transmittance * behind;
}
