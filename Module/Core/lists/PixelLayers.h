/** The layers of pixels in order, and how much of each is seen. */
#ifndef VITRINE_CORE_LISTS_PIXEL_LAYERS_H
#define VITRINE_CORE_LISTS_PIXEL_LAYERS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A fragment of a pixel in any order, with the part that it belongs to (Shaders/SharedLayout.h). */
struct LayerFragment
{
  static constexpr std::uint32_t Opaque =
    1; ///< Kind: it hides all that is behind it, and its alpha counts as 1.
  static constexpr std::uint32_t Added =
    2; ///< Kind: it is added to what is behind it, and attenuates nothing.
  static constexpr std::uint32_t Tested =
    4; ///< Kind: it is known to be in front of all opaque ones.
  static constexpr std::uint32_t FirstDrawBit =
    3; ///< Kind: from this bit up, the place of its prop or block in the order of drawing.
  static constexpr std::uint32_t BackFace = 0x80000000u; ///< Flag in Part.

  std::uint32_t Pixel;    ///< Index of the pixel.
  float Depth;            ///< Window depth.
  float Rgba[4];          ///< Not premultiplied.
  std::uint32_t Coverage; ///< Bit s is set if sample s is covered.
  std::uint32_t Part;     ///< Number of the part; BackFace may be set.
  std::uint32_t Kind;
  std::uint32_t
    Primitive; ///< Place of its primitive in the draw call, which counts if it is opaque.
};

/** A fragment in its pixel's order. */
struct PixelLayer
{
  std::uint32_t Fragment; ///< Index of the fragment.
  double
    Share; ///< Share of the pixel's light that it contributes, in [0, 1]: alpha by transmittance.
};

/** The layers of pixels, from front to back. */
struct PixelLayers
{
  /** For each pixel the index of its first layer, and then the number of all layers. */
  std::vector<std::size_t> Offsets;
  std::vector<PixelLayer> Layers;
};

/**
 * Sorts fragments and finds their shares, in 64-bit float, averaged over the samples of a pixel.
 *
 * Among equal depths the rule of the exact methods in targets of 8 bits holds: by alpha, blue, green and red as they
 * are stored (Core/lists/StoredColor); then by part. Translucent fragments are in front of opaque ones of equal depth,
 * since the depth test lets them pass. Of opaque ones, that of the prop or block that was drawn later is in front, as
 * in the depth test, then the part with the larger number, and within a part the later primitive. The order of
 * fragments never counts. Tested fragments are in front of opaque ones at any depth. A depth of NaN counts as 0, as in
 * the methods.
 *
 * @param pixels      the number of pixels; fragments of others are ignored
 * @param samples     samples of a pixel, at least 1
 * @param keepHidden  whether fragments that opaque ones hide in all of their samples are kept, with the share 0
 */
PixelLayers SortLayers(
  const std::vector<LayerFragment>& fragments, std::size_t pixels, int samples, bool keepHidden);

/** A part of one of several ranks, by its number there. */
struct RankPart
{
  std::uint32_t Rank;
  std::uint32_t Part;
};

/**
 * Joins the layers of several ranks, which SortLayers() has ordered on each of them, to fragments that it orders
 * together. Their parts get new numbers: places in `parts`, which is in the order of ranks and numbers.
 *
 * Ranks have no common order of drawing. Of opaque layers of equal depth, those of the rank whose front one has the
 * larger colour are in front, as in the picture of all ranks (Core/ranks/OpaquePixels).
 */
std::vector<LayerFragment> JoinLayers(
  const std::vector<std::vector<LayerFragment>>& ofRanks, std::vector<RankPart>& parts);

/**
 * Returns the index of the first layer of the first part whose layers together have at least `share`, among the layers
 * `first` to `end` - 1 of one pixel. Returns `end` if no part has as much.
 */
std::size_t FirstPartWithShare(const std::vector<LayerFragment>& fragments,
  const PixelLayers& layers, std::size_t first, std::size_t end, double share);

}

#endif
