// Packed lists, fragment shader: gives each pixel of a block the room that ScanPrediction.glsl predicted, but none
// beyond the end of the buffer. It reads the scanned sums and draws the heads, since software rasterisers draw several
// times faster than they store to images.
#include "ScanSums.glsl"

uniform int capacity; // capacity of the buffer in nodes

#ifdef VITRINE_FRAMEBUFFER_FETCH
out uvec2 head;
#define HEAD(start, room) uvec2(start, room)
#define ROWS 1
#else
out uint head; // rows of starts and rows of rooms alternate
#define HEAD(start, room) (int(gl_FragCoord.y) % 2 == 0 ? start : room)
#define ROWS 2
#endif

void main()
{
  const int side = VITRINE_BLOCK_SIZE;
  ivec2 pixel = ivec2(gl_FragCoord.xy) / ivec2(1, ROWS);
  ivec2 column = pixel / side - blockFirst;
  int block = column.y * blockCount.x + column.x;
  ivec2 inBlock = pixel & (side - 1);
  uint room = sums[ofBlocks + block];
  uint place = addSaturating(sums[block], room * uint(inBlock.y * side + inBlock.x));
  uint start = min(place, uint(capacity));
  head = HEAD(start, min(room, uint(capacity) - start));
}
