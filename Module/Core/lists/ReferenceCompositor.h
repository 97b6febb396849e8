#ifndef VITRINE_CORE_LISTS_REFERENCE_COMPOSITOR_H
#define VITRINE_CORE_LISTS_REFERENCE_COMPOSITOR_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A translucent fragment as the truth method captures it: 32 bytes, the layout of its GPU buffer. */
struct CapturedFragment
{
  /** The bit of Pixel that says that the fragment is added to what is behind it, and hides nothing of it. */
  static constexpr std::uint32_t Added = 1u << 31;

  std::uint32_t Pixel; ///< y * width + x, row 0 at the bottom; with Added or without
  float Depth;   ///< window depth in [0, 1], 0 nearest; with an extent the near end of an interval
  float Rgba[4]; ///< not premultiplied
  std::uint32_t Coverage; ///< bit s: covers sample s (1 where pixels have one sample)
  float Extent = 0.0f;    ///< length of the interval within which others coincide; 0: none does
};
static_assert(sizeof(CapturedFragment) == 32, "the GPU writes fragments without padding");

/** What the target of the judged methods can hold, and so what colours mean. */
enum class TargetRange
{
  Unit,       ///< fixed point: colours are clamped to [0, 1]
  NonNegative ///< floating point: colours are clamped to [0, infinity)
};

/**
 * The CPU half of the yardstick: composites captured fragments over a backdrop in float64, front to
 * back, for each sample of each pixel, without bounds on the number of layers.
 *
 * In a sample with the fragments 1 to n from front to back (T. Porter, T. Duff: Compositing digital
 * images, SIGGRAPH 1984):
 *
 *     T_i = (1 - alpha_1) ... (1 - alpha_i)
 *     rgb = sum of T_(i-1) alpha_i rgb_i + T_n backdrop.rgb
 *     a   = (1 - T_n) + T_n backdrop.a
 *
 * A fragment that is added counts in rgb as the others do, and with an alpha of 0 in all T.
 *
 * Fragments of equal depth are ordered by packed colour, ascending: (a, b, g, r) as floats of 16 bits, then as they
 * are, those that are added by premultiplied colour and an alpha of 0; so the result does not depend on the order of arrival, to the last bit. NaN counts as 0 in depth and in colour; alpha is clamped to
 * [0, 1], colours to the range of the target; -0 equals 0. Coverage of samples that the picture does
 * not have is ignored.
 *
 * Fragments that have an extent are intervals of depth, from Depth to Depth + Extent, added in 32-bit float. In each
 * sample, those whose intervals meet, by themselves or through others between them, are composited as a CoincidentGroup: as
 * the mean over all orders. So their order does not matter, to the last bit, and neither does noise of their depths below the extent.
 */
class ReferenceCompositor
{
public:
  /**
   * @param backdrop  what lies behind the fragments: height * width * samples premultiplied RGBA
   *                  values, rows from the bottom, a pixel's samples side by side
   * @throws std::invalid_argument if the backdrop's size does not match, or with samples not in 1..32
   */
  ReferenceCompositor(
    int width, int height, int samples, TargetRange range, std::vector<double> backdrop);

  /**
   * Composites fragments, in any order. A batch holds all fragments of the pixels it touches.
   * @throws std::invalid_argument if a pixel lies outside the picture or was in an earlier batch;
   *         the batch is then ignored as a whole
   */
  void AddBatch(const CapturedFragment* fragments, std::size_t count);

  /** The picture so far, in the backdrop's layout. */
  const std::vector<double>& Samples() const { return this->Picture; }

  /** The picture so far with the samples of each pixel averaged: height * width RGBA values. */
  std::vector<double> Resolve() const;

  /** Fragments in all batches. */
  std::uint64_t FragmentCount() const { return this->Fragments; }

  /** The largest number of fragments in a pixel. */
  std::uint64_t LayersMax() const { return this->DeepestPixel; }

  /** The mean number of fragments over the pixels that have any; 0 if none has. */
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
