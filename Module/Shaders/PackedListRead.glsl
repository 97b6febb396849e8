// Packed lists, as ListRead.glsl walks them: successive nodes, of which a page is a piece, named by its first node. The
// pieces are taken from the last to the first, since the page that a walk begins with alone may be partly filled.
uint listStart; // of the pixel whose head was loaded last
uint listRoom;  // and how many nodes it has

// The last piece of the pixel's list, and its number of fragments.
uvec2 loadHead(ivec2 pixel)
{
#ifdef VITRINE_FRAMEBUFFER_FETCH
  uvec2 head = texelFetch(heads, pixel, 0).xy;
#else
  ivec2 texel = ivec2(pixel.x, 2 * pixel.y);
  uvec2 head = uvec2(texelFetch(heads, texel, 0).x, texelFetch(heads, texel + ivec2(0, 1), 0).x);
#endif
  uint count = head.y >> VITRINE_COUNT_SHIFT;
  listStart = head.x;
  listRoom = head.y & VITRINE_LARGEST_COUNT;
  return uvec2(listStart + ((count - 1u) & ~uint(VITRINE_PAGE_SIZE - 1)), count);
}

uint nextPage(uint page)
{
  return page == listStart ? VITRINE_END : page - uint(VITRINE_PAGE_SIZE);
}

uint nodeIndex(uint page, uint slot)
{
  return page + slot;
}

// Whether the pixel whose head was loaded last has more fragments than there was room for.
#define IS_TOO_LONG(count) (count > listRoom)
#define PAGES_OF(count) uvec4(count, 0u, 0u, 0u)
