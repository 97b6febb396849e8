/**
 * Constants and buffer layouts that C++ and GLSL share: the one place where each stands.
 *
 * GLSL reads this file by #include (cmake/ComposeShader.cmake), C++ as a header.
 */
#ifndef VITRINE_SHADERS_SHARED_LAYOUT_H
#define VITRINE_SHADERS_SHARED_LAYOUT_H

// Binding points of shader storage buffers. OpenGL 4.3 guarantees 8.
#define VITRINE_BINDING_CLUSTERS 4
#define VITRINE_BINDING_COUNTERS 4
#define VITRINE_BINDING_BOUNDS 5
#define VITRINE_BINDING_SUMS 6
#define VITRINE_BINDING_CAPTURE 7

// Binding points of images, of which OpenGL 4.3 guarantees 8: the heads, where atomics or compute shaders write them,
// the longest list of each block, the nodes' buffers (FragmentNode.glsl), the links of pages, the words of parts, the
// bounds of pixels' errors, and the depths behind which pixels hide all.
#define VITRINE_IMAGE_HEADS 0
#define VITRINE_IMAGE_BLOCKS 1
#define VITRINE_IMAGE_NODES 2
#define VITRINE_IMAGE_THIRD_WORDS 3
#define VITRINE_IMAGE_LINKS 4
#define VITRINE_IMAGE_PARTS 5
#define VITRINE_IMAGE_BOUNDS 6
#define VITRINE_IMAGE_HIDDEN 7
#define VITRINE_IMAGE_HIDDEN_OUT 6 // of a compute shader, which has no bounds

// Ends a list. No page has this number.
#define VITRINE_END 0xffffffffu

// Node pool: 16 pages in a row are interleaved slot by slot. Neighbouring pixels take pages one after the other, so
// they write and read whole cache lines.
#define VITRINE_INTERLEAVE_SHIFT 4

// Node pool: on software rasterisers it has several sub-pools, each with a counter of its own. Each screen bin has one
// of them. Llvmpipe draws a bin by one thread, so threads seldom share a counter or a cache line of nodes.
#define VITRINE_SUB_POOLS 16
#define VITRINE_BIN_SIZE 64       // pixels a side, as llvmpipe's
#define VITRINE_COUNTER_STRIDE 16 // words from one sub-pool's counter to the next: a cache line
#define VITRINE_PAGES_MISSING (VITRINE_SUB_POOLS * VITRINE_COUNTER_STRIDE)

// Packed lists: the buffer stores pixels by blocks of VITRINE_BLOCK_SIZE a side, which divides VITRINE_TILE_SIZE. The
// scan adds VITRINE_SCAN_FANOUT sums into one, level by level.
#define VITRINE_BLOCK_SIZE 4
#define VITRINE_SCAN_FANOUT 128

// The head of a packed list has two words: where its room begins, and its number of fragments (high bits) with its room
// in fragments (low bits). VITRINE_LARGEST_COUNT stands for itself and all larger numbers.
#define VITRINE_COUNT_SHIFT 16
#define VITRINE_LARGEST_COUNT 0xffffu

// Resolve: the longest list of a tile decides which program resolves its pixels. A tile has this many pixels a side.
#define VITRINE_TILE_SIZE 16

// With a tolerance for coincidence, one word of a node holds the covered samples (low half) and the extent of the
// fragment's interval of depths (high half: the upper 16 bits of a 32-bit float).
#define VITRINE_COVERAGE_MASK 0xffffu
#define VITRINE_EXTENT_MASK 0xffff0000u
#define VITRINE_COINCIDENCE_SAMPLES 16

// Stored colours of targets with colours in [0, 1] (PackedColor.glsl, CompactNode.glsl). A colour in [0, 1] has
// VITRINE_COLOR_LEVELS coarse levels, the largest number whose cube fits into 26 bits, and each level has
// 2^VITRINE_FINE_COLOR_BITS fine steps, together 16 bits. An alpha has a code of 16 bits: those of a float of 4 bits of
// exponent and 12 of mantissa. To the alpha an offset is added, so that an alpha of 0 has the bits of the base. Its
// coarse code has VITRINE_FINE_ALPHA_BITS less. Coarse codes are rounded, not cut off.
#define VITRINE_COLOR_LEVELS 406
#define VITRINE_FINE_COLOR_BITS 7
#define VITRINE_FINE_COLOR_STEPS 51840.0 // (VITRINE_COLOR_LEVELS - 1) << VITRINE_FINE_COLOR_BITS
#define VITRINE_FINE_ALPHA_BITS 4
#define VITRINE_ALPHA_SHIFT 11
#define VITRINE_ALPHA_OFFSET (1.0 / 32768.0)
#define VITRINE_ALPHA_BASE 0x38000000u

// Fragments of equal depth are ordered by coarse codes first, so that nodes of either kind have one order. Two 16-bit
// codes, an alpha's or a colour's and a colour's below it, become coarse by VITRINE_COARSE_ROUNDING and the mask.
#define VITRINE_COARSE_ALPHA_COLOR_ROUNDING 0x00080040u
#define VITRINE_COARSE_ALPHA_COLOR_MASK 0xfff0ff80u
#define VITRINE_COARSE_COLORS_ROUNDING 0x00400040u
#define VITRINE_COARSE_COLORS_MASK 0xff80ff80u

// Depths are kept in 26 bits' worth of values (CompactDepth.glsl): below the first float depth in steps of 2^-30, and
// 1 and the last two before it are one.
#define VITRINE_FIRST_FLOAT_DEPTH 0.0078125
#define VITRINE_DEPTH_STEPS 1073741824.0
#define VITRINE_LAST_DEPTH (1.0 - 1.0 / 8388608.0)

// How far stored colours and alphas are from those of the fragments: colours in [0, 1] by a difference, alphas by a
// share of themselves. Faint alphas are off by VITRINE_FAINT_ROUNDING more. Coarse codes are rounded from fine ones, so
// theirs is half a fine step more.
#define VITRINE_HALF_COLOR_ROUNDING (0.51 / VITRINE_FINE_COLOR_STEPS) // in single precision
#define VITRINE_HALF_ALPHA_ROUNDING (1.0 / 8192.0)
#define VITRINE_COMPACT_COLOR_ROUNDING (64.51 / VITRINE_FINE_COLOR_STEPS)
#define VITRINE_COMPACT_ALPHA_ROUNDING (1.0625 / 512.0)
#define VITRINE_FAINT_ROUNDING (1.0 / 8388608.0)
// A device may round a value to 8 bits that lies this near to the middle either way.
#define VITRINE_DEVICE_ROUNDING (0.005 / 255.0)

// The word of a part: its number (scene/PartNumbers), and this bit on back faces.
#define VITRINE_BACK_FACE 0x80000000u

// Texels of four floats that tell how a cut part looks (section/CutTables), and the patterns of its hatch.
#define VITRINE_CUT_LOOK_TEXELS 2
#define VITRINE_HATCH_LINES 1
#define VITRINE_HATCH_PAIRS 2
#define VITRINE_HATCH_DASHES 3
#define VITRINE_HATCH_CROSS 4
#define VITRINE_HATCH_LEVEL 5
#define VITRINE_HATCH_DOTS 6

// The opacity of opaque parts in an x-ray, which makes them translucent, and the least that stands for opaque.
#define VITRINE_XRAY_ALMOST_OPAQUE 0.9995
#define VITRINE_XRAY_OPAQUE 0.999

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace vitrine
{
using uint = std::uint32_t;
#endif

/**
 * A sum that may pass 2^32 is split into two words: value = Low + 2^VITRINE_SPLIT_BITS * High. Low adds the lowest bits
 * of the addends, High the rest of each. Each tile adds one addend. With 10 bits neither word wraps:
 *  - Low: the largest image has 32768 x 32768 pixels, or 2^22 tiles, and 2^22 * (2^10 - 1) < 2^32.
 *  - High: the limit is a sum of 2^42. That is 16384 fragments in each pixel of 16384 x 16384, or 4096 in each pixel of
 *    32768 x 32768. The addend stays below 2^32 up to 2^24 fragments in each pixel of the tile.
 */
#define VITRINE_SPLIT_BITS 10

/** The counters of a frame, std430. */
struct VitrineCounters
{
  uint LayersMax;     // Largest number of fragments in one pixel.
  uint CoveredPixels; // Number of pixels with at least one fragment.
  uint TileBins;      // Bit b is set if some tile falls into bin b.
  uint
    PagesLow[4]; // Split sums of the pages that all lists need, with pages of 1, 2, 4 and 8 nodes.
  uint PagesHigh[4];
  uint ShortPixels; // Packed lists: number of pixels with more fragments than room.
  // Linked lists: every VITRINE_COUNTER_STRIDE-th word is the next free page of a sub-pool. It counts on past the end.
  // The last word is nonzero if some page was not in the pool.
  uint NextPage[VITRINE_PAGES_MISSING + 1];
};

/** What is known of the errors of a frame's pixels, std430. */
struct VitrineErrorBounds
{
  uint
    Largest;   // Bits of the largest bound, as a float, among those that are not tolerated; else 0.
  uint Hidden; // Fragments behind the depths that hide them, in a frame that was not cut; else 0.
};

/** The counters of truth's capture, std430. The number of fragments is Fragments + 2^32 * Wraps. */
struct VitrineCaptureCounters
{
  uint Fragments; // The next free place. It counts on past the end of the buffer.
  uint Wraps;     // How often Fragments passed 2^32.
};

/** Flag in VitrineCapturedFragment::Pixel: the fragment is blended additively, and attenuates nothing behind it. */
#define VITRINE_ADDED_FRAGMENT 0x80000000u

/** A fragment as truth captures it: non-premultiplied colour and window depth; std430, 32 bytes. */
struct VitrineCapturedFragment
{
  uint Pixel; // y * width of the target + x; VITRINE_ADDED_FRAGMENT may be set.
  float Depth;
  float Red;
  float Green;
  float Blue;
  float Alpha;
  uint Coverage; // Bit s is set if sample s is covered.
  float Extent;  // Depths within this distance coincide. With 0 none does.
};

// Kinds of layers, in VitrineLayerFragment::Kind. An added fragment attenuates nothing behind it. A tested one is known
// to be in front of all opaque ones. Bits above these tell the place of the prop in the order of drawing, and on
// the CPU that of the block.
#define VITRINE_OPAQUE_LAYER 1
#define VITRINE_ADDED_LAYER 2
#define VITRINE_TESTED_LAYER 4
#define VITRINE_FIRST_DRAW_BIT 3

/** A fragment of a layer (LayerFillImpl.glsl, LayerLists.glsl): non-premultiplied colour, window depth; std430. */
struct VitrineLayerFragment
{
  uint Pixel; // y * width + x, from the lower left pixel of the rectangle that was asked for
  float Depth;
  float Red;
  float Green;
  float Blue;
  float Alpha;
  uint Coverage; // Bit s is set if sample s is covered.
  uint Part;     // VITRINE_BACK_FACE may be set.
  uint Kind;
  uint
    Primitive; // The place of its primitive in the draw call, which counts among opaque fragments.
};

/**
 * A light in view coordinates (VC), as VTK's shaders have it: four texels of a buffer texture, RGBA32F. The first two
 * texels suffice to tell that a point is out of reach.
 */
struct VitrineLight
{
  float Position[3];
  float
    SquaredRange; // The largest float or infinity if there is no limit; negative if the light is not positional.
  float Direction[3];
  // Lower bound of the cosine between Direction and points within the cone, times the length of Direction. It is 0 or
  // less if there is no cone.
  float LeastCosine;
  float Color[3];  // Diffuse colour times intensity.
  float ConeAngle; // In degrees. From 90 on there is no cone.
  float Attenuation[3];
  float Exponent;
};
#define VITRINE_LIGHT_TEXELS 4

/** The list of a cluster: one texel of a buffer texture, RG32UI. */
struct VitrineLightList
{
  uint First; // Index of the first entry in the lists of all clusters.
  uint Count;
};

/** A material of Phong's model: three texels of a buffer texture, RGBA32F. */
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

// The G-buffer of deferred shading has layers of four floats a pixel. The first layer holds the position in view
// coordinates (VC) and the kind of surface (VITRINE_SHOWS_...). If every surface has one material of Phong's model,
// only the first two layers exist.
//
//         x y z                        w
// place   position                     kind of surface
// normal  normal                       specular power, roughness, or the number of a material
// base    diffuse colour, or albedo    factor.x, or metallic; a finished surface has its colour here
// gloss   specular colour, or F90      factor.y, or F0
// own     ambient colour, or emissive  factor.z, or the strength of occlusion
//
// Textures multiply the lit colour by the factor.
#define VITRINE_GBUFFER_PLACE 0
#define VITRINE_GBUFFER_NORMAL 1
#define VITRINE_GBUFFER_BASE 2
#define VITRINE_GBUFFER_GLOSS 3
#define VITRINE_GBUFFER_OWN 4
#define VITRINE_GBUFFER_LAYERS 5
#define VITRINE_GBUFFER_LAYERS_OF_MATERIALS 2

// Light volumes add up two sums a pixel: Phong's diffuse and specular light. Physically based surfaces use only the
// first, for radiance.
#define VITRINE_LIGHT_SUM_DIFFUSE 0
#define VITRINE_LIGHT_SUM_SPECULAR 1
#define VITRINE_LIGHT_SUM_LAYERS 2

#define VITRINE_SHOWS_NOTHING 0.0
#define VITRINE_SHOWS_FINISHED 1.0
#define VITRINE_SHOWS_PHONG 2.0
#define VITRINE_SHOWS_PHYSICAL 3.0
#define VITRINE_SHOWS_MATERIAL 4.0 // Phong's model, with the number of a material

#ifdef __cplusplus
static_assert(sizeof(VitrineLight) == 16 * VITRINE_LIGHT_TEXELS, "texels of four floats");
static_assert(offsetof(VitrineLight, Direction) == 16, "texels of four floats");
static_assert(offsetof(VitrineLight, Color) == 32, "texels of four floats");
static_assert(offsetof(VitrineLight, Attenuation) == 48, "texels of four floats");
static_assert(sizeof(VitrineLightList) == 8, "a texel of two words");
static_assert(sizeof(VitrineMaterial) == 16 * VITRINE_MATERIAL_TEXELS, "texels of four floats");
static_assert(sizeof(VitrineCapturedFragment) == 32, "std430 layout");
static_assert(offsetof(VitrineCapturedFragment, Coverage) == 24, "std430 layout");
static_assert(sizeof(VitrineLayerFragment) == 40, "std430 layout");
static_assert(sizeof(VitrineCaptureCounters) == 8, "std430 layout");
static_assert(sizeof(VitrineCounters) == 52 + 64 * VITRINE_SUB_POOLS, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesLow) == 12, "std430 layout");
static_assert(offsetof(VitrineCounters, PagesHigh) == 28, "std430 layout");
static_assert(offsetof(VitrineCounters, ShortPixels) == 44, "std430 layout");
static_assert(offsetof(VitrineCounters, NextPage) == 48, "std430 layout");
static_assert(VITRINE_TILE_SIZE % VITRINE_BLOCK_SIZE == 0, "blocks lie within tiles");

/** Returns the value of a split sum. */
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
