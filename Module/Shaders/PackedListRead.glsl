// Reads packed lists for ListRead.glsl. It reads heads. A page is a piece of VITRINE_PAGE_SIZE successive nodes, named
// by its first node. Pages are visited from the last to the first, since only the first page of a walk may be partly
// filled.
uint listStart; // start of the list whose head was loaded last
uint listRoom;  // capacity of its room in nodes

// Returns the last page of the pixel's list, and its number of fragments.
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

// Returns true if the pixel whose head was loaded last has more fragments than room.
#define IS_TOO_LONG(count) (count > listRoom)
#define PAGES_OF(count) uvec4(count, 0u, 0u, 0u)
