// One instance a tile: the tile's quad if its longest list is in (binRange.x, binRange.y], else nothing. The
// quad is cut to the region here and not by the scissor test, along whose edges llvmpipe loses samples of some
// pixels and draws samples of others outside.
#include "SharedLayout.h"

uniform usampler2D tileMax;
uniform ivec2 tileFirst;
uniform ivec2 tileCount;
uniform ivec2 binRange;
uniform ivec2 targetSize; // pixels
uniform ivec2 regionFirst;
uniform ivec2 regionEnd;

void main()
{
  ivec2 tile = tileFirst + ivec2(gl_InstanceID % tileCount.x, gl_InstanceID / tileCount.x);
  int longest = int(min(texelFetch(tileMax, tile, 0).x, 0x7fffffffu));
  ivec2 corner = (tile + ivec2(gl_VertexID & 1, gl_VertexID >> 1)) * VITRINE_TILE_SIZE;
  vec2 ndc = vec2(clamp(corner, regionFirst, regionEnd)) / vec2(targetSize) * 2.0 - 1.0;
  gl_Position = longest > binRange.x && longest <= binRange.y ? vec4(ndc, 0.0, 1.0) : vec4(-2.0, -2.0, 0.0, 1.0);
}
