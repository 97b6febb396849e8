#ifndef VITRINE_CORE_GEOMETRY_SAMPLE_GRID_H
#define VITRINE_CORE_GEOMETRY_SAMPLE_GRID_H

#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vitrine
{

/** Numbers of samples up to eight places. */
struct SampleCounts
{
  LaneMask Least, Most;
};

/**
 * Where on the screen something can show at all, in columns and lines of an s-buffer: at the centres of pixels; where pixels have
 * several samples, in the middles of cells that they are cut into; or anywhere.
 */
class SampleGrid
{
public:
  /** Anywhere. */
  SampleGrid() = default;

  /** At the centres of pixels, of which a column and a line has so many. */
  static SampleGrid AtCentres(int pixelsPerLine) { return SampleGrid(pixelsPerLine, 1, true); }

  /**
   * In the middles of cells that pixels are cut into, side by side and one above the other, of which a column and a line has so many: there samples of pixels are that have several.
   * @param cellsPerPixel  into how many a pixel is cut across; so many that lines are parts of pixels, or of whole ones
   */
  static SampleGrid InCells(int cellsPerLine, int cellsPerPixel)
  {
    return SampleGrid(cellsPerLine, cellsPerPixel, false);
  }

  /** How many lines or columns a pixel is wide: a part of one where those are of several pixels. Where samples are anywhere it is taken to be no more than one. */
  float PixelSize() const { return this->SizeOfPixel; }

  /** Into how many lines and columns a pixel is cut: 1 where they are of whole pixels. */
  int LinesPerPixel() const { return static_cast<int>(std::ceil(this->SizeOfPixel)); }

  /** Whether all that is drawn has one sample a pixel. */
  bool HasOneSamplePerPixel() const { return this->HasOneSample; }

  /** How far from its sides a line has no samples. */
  float Inset() const { return this->FromSide; }

  /** Whether all samples of a line lie in its middle. */
  bool HasOneRowPerLine() const { return this->FromSide == 0.5f; }

  /** From one place with samples to the next; 0 where they are anywhere. */
  float Width() const { return this->Step; }

  /** Where samples are at centres of pixels, or of cells, of which a column has 1, 2, 4 or so: how many that are; else 0. */
  int BinaryPixelsPerColumn() const
  {
    return this->IsExact ? static_cast<int>(this->PerColumn) : 0;
  }

  /** Where the samples of a number are: they count from 0 at the left. */
  float Place(float number) const
  {
    return this->IsExact ? (number + Offset) * this->Step : (number + Offset) / this->PerColumn;
  }

  /** The number of the first place with samples from `place` on; of such a place, its own. */
  float NumberFrom(float place) const
  {
    const float number = std::ceil(place * this->PerColumn - Offset);
    const bool wasRoundedUp = !this->IsExact && this->Place(number - 1.0f) >= place;
    return wasRoundedUp ? number - 1.0f : number;
  }

  /** Of the last one up to `place`. */
  float NumberUpTo(float place) const
  {
    const float number = std::floor(place * this->PerColumn - Offset);
    const bool wasRoundedDown = !this->IsExact && this->Place(number + 1.0f) <= place;
    return wasRoundedDown ? number + 1.0f : number;
  }

  /** The first place with samples from `place` on; of such a place, itself. */
  float From(float place) const
  {
    return this->PerColumn > 0.0f ? this->Place(this->NumberFrom(place)) : place;
  }

  /** The last one up to `place`; of such a place, itself. */
  float UpTo(float place) const
  {
    return this->PerColumn > 0.0f ? this->Place(this->NumberUpTo(place)) : place;
  }

  /** Whether there are any from one place to another. */
  bool HasAny(float from, float to) const
  {
    return this->IsExact
      ? std::floor(to * this->PerColumn - Offset) >= from * this->PerColumn - Offset
      : this->From(from) <= this->UpTo(to);
  }

  /** The place behind another one, or that itself where samples are anywhere. */
  float Behind(float sample) const { return sample + this->Step; }

  /** How many places with samples there are up to each of eight pairs of places, but for those up to 0, which are not on the screen: as few as it may be and as many. Far apart where that is not known. */
  VITRINE_INLINE SampleCounts CountUpTo(const Lanes& from, const Lanes& to) const
  {
    const LaneMask isKnown = (from <= to) & (to < AllLanes(this->FarthestPlace)) &
      (this->PerColumn > 0.0f ? ~LaneMask{} : LaneMask{});
    const LaneMask most = LaneMask{} + std::numeric_limits<std::int32_t>::max();
    return { isKnown & this->CountUpTo(from - NearlyThere),
      isKnown ? this->CountUpTo(to + NearlyThere) : most };
  }

  /** A bit for each of eight pairs of places, whether there may be samples between them. Says yes where that is nearly so, and of what is no number. */
  VITRINE_INLINE unsigned MayHaveAny(const Lanes& from, const Lanes& to) const
  {
    const SampleCounts counts = this->CountUpTo(from, to);
    return BitsOf(counts.Least != counts.Most);
  }

private:
  static constexpr float MostColumns = 1e6f;
  static constexpr float MostSamples = 0x1p30f; ///< that integers hold
  static constexpr float NearlyThere = 0x1p-10f;
  static constexpr float Offset = 0.5f; ///< of the first sample, in steps

  /** Of places on the screen. */
  VITRINE_INLINE LaneMask CountUpTo(Lanes place) const
  {
    const Lanes onScreen =
      GreatestOf(LeastOf(place, AllLanes(this->FarthestPlace)), AllLanes(0.0f));
    return __builtin_convertvector(onScreen * this->PerColumn + Offset, LaneMask);
  }

  SampleGrid(int perColumn, int perPixel, bool hasOneSample)
    : PerColumn(static_cast<float>(perColumn))
    , FarthestPlace(std::min(MostColumns, MostSamples / this->PerColumn))
    , Step(1.0f / this->PerColumn)
    , FromSide(0.5f / this->PerColumn)
    , SizeOfPixel(static_cast<float>(perPixel) / this->PerColumn)
    , HasOneSample(hasOneSample)
    , IsExact(std::exp2(std::round(std::log2(this->PerColumn))) == this->PerColumn)
  {
  }

  float PerColumn = 0.0f;            ///< 0 for samples anywhere
  float FarthestPlace = MostColumns; ///< up to which samples are counted
  float Step = 0.0f;
  float FromSide = 0.0f;
  float SizeOfPixel = 1.0f;
  bool HasOneSample = false;
  bool IsExact = false; ///< a power of two, by which nothing is rounded
};

}

#endif
