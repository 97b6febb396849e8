// The heads of packed lists in compute shaders. It reads a pixel's count, and writes the start and the size of its room
// (SharedLayout.h).
#include "SharedLayout.h"

#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(rg32ui, binding = VITRINE_IMAGE_HEADS) uniform uimage2D heads;
uint loadCount(ivec2 pixel)
{
  return imageLoad(heads, pixel).y >> VITRINE_COUNT_SHIFT;
}
void storeRoom(ivec2 pixel, uint start, uint room)
{
  imageStore(heads, pixel, uvec4(start, room, 0u, 0u));
}
#else
layout(r32ui, binding = VITRINE_IMAGE_HEADS) uniform uimage2D heads;
uint loadCount(ivec2 pixel)
{
  return imageLoad(heads, pixel * ivec2(1, 2) + ivec2(0, 1)).x >> VITRINE_COUNT_SHIFT;
}
void storeRoom(ivec2 pixel, uint start, uint room)
{
  ivec2 texel = pixel * ivec2(1, 2);
  imageStore(heads, texel, uvec4(start));
  imageStore(heads, texel + ivec2(0, 1), uvec4(room));
}
#endif
