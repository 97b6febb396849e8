// Reading the lists that LinkedListFill*.glsl wrote.
#include "SharedLayout.h"
#include "NodePool.glsl"

uniform usampler2D heads;
uniform usamplerBuffer nodes; // one texel a node
uniform usamplerBuffer links; // one texel a page: the page before it

// Newest page and number of fragments of a pixel.
uvec2 loadHead(ivec2 pixel)
{
#ifdef VITRINE_FRAMEBUFFER_FETCH
  return texelFetch(heads, pixel, 0).xy;
#else
  ivec2 texel = ivec2(pixel.x, 2 * pixel.y);
  return uvec2(texelFetch(heads, texel, 0).x - 1u, texelFetch(heads, texel + ivec2(0, 1), 0).x);
#endif
}

// The same of the pixel that is drawn, which is left as it is where it has no fragments.
uvec2 loadHeadToDraw(ivec2 pixel)
{
  uvec2 head = loadHead(pixel);
  if (head.y == 0u)
  {
    discard;
  }
  return head;
}

// Nodes in the newest page of a list of `count` fragments; all other pages are full.
int nodesInNewestPage(uint count)
{
  return int((count - 1u) & uint(VITRINE_PAGE_SIZE - 1)) + 1;
}

int pagesOfList(uint count)
{
  return int((count + uint(VITRINE_PAGE_SIZE - 1)) / uint(VITRINE_PAGE_SIZE));
}

uint loadLink(uint page)
{
  return texelFetch(links, int(page)).x;
}
