/**
 * Constants and buffer layouts that C++ and GLSL share: the one place where each stands.
 *
 * GLSL reads this file by #include (cmake/ComposeShader.cmake), C++ as a header.
 */
#ifndef VITRINE_SHADERS_SHARED_LAYOUT_H
#define VITRINE_SHADERS_SHARED_LAYOUT_H

// Binding points of shader storage buffers, of which OpenGL 4.3 has 8. Packed lists have sums in place of links.
#define VITRINE_BINDING_CLUSTERS 4
#define VITRINE_BINDING_COUNTERS 4
#define VITRINE_BINDING_NODES 5
#define VITRINE_BINDING_LINKS 6
#define VITRINE_BINDING_SUMS 6
#define VITRINE_BINDING_CAPTURE 7

// Binding points of images: of heads, where atomics or compute shaders set them, and of blocks' longest lists.
#define VITRINE_IMAGE_HEADS 0
#define VITRINE_IMAGE_BLOCKS 1

// Ends a list: no page has this number.
#define VITRINE_END 0xffffffffu

// Node pool: pages of 16 successive numbers are interleaved, slot by slot, so that neighbouring pixels,
// which take pages one after the other, write and read whole cache lines.
#define VITRINE_INTERLEAVE_SHIFT 4

// Packed lists: pixels lie in the buffer by blocks of this many a side, a divisor of VITRINE_TILE_SIZE. Sums of the
// blocks' fragments are scanned level by level, this many to one.
#define VITRINE_BLOCK_SIZE 4
#define VITRINE_SCAN_FANOUT 128

// A packed list's head: where its room begins, and in one word its number of fragments (high bits) and its room in
// fragments (low bits). The largest number stands for itself and all that are larger.
#define VITRINE_COUNT_SHIFT 16
#define VITRINE_LARGEST_COUNT 0xffffu

// Resolve: pixels are binned by the longest list in their tile of this many pixels a side.
#define VITRINE_TILE_SIZE 16

// The longest list that one network over named registers sorts. Longer ones are sorted in runs, which are merged
// all at once; beyond that many runs of this size, runs are longer.
#define VITRINE_LONGEST_NETWORK 64
#define VITRINE_RUN_SIZE 32
#define VITRINE_RUN_GROUP 8
#define VITRINE_MAX_RUNS 32

// With a tolerance for coincidence a word holds what covers and how far: a fragment's samples in the low half, and in the
// high half that of the 32-bit float that is the extent of its interval of depths.
#define VITRINE_COVERAGE_MASK 0xffffu
#define VITRINE_EXTENT_MASK 0xffff0000u
#define VITRINE_COINCIDENCE_SAMPLES 16

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace vitrine
{
using uint = std::uint32_t;
#endif

/**
 * Sums that may pass 2^32 are kept as two words: value = Low + 2^VITRINE_SPLIT_BITS * High, where Low sums the
 * lowest bits of the addends and High the rest of each. There is one addend a tile. With 10 bits neither word
 * wraps
 *  - Low: in the largest image there is, 32768 x 32768 or 2^22 tiles: 2^22 * (2^10 - 1) < 2^32;
 *  - High: below sums of 2^42, which is 16384 fragments in each pixel of 16384 x 16384, or 4096 in each of
 *    32768 x 32768. The addend itself stays below 2^32 below 2^24 fragments in each pixel of the tile.
 */
#define VITRINE_SPLIT_BITS 10

/** What a frame counts, std430. */
struct VitrineCounters
{
  uint
    PagesUsed; // the allocator: next free page; counts on past the end of the pool, even past 2^32
  uint LayersMax;     // most fragments in one pixel
  uint CoveredPixels; // pixels with at least one fragment
  uint TileBins;      // bit b is set if some tile falls into bin b
  uint PagesLow[4];   // pages that the counts ask for with pages of 1, 2, 4 and 8 nodes: split sums
  uint PagesHigh[4];
  uint ShortPixels; // packed lists: pixels with more fragments than room for them
};

/** What the yardstick counts, std430: fragments = Fragments + 2^32 * Wraps. */
struct VitrineCaptureCounters
{
  uint Fragments; // the next free place; counts on past the end
  uint Wraps;     // how often it passed 2^32
};

/** The bit of a captured fragment's pixel that says that the fragment is added to what is behind it, and hides nothing of it. */
#define VITRINE_ADDED_FRAGMENT 0x80000000u

/** A fragment as the yardstick captures it: non-premultiplied colour, window depth; std430, 32 bytes. */
struct VitrineCapturedFragment
{
  uint Pixel; // y * width of the target + x, with VITRINE_ADDED_FRAGMENT or without
  float Depth;
  float Red;
  float Green;
  float Blue;
  float Alpha;
  uint Coverage; // bit s: sample s is covered
  float Extent;  // of the interval within which others coincide; 0: none does
};

/** A light in view coordinates (VC), as VTK's shaders have it: four texels of a buffer texture, RGBA32F. The first two tell what it does not reach. */
struct VitrineLight
{
  float Position[3];
  float SquaredRange; // infinite where it has none; negative of a light that is not positional
  float Direction[3];
  float
    LeastCosine; // of what may be within the cone, times the direction's length; 0 or less where there is no cone
  float Color[3];  // diffuse, times the intensity
  float ConeAngle; // in degrees; from 90 on there is no cone
  float Attenuation[3];
  float Exponent;
};
#define VITRINE_LIGHT_TEXELS 4

/** A cluster's list: a texel of a buffer texture, RG32UI. */
struct VitrineLightList
{
  uint First; // in the lists of all clusters
  uint Count;
};

/** A material by Phong's formulas: three texels of a buffer texture, RGBA32F. */
struct VitrineMaterial
{
  float Diffuse[3];
  float SpecularPower;
  float Specular[3];
  float UnusedAfterSpecular;
  float Ambient[3];
  float UnusedAfterAmbient;
};
#define VITRINE_MATERIAL_TEXELS 3

// The G-buffer of deferred shading: layers of four floats a pixel. The first has the place in view coordinates and what the pixel
// shows: nothing, a surface whose colour is finished, or one to be lit by Phong's formulas or by physically based ones. Where all surfaces are of
// one material each, lit by Phong's formulas, there are the first two layers alone.
//
//         x y z                        w
// place   place                        what it shows
// normal  normal                       specular power, roughness, or the number of a material
// base    diffuse colour, or albedo    factor.x, or metallic      of a finished surface: its colour
// gloss   specular colour, or F90      factor.y, or F0
// own     ambient colour, or emissive  factor.z, or the strength of occlusion
//
// The factor is what textures multiply the lit colour with.
#define VITRINE_GBUFFER_PLACE 0
#define VITRINE_GBUFFER_NORMAL 1
#define VITRINE_GBUFFER_BASE 2
#define VITRINE_GBUFFER_GLOSS 3
#define VITRINE_GBUFFER_OWN 4
#define VITRINE_GBUFFER_LAYERS 5
#define VITRINE_GBUFFER_LAYERS_OF_MATERIALS 2

// What light volumes add up for a pixel of it: diffuse and specular of Phong's formulas, or the radiance of physically based ones.
#define VITRINE_LIGHT_SUM_DIFFUSE 0
#define VITRINE_LIGHT_SUM_SPECULAR 1
#define VITRINE_LIGHT_SUM_LAYERS 2

#define VITRINE_SHOWS_NOTHING 0.0
#define VITRINE_SHOWS_FINISHED 1.0
#define VITRINE_SHOWS_PHONG 2.0
#define VITRINE_SHOWS_PHYSICAL 3.0
#define VITRINE_SHOWS_MATERIAL 4.0 // to be lit by Phong's formulas

#ifdef __cplusplus
static_assert(sizeof(VitrineLight) == 16 * VITRINE_LIGHT_TEXELS, "texels of four floats");
static_assert(offsetof(VitrineLight, Direction) == 16, "texels of four floats");
static_assert(offsetof(VitrineLight, Color) == 32, "texels of four floats");
static_assert(offsetof(VitrineLight, Attenuation) == 48, "texels of four floats");
static_assert(sizeof(VitrineLightList) == 8, "a texel of two words");
static_assert(sizeof(VitrineMaterial) == 16 * VITRINE_MATERIAL_TEXELS, "texels of four floats");
static_assert(sizeof(VitrineCapturedFragment) == 32, "std430 layout");
static_assert(offsetof(VitrineCapturedFragment, Coverage) == 24, "std430 layout");
static_assert(sizeof(VitrineCaptureCounters) == 8, "std430 layout");
static_assert(sizeof(VitrineCounters) == 52, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesLow) == 16, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesHigh) == 32, "std430 layout");
static_assert(offsetof(VitrineCounters, ShortPixels) == 48, "std430 layout");
static_assert(VITRINE_TILE_SIZE % VITRINE_BLOCK_SIZE == 0, "blocks lie within tiles");

/** The value of a split sum. */
constexpr std::int64_t JoinSplitSum(uint low, uint high)
{
  return low + (std::int64_t(high) << VITRINE_SPLIT_BITS);
}

constexpr std::int64_t LargestTileCount =
  std::int64_t(32768 / VITRINE_TILE_SIZE) * (32768 / VITRINE_TILE_SIZE);
static_assert(LargestTileCount * ((1 << VITRINE_SPLIT_BITS) - 1) < (std::int64_t(1) << 32),
  "the sum of the low bits wraps");
static_assert(std::int64_t(1) << (32 + VITRINE_SPLIT_BITS) >= std::int64_t(16384) * 16384 * 16384,
  "the sum of the high bits wraps");
}
#endif

#endif
