// Vertex shader with one instance for each tile. It reads the tile's longest list and writes the tile's quad if the
// length is in (binRange.x, binRange.y]. The quad is clipped to the region here. The scissor test is not used, since
// llvmpipe then loses samples of some pixels along its edges and draws samples of others outside.
#include "SharedLayout.h"

uniform usampler2D tileMax;
uniform ivec2 tileFirst;
uniform ivec2 tileCount;
uniform ivec2 binRange;
uniform ivec2 targetSize; // in pixels
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
