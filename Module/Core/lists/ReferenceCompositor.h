/**
 * The reference compositor of method `truth`, and its input.
 */
#ifndef VITRINE_CORE_LISTS_REFERENCE_COMPOSITOR_H
#define VITRINE_CORE_LISTS_REFERENCE_COMPOSITOR_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A translucent fragment as captured by the truth method: 32 bytes, in the layout of its GPU buffer. */
struct CapturedFragment
{
  /** The bit of Pixel that marks an additive fragment, which hides nothing behind it. */
  static constexpr std::uint32_t Added = 1u << 31;

  std::uint32_t Pixel; ///< y * width + x, row 0 at the bottom; may have the bit Added
  float Depth;   ///< window depth in [0, 1], 0 is nearest; with an extent, the interval's near end
  float Rgba[4]; ///< not premultiplied
  std::uint32_t Coverage; ///< bit s is set if sample s is covered; 1 without multisampling
  float Extent = 0.0f;    ///< length of the interval within which fragments coincide; 0 means none
};
static_assert(sizeof(CapturedFragment) == 32, "the GPU writes fragments without padding");

/** The range of colours that the render target of the tested methods can hold. */
enum class TargetRange
{
  Unit,               ///< fixed point: colours are clamped to [0, 1]
  UnitWithAddedLight, ///< the same, where some fragments are added; their codes are floats
  NonNegative         ///< floating point: colours are clamped to [0, infinity)
};

/**
 * The CPU part of the truth method, the reference for all other methods. It composites captured fragments over a
 * backdrop in float64, front to back, for each sample of each pixel. The number of layers is not limited.
 *
 * For the fragments 1 to n of a sample, from front to back (T. Porter, T. Duff: Compositing digital images, SIGGRAPH
 * 1984):
 *
 *     T_i = (1 - alpha_1) ... (1 - alpha_i)
 *     rgb = sum of T_(i-1) alpha_i rgb_i + T_n backdrop.rgb
 *     a   = (1 - T_n) + T_n backdrop.a
 *
 * An additive fragment contributes to rgb like any other, but its alpha counts as 0 in each T.
 *
 * Fragments of equal depth are ordered by ascending colour (a, b, g, r): first as methods store them
 * (Core/lists/StoredColor; 16-bit floats in floating-point targets and beside added light), then in full precision.
 * Additive fragments are ordered by premultiplied colour and an alpha of 0. Hence the result does not depend on the
 * order of arrival, to the last bit.
 *
 * Input is sanitized. NaN in depth or colour becomes 0, and -0 equals 0. Alpha is clamped to [0, 1], colours to the
 * range of the target. Coverage of samples that the picture does not have is ignored.
 *
 * A fragment with an extent is the interval from Depth to Depth + Extent, added in 32-bit float. In each sample,
 * fragments whose intervals overlap, directly or through others, are composited as a CoincidentGroup: as the mean over
 * all orders. Hence neither their order nor depth noise below the extent affects the result, to the last bit.
 */
class ReferenceCompositor
{
public:
  /**
   * @param backdrop  the colours behind the fragments: height * width * samples premultiplied RGBA values, rows from
   *                  the bottom, the samples of a pixel adjacent
   * @throws std::invalid_argument if the backdrop's size does not match, or if samples is not in 1 to 32
   */
  ReferenceCompositor(
    int width, int height, int samples, TargetRange range, std::vector<double> backdrop);

  /**
   * Composites fragments in any order. A batch contains all fragments of the pixels that it touches.
   * @throws std::invalid_argument if a pixel lies outside the picture or was in an earlier batch. The whole batch is
   *          then ignored.
   */
  void AddBatch(const CapturedFragment* fragments, std::size_t count);

  /** Returns the picture so far, in the layout of the backdrop. */
  const std::vector<double>& Samples() const { return this->Picture; }

  /** Returns the picture so far with the samples of each pixel averaged: height * width RGBA values. */
  std::vector<double> Resolve() const;

  /** Returns the number of fragments in all batches. */
  std::uint64_t FragmentCount() const { return this->Fragments; }

  /** Returns the largest number of fragments in a pixel. */
  std::uint64_t LayersMax() const { return this->DeepestPixel; }

  /** Returns the mean number of fragments of the pixels that have any, or 0 if none has. */
  double LayersMean() const;

private:
  struct PixelLists;
  PixelLists SortByPixel(const CapturedFragment* fragments, std::size_t count) const;
  void CompositePixels(const CapturedFragment* fragments, const PixelLists& lists,
    std::size_t firstPixel, std::size_t lastPixel);

  std::size_t PixelCount;
  std::size_t SamplesPerPixel;
  TargetRange Range;
  std::vector<double> Picture;
  std::vector<bool> IsComposited; // by pixel
  std::uint64_t Fragments = 0;
  std::uint64_t CoveredPixels = 0;
  std::uint64_t DeepestPixel = 0;
};

}

#endif
