// The heads of packed lists, read and written by compute shaders: where a pixel's room ends, and where its next
// fragment goes.
#ifdef VITRINE_FRAMEBUFFER_FETCH
layout(rg32ui, binding = VITRINE_IMAGE_HEADS) uniform uimage2D heads;
uvec2 loadRoom(ivec2 pixel)
{
  return imageLoad(heads, pixel).xy;
}
void storeRoom(ivec2 pixel, uint end, uint next)
{
  imageStore(heads, pixel, uvec4(end, next, 0u, 0u));
}
#else
layout(r32ui, binding = VITRINE_IMAGE_HEADS) uniform uimage2D heads;
uvec2 loadRoom(ivec2 pixel)
{
  ivec2 texel = pixel * ivec2(1, 2);
  return uvec2(imageLoad(heads, texel).x, imageLoad(heads, texel + ivec2(0, 1)).x);
}
void storeRoom(ivec2 pixel, uint end, uint next)
{
  ivec2 texel = pixel * ivec2(1, 2);
  imageStore(heads, texel, uvec4(end));
  imageStore(heads, texel + ivec2(0, 1), uvec4(next));
}
#endif
