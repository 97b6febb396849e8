// Reads linked lists for ListRead.glsl, from the newest page of a list to its oldest. It reads heads and links.
#include "NodePool.glsl"

uniform usamplerBuffer links; // one texel for each page: the previous page

// Returns the newest page and the number of fragments of a pixel.
uvec2 loadHead(ivec2 pixel)
{
#ifdef VITRINE_FRAMEBUFFER_FETCH
  return texelFetch(heads, pixel, 0).xy;
#else
  ivec2 texel = ivec2(pixel.x, 2 * pixel.y);
  return uvec2(texelFetch(heads, texel, 0).x - 1u, texelFetch(heads, texel + ivec2(0, 1), 0).x);
#endif
}

uint nextPage(uint page)
{
  return texelFetch(links, int(page)).x;
}

uint nodeIndex(uint page, uint slot)
{
  return vitrineNodeIndex(page, slot, uint(VITRINE_PAGE_SIZE));
}

#define IS_TOO_LONG(count) false // only the pool as a whole may be too small

// Returns the numbers of pages of 1, 2, 4 and 8 nodes that a list needs.
#define PAGES_OF(count) ((uvec4(count) + uvec4(0u, 1u, 3u, 7u)) >> uvec4(0u, 1u, 2u, 3u))
