// A-buffer, before the resolve pass, with one fragment for each tile. It reads the heads, writes the longest list in
// the tile, and adds the tile to the frame's counters.
//
// Only the pixels regionFirst to regionEnd - 1 count. Heads outside are of an earlier frame.
#include "ListRead.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer CounterBuffer
{
  VitrineCounters counters;
};

#ifdef VITRINE_PACKED_LISTS
// For each block of pixels.
layout(r32ui, binding = VITRINE_IMAGE_BLOCKS) writeonly uniform uimage2D longestLists;
#endif

#ifdef VITRINE_HIDDEN_DEPTHS
#include "HiddenNow.glsl"
layout(std430, binding = VITRINE_BINDING_BOUNDS) coherent buffer BoundsBuffer
{
  VitrineErrorBounds bounds;
};

// All of a pixel without fragments may have been cut. The resolve does not see such a pixel.
void checkEmptyPixel(ivec2 pixel)
{
  if (hiddenWordOf(pixel) > 0u)
  {
    atomicMax(bounds.Largest, floatBitsToUint(1.0));
  }
}
#define CHECK_PIXEL(pixel, count) \
  if (count == 0u) \
  { \
    checkEmptyPixel(pixel); \
  }
#else
#define CHECK_PIXEL(pixel, count)
#endif

uniform ivec2 regionFirst;
uniform ivec2 regionEnd;

// The tile's longest list, or 0 if nodes may be missing in the tile. Such tiles must not be resolved.
layout(location = 0) out uint tileMax;

// Lists end in garbage if the pool was too small.
#ifdef VITRINE_PACKED_LISTS
#define IS_INCOMPLETE (tooLong > 0u)
#else
#define IS_INCOMPLETE (counters.NextPage[VITRINE_PAGES_MISSING] > 0u)
#endif

// Adds `n` to a split sum.
void addPages(int shift, uint n)
{
  atomicAdd(counters.PagesLow[shift], n & ((1u << VITRINE_SPLIT_BITS) - 1u));
  atomicAdd(counters.PagesHigh[shift], n >> VITRINE_SPLIT_BITS);
}

// Bin b holds the tiles whose longest list has at most binLimits[b] nodes, but more than binLimits[b - 1].
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

// The sums over the pixels of a tile.
uint longest = 0u;
uint covered = 0u;
uint tooLong = 0u;
uvec4 pages = uvec4(0u);

// Adds the pixels `first` to `end` - 1 to the sums. Returns their longest list.
uint takeBlock(ivec2 first, ivec2 end)
{
  uint longestOfBlock = 0u;
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      uint count = loadHead(ivec2(x, y)).y;
      CHECK_PIXEL(ivec2(x, y), count)
      longestOfBlock = max(longestOfBlock, count);
      covered += min(count, 1u);
      tooLong += IS_TOO_LONG(count) ? 1u : 0u;
      pages += PAGES_OF(count);
    }
  }
  longest = max(longest, longestOfBlock);
  return longestOfBlock;
}

void main()
{
  ivec2 tile = ivec2(gl_FragCoord.xy) * VITRINE_TILE_SIZE;
  ivec2 tileEnd = min(tile + VITRINE_TILE_SIZE, regionEnd);
  for (int y = tile.y; y < tileEnd.y; y += VITRINE_BLOCK_SIZE)
  {
    for (int x = tile.x; x < tileEnd.x; x += VITRINE_BLOCK_SIZE)
    {
      ivec2 block = ivec2(x, y);
      uint longestOfBlock = takeBlock(max(block, regionFirst), min(block + VITRINE_BLOCK_SIZE, tileEnd));
#ifdef VITRINE_PACKED_LISTS
      imageStore(longestLists, block / VITRINE_BLOCK_SIZE, uvec4(longestOfBlock));
#endif
    }
  }

  tileMax = IS_INCOMPLETE ? 0u : longest;
  if (longest > 0u)
  {
    atomicMax(counters.LayersMax, longest);
    atomicAdd(counters.CoveredPixels, covered);
    atomicAdd(counters.ShortPixels, tooLong);
    atomicOr(counters.TileBins, 1u << binOf(longest));
    for (int shift = 0; shift < 4; ++shift)
    {
      addPages(shift, pages[shift]);
    }
  }
}
