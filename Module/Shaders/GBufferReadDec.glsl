// What the G-buffer has of a pixel, or of the sample that is shaded.
#include "SharedLayout.h"

#if VITRINE_SAMPLES > 0
uniform sampler2DMSArray vitrineGBuffer;
#define VITRINE_SAMPLE gl_SampleID
#else
uniform sampler2DArray vitrineGBuffer;
#define VITRINE_SAMPLE 0
#endif

vec4 vitrineGBufferAt(int layer)
{
  return texelFetch(vitrineGBuffer, ivec3(ivec2(gl_FragCoord.xy), layer), VITRINE_SAMPLE);
}
