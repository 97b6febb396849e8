// Packed lists, as ListRead.glsl walks them: successive nodes, of which a page is a piece, named by its first node. The
// pieces are taken from the last to the first, since the page that a walk begins with alone may be partly filled.
//
// A pixel's head is where its room in the buffer ends and where its next fragment would go. The room begins where
// that of the pixel before it ends.
#include "PackedOrder.glsl"

uniform ivec2 blockFirst; // the blocks of pixels whose lists the buffer holds
uniform ivec2 blockCount;

uint listStart; // of the pixel whose head was loaded last

uvec2 loadRoom(ivec2 pixel)
{
#ifdef VITRINE_FRAMEBUFFER_FETCH
  return texelFetch(heads, pixel, 0).xy;
#else
  ivec2 texel = ivec2(pixel.x, 2 * pixel.y);
  return uvec2(texelFetch(heads, texel, 0).x, texelFetch(heads, texel + ivec2(0, 1), 0).x);
#endif
}

// Whether the pixel has more fragments than there was room for.
bool isTooLong(ivec2 pixel)
{
  uvec2 room = loadRoom(pixel);
  return room.y > room.x;
}
#define IS_TOO_LONG(pixel) isTooLong(pixel)

// Where the first list of the block at `corner` begins.
uint startOfBlock(ivec2 corner)
{
  return corner == blockFirst * VITRINE_BLOCK_SIZE ? 0u : loadRoom(pixelBefore(corner, blockFirst, blockCount)).x;
}

// The last piece of the pixel's list, and its number of fragments.
uvec2 loadHead(ivec2 pixel)
{
  bool isFirst = pixel == blockFirst * VITRINE_BLOCK_SIZE;
  listStart = isFirst ? 0u : loadRoom(pixelBefore(pixel, blockFirst, blockCount)).x;
  uint count = loadRoom(pixel).y - listStart;
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
