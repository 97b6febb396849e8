// One fragment a tile: the longest list in the tile, and what the whole picture needs.
//
// Only pixels from regionFirst up to, not including, regionEnd count; heads outside are of an earlier frame.
#include "LinkedListRead.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer CounterBuffer
{
  VitrineCounters counters;
};

uniform ivec2 regionFirst;
uniform ivec2 regionEnd;

layout(location = 0) out uint tileMax;

// Add `n` to a split sum.
void addPages(int shift, uint n)
{
  atomicAdd(counters.PagesLow[shift], n & ((1u << VITRINE_SPLIT_BITS) - 1u));
  atomicAdd(counters.PagesHigh[shift], n >> VITRINE_SPLIT_BITS);
}

// Bin b holds the tiles whose longest list is at most binLimits[b] nodes, and longer than binLimits[b - 1].
const uint binLimits[VITRINE_BIN_COUNT] = uint[](VITRINE_BIN_LIMITS);

uint binOf(uint count)
{
  uint bin = 0u;
  for (int b = 0; b < VITRINE_BIN_COUNT - 1; ++b)
  {
    bin += count > binLimits[b] ? 1u : 0u;
  }
  return bin;
}

void main()
{
  ivec2 first = max(ivec2(gl_FragCoord.xy) * VITRINE_TILE_SIZE, regionFirst);
  ivec2 end = min((ivec2(gl_FragCoord.xy) + 1) * VITRINE_TILE_SIZE, regionEnd);

  uint longest = 0u;
  uint covered = 0u;
  uvec4 pages = uvec4(0u);
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      uint count = loadHead(ivec2(x, y)).y;
      longest = max(longest, count);
      covered += min(count, 1u);
      pages += (uvec4(count) + uvec4(0u, 1u, 3u, 7u)) >> uvec4(0u, 1u, 2u, 3u);
    }
  }

  tileMax = longest;
  if (longest > 0u)
  {
    atomicMax(counters.LayersMax, longest);
    atomicAdd(counters.CoveredPixels, covered);
    atomicOr(counters.TileBins, 1u << binOf(longest));
    for (int shift = 0; shift < 4; ++shift)
    {
      addPages(shift, pages[shift]);
    }
  }
}
