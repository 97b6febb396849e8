// Common part of the compute shaders that place packed lists. There is one invocation for each block, or each sum.
#include "ScanSums.glsl"

uniform ivec2 regionFirst; // the region of pixels that get room; other heads are not changed
uniform ivec2 regionEnd;

bool isInRegion(ivec2 pixel)
{
  return all(greaterThanEqual(pixel, regionFirst)) && all(lessThan(pixel, regionEnd));
}

ivec2 blockAt(int i)
{
  return blockFirst + ivec2(i % blockCount.x, i / blockCount.x);
}

// One invocation for each of `count` items, in a grid that may be larger.
layout(local_size_x = 64) in;
#define FOR_ONE_OF(i, count) \
  int i = int(gl_GlobalInvocationID.x + gl_NumWorkGroups.x * 64u * gl_GlobalInvocationID.y); \
  if (i >= count) \
  { \
    return; \
  }
