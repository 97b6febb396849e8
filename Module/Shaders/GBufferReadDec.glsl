// What the G-buffer has of the pixel, or of the sample that is shaded.
#include "GBufferSample.glsl"

#if VITRINE_SAMPLES > 0
#define VITRINE_SAMPLE gl_SampleID
#else
#define VITRINE_SAMPLE 0
#endif

vec4 vitrineGBufferAt(int layer)
{
  return vitrineGBufferSample(layer, VITRINE_SAMPLE);
}
