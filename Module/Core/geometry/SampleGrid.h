#ifndef VITRINE_CORE_GEOMETRY_SAMPLE_GRID_H
#define VITRINE_CORE_GEOMETRY_SAMPLE_GRID_H

#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vitrine
{

/** Lower and upper bounds of numbers of samples in eight lanes. */
struct SampleCounts
{
  LaneMask Least, Most;
};

/**
 * The places of samples on the screen, in columns and lines of an s-buffer. Samples lie at pixel centres, at the
 * centres of cells that divide the pixels (multisampling), or anywhere.
 */
class SampleGrid
{
public:
  /** Creates a grid whose samples may lie anywhere. */
  SampleGrid() = default;

  /** Creates a grid of samples at pixel centres, with `pixelsPerLine` pixels per column and per line. */
  static SampleGrid AtCentres(int pixelsPerLine) { return SampleGrid(pixelsPerLine, 1, true); }

  /**
   * Creates a grid of samples at the centres of cells, for pixels with several samples. Each column and line has
   * `cellsPerLine` cells.
   * @param cellsPerPixel  cells across a pixel; lines must be parts of pixels or consist of whole pixels
   */
  static SampleGrid InCells(int cellsPerLine, int cellsPerPixel)
  {
    return SampleGrid(cellsPerLine, cellsPerPixel, false);
  }

  /**
   * Returns the width of a pixel in lines or columns. It is a fraction if these have several pixels, and 1 if samples
   * are anywhere.
   */
  float PixelSize() const { return this->SizeOfPixel; }

  /** Returns the number of lines and columns that a pixel is cut into. It is 1 if lines consist of whole pixels. */
  int LinesPerPixel() const { return static_cast<int>(std::ceil(this->SizeOfPixel)); }

  /** Returns true if everything has one sample per pixel. */
  bool HasOneSamplePerPixel() const { return this->HasOneSample; }

  /** Returns the distance between a line's side and its nearest samples. */
  float Inset() const { return this->FromSide; }

  /** Returns true if all samples of a line lie in its middle. */
  bool HasOneRowPerLine() const { return this->FromSide == 0.5f; }

  /** Returns the distance between neighbouring samples. It is 0 if samples are anywhere. */
  float Width() const { return this->Step; }

  /** Returns the number of samples across a column if that is a power of two, else 0. */
  int BinaryPixelsPerColumn() const
  {
    return this->IsExact ? static_cast<int>(this->PerColumn) : 0;
  }

  /** Returns the place of a sample by its number. Numbers count from 0 at the left. */
  float Place(float number) const
  {
    return this->IsExact ? (number + Offset) * this->Step : (number + Offset) / this->PerColumn;
  }

  /** Returns the number of the first sample at or after `place`. */
  float NumberFrom(float place) const
  {
    const float number = std::ceil(place * this->PerColumn - Offset);
    const bool wasRoundedUp = !this->IsExact && this->Place(number - 1.0f) >= place;
    return wasRoundedUp ? number - 1.0f : number;
  }

  /** Returns the number of the last sample at or before `place`. */
  float NumberUpTo(float place) const
  {
    const float number = std::floor(place * this->PerColumn - Offset);
    const bool wasRoundedDown = !this->IsExact && this->Place(number + 1.0f) <= place;
    return wasRoundedDown ? number + 1.0f : number;
  }

  /** Returns the place of the first sample at or after `place`. */
  float From(float place) const
  {
    return this->PerColumn > 0.0f ? this->Place(this->NumberFrom(place)) : place;
  }

  /** Returns the place of the last sample at or before `place`. */
  float UpTo(float place) const
  {
    return this->PerColumn > 0.0f ? this->Place(this->NumberUpTo(place)) : place;
  }

  /** Returns true if there are samples between two places. */
  bool HasAny(float from, float to) const
  {
    return this->IsExact
      ? std::floor(to * this->PerColumn - Offset) >= from * this->PerColumn - Offset
      : this->From(from) <= this->UpTo(to);
  }

  /** Returns the place of the next sample. If samples are anywhere, it is the same place. */
  float Behind(float sample) const { return sample + this->Step; }

  /**
   * Returns bounds of numbers of samples in eight lanes. Least counts the samples up to `from` and Most those up to
   * `to`, each with a tolerance. Samples at places up to 0 are off the screen and do not count. The bounds are 0 and
   * the largest integer if the number is unknown.
   */
  VITRINE_INLINE SampleCounts CountUpTo(const Lanes& from, const Lanes& to) const
  {
    const LaneMask isKnown = (from <= to) & (to < AllLanes(this->FarthestPlace)) &
      (this->PerColumn > 0.0f ? ~LaneMask{} : LaneMask{});
    const LaneMask most = LaneMask{} + std::numeric_limits<std::int32_t>::max();
    return { isKnown & this->CountUpTo(from - NearlyThere),
      Chosen(isKnown, this->CountUpTo(to + NearlyThere), most) };
  }

  /**
   * Returns a bit for each of eight pairs of places that may have samples in between. The bit is also 1 if samples are
   * very near, and for NaN.
   */
  VITRINE_INLINE unsigned MayHaveAny(const Lanes& from, const Lanes& to) const
  {
    const SampleCounts counts = this->CountUpTo(from, to);
    return BitsOf(counts.Least != counts.Most);
  }

private:
  static constexpr float MostColumns = 1e6f;
  /** Largest number of samples that integers hold with room to spare. */
  static constexpr float MostSamples = 0x1p30f;
  static constexpr float NearlyThere = 0x1p-10f;
  static constexpr float Offset = 0.5f; ///< Place of the first sample in steps.

  /** Returns the number of samples up to places on the screen. */
  VITRINE_INLINE LaneMask CountUpTo(Lanes place) const
  {
    const Lanes onScreen =
      GreatestOf(LeastOf(place, AllLanes(this->FarthestPlace)), AllLanes(0.0f));
    return Converted<LaneMask>(onScreen * this->PerColumn + Offset);
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

  float PerColumn = 0.0f;            ///< Samples per column, or 0 if samples are anywhere.
  float FarthestPlace = MostColumns; ///< Samples are counted up to this place.
  float Step = 0.0f;
  float FromSide = 0.0f;
  float SizeOfPixel = 1.0f;
  bool HasOneSample = false;
  bool IsExact = false; ///< True if PerColumn is a power of two, so that products do not round.
};

}

#endif
