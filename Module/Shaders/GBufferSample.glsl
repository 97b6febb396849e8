// Reads a layer of the G-buffer at sample `number` of the pixel. Without multisampling, the number is 0.
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
