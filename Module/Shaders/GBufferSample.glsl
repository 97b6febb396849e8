// What the G-buffer has of a sample of the pixel; where it is not multisampled there is number 0 alone.
#include "SharedLayout.h"

#if VITRINE_SAMPLES > 0
uniform sampler2DMSArray vitrineGBuffer;
#else
uniform sampler2DArray vitrineGBuffer;
#endif

vec4 vitrineGBufferSample(int layer, int number)
{
  return texelFetch(vitrineGBuffer, ivec3(ivec2(gl_FragCoord.xy), layer), number);
}
