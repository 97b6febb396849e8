#ifndef VITRINE_CORE_CULLING_SAMPLE_GRID_H
#define VITRINE_CORE_CULLING_SAMPLE_GRID_H

#include "Core/culling/Lanes.h"

#include <cmath>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // about lanes in registers
#endif

namespace vitrine
{

/**
 * Where on the screen something can show at all, in columns and lines of an s-buffer: at the centres of pixels, or, where pixels have
 * several samples, anywhere.
 */
class SampleGrid
{
public:
  /** Anywhere. */
  SampleGrid() = default;

  /** At the centres of pixels, of which a column and a line has so many. */
  static SampleGrid AtCentres(int pixelsPerLine)
  {
    return SampleGrid(static_cast<float>(pixelsPerLine));
  }

  /** How far from its sides a line has no samples. */
  float Inset() const { return 0.5f * this->Width; }

  /** The first place with samples from `place` on; of such a place, itself. */
  float From(float place) const
  {
    if (!(this->Pixels > 0.0f))
    {
      return place;
    }
    const float number = std::ceil(place * this->Pixels - 0.5f);
    if (this->IsExact)
    {
      return (number + 0.5f) * this->Width;
    }
    const float before = (number - 0.5f) / this->Pixels; // where the product was rounded up
    return before >= place ? before : (number + 0.5f) / this->Pixels;
  }

  /** The last one up to `place`; of such a place, itself. */
  float UpTo(float place) const
  {
    if (!(this->Pixels > 0.0f))
    {
      return place;
    }
    const float number = std::floor(place * this->Pixels - 0.5f);
    if (this->IsExact)
    {
      return (number + 0.5f) * this->Width;
    }
    const float behind = (number + 1.5f) / this->Pixels; // where the product was rounded down
    return behind <= place ? behind : (number + 0.5f) / this->Pixels;
  }

  /** The sample behind another one, or the place itself where samples are anywhere. */
  float Behind(float sample) const { return sample + 2.0f * this->Inset(); }

  /** A bit for each of eight pairs of places, whether there may be samples between them, of which those below 0 are not on the screen. Says yes where that is nearly so, and of what is no number. */
  VITRINE_INLINE unsigned MayHaveAny(const Lanes& from, const Lanes& to) const
  {
    const LaneMask areFar = ~((from <= to) & (to < AllLanes(FarthestPlace)));
    const LaneMask differ =
      this->CountUpTo(from - NearlyThere) != this->CountUpTo(to + NearlyThere);
    return BitsOf(this->Pixels > 0.0f ? areFar | differ : ~LaneMask{});
  }

private:
  static constexpr float FarthestPlace = 1e6f;
  static constexpr float NearlyThere = 0x1p-10f;

  /** Of centres on the screen. */
  VITRINE_INLINE LaneMask CountUpTo(Lanes place) const
  {
    const Lanes onScreen = GreatestOf(LeastOf(place, AllLanes(FarthestPlace)), AllLanes(0.0f));
    return __builtin_convertvector(onScreen * this->Pixels + 0.5f, LaneMask);
  }

  explicit SampleGrid(float pixels)
    : Pixels(pixels)
    , Width(1.0f / pixels)
    , IsExact(std::exp2(std::round(std::log2(pixels))) == pixels)
  {
  }

  float Pixels = 0.0f;  ///< 0 for samples anywhere
  float Width = 0.0f;   ///< of a pixel
  bool IsExact = false; ///< a power of two, by which nothing is rounded
};

}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif
