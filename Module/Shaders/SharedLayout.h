/**
 * Constants and buffer layouts that C++ and GLSL share: the one place where each stands.
 *
 * GLSL reads this file by #include (cmake/ComposeShader.cmake), C++ as a header.
 */
#ifndef VITRINE_SHARED_LAYOUT_H
#define VITRINE_SHARED_LAYOUT_H

// Binding points of shader storage buffers.
#define VITRINE_BINDING_COUNTERS 4
#define VITRINE_BINDING_NODES 5
#define VITRINE_BINDING_LINKS 6
#define VITRINE_BINDING_CAPTURE 7

// Binding point of the image of heads, where heads are set by image atomics.
#define VITRINE_IMAGE_HEADS 0

// Ends a list: no page has this number.
#define VITRINE_END 0xffffffffu

// Node pool: pages of 16 successive numbers are interleaved, slot by slot, so that neighbouring pixels,
// which take pages one after the other, write and read whole cache lines.
#define VITRINE_INTERLEAVE_SHIFT 4

// Resolve: pixels are binned by the longest list in their tile of this many pixels a side.
#define VITRINE_TILE_SIZE 16

// The longest list that one network over named registers sorts. Longer ones are sorted in runs, which are merged
// all at once; beyond that many runs, block by block.
#define VITRINE_LONGEST_NETWORK 64
#define VITRINE_RUN_SIZE 32
#define VITRINE_RUN_GROUP 8
#define VITRINE_MAX_RUNS 32
#define VITRINE_MERGE_BLOCK 32

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace vitrine
{
using uint = std::uint32_t;
#endif

/**
 * What a frame counts, std430. Sums that may pass 2^32 are kept as two: the low 16 bits of each addend
 * and the rest, so that value = Low + 65536 * High.
 */
struct VitrineCounters
{
  uint PagesUsed;     // the allocator: next free page; counts on past the end of the pool
  uint LayersMax;     // most fragments in one pixel
  uint CoveredPixels; // pixels with at least one fragment
  uint TileBins;      // bit b is set if some tile falls into bin b
  uint PagesLow[4];   // pages that the counts ask for with pages of 1, 2, 4 and 8 nodes
  uint PagesHigh[4];
};

/** A fragment as the yardstick captures it: non-premultiplied colour, window depth; std430, 28 bytes. */
struct VitrineCapturedFragment
{
  uint Pixel; // y * width of the target + x
  float Depth;
  float Red;
  float Green;
  float Blue;
  float Alpha;
  uint Coverage; // bit s: sample s is covered
};

#ifdef __cplusplus
static_assert(sizeof(VitrineCapturedFragment) == 28, "std430 layout");
static_assert(offsetof(VitrineCapturedFragment, Coverage) == 24, "std430 layout");
static_assert(sizeof(VitrineCounters) == 48, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesLow) == 16, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesHigh) == 32, "std430 layout");
}
#endif

#endif
