#ifndef VITRINE_CORE_CULLING_SCREEN_SCREEN_ROUNDING_H
#define VITRINE_CORE_CULLING_SCREEN_SCREEN_ROUNDING_H

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/Lanes.h"

namespace vitrine
{

/** By how much a device may draw something elsewhere than it is: in columns, lines, and reversed depth; of one thing, or of Lanes of them. */
template <typename Number>
struct ScreenMarginOf
{
  Number Column{};
  Number Line{};
  Number Depth{};
};
using ScreenMargin = ScreenMarginOf<float>;

/**
 * What a device's floats round of a coordinate of a point, times its w: so much, and of the coordinate, which on the screen is no larger than the screen is, as much as they round of w. Besides, so much of
 * a place in the window, whatever its w.
 */
struct CoordinateRounding
{
  float Own;
  float OfW;
  float Largest;
  float OfPlaces = 0.0f;
  float Least = 0.0f; ///< that the screen has

  /** On the screen, where w is 1; elsewhere as much over w. */
  float OnScreenAtOne() const { return this->Own + this->Largest * this->OfW; }

  /** Anywhere: off the screen places are rounded by themselves, too, as is w. */
  template <class Number>
  VITRINE_INLINE Number OffAt(Number place, Number inverseOfW) const
  {
    const Number fromLeast = place - this->Least;
    const Number beyond = GreatestOf(GreatestOf(-fromLeast, fromLeast - this->Largest), Number{});
    return (this->Own + this->OfW * (this->Largest + 1.5f * beyond)) * inverseOfW + this->OfPlaces;
  }
};

/** What they round of columns, lines and depths. */
struct ScreenRounding
{
  CoordinateRounding Columns, Lines, Depths;

  /** On the screen, where w is 1; elsewhere as much over w. */
  ScreenMargin OnScreenAtOne() const
  {
    return { this->Columns.OnScreenAtOne(), this->Lines.OnScreenAtOne(),
      this->Depths.OnScreenAtOne() };
  }

  /** Of points on the screen, and what is snapped besides. */
  template <typename Number>
  VITRINE_INLINE ScreenMarginOf<Number> MarginAt(
    Number inverseOfW, const ScreenMargin& snapping) const
  {
    const ScreenMargin atOne = this->OnScreenAtOne();
    return { snapping.Column + this->Columns.OfPlaces + atOne.Column * inverseOfW,
      snapping.Line + this->Lines.OfPlaces + atOne.Line * inverseOfW,
      snapping.Depth + this->Depths.OfPlaces + atOne.Depth * inverseOfW };
  }
};

/** So much of a coordinate, wherever a point is. */
struct UniformRounding
{
  float Off;

  template <class Number>
  VITRINE_INLINE Number OffAt(Number, Number) const
  {
    return Number{} + this->Off;
  }
};

/** Of columns, lines and depths. */
struct UniformScreenRounding
{
  UniformRounding Columns, Lines, Depths;

  /** What a margin has besides what is snapped. */
  UniformScreenRounding(const ScreenMargin& margin, const ScreenMargin& snapping)
    : Columns{ margin.Column - snapping.Column }
    , Lines{ margin.Line - snapping.Line }
    , Depths{ margin.Depth - snapping.Depth }
  {
  }
};

/** What a device alone rounds of a coordinate of a point in the view: the farther that is from the view's middle, the more of it comes from w. */
struct DeviceCoordinateRounding
{
  double OfSums, OfW; ///< times w
  double Middle;      ///< of the view
  double OfPlaces;    ///< in the window

  double OffAt(double place, double inverseOfW) const
  {
    const double fromMiddle = SizeOf(place - this->Middle);
    return (this->OfSums + this->OfW * fromMiddle) * inverseOfW + RoundingOfQuotients * fromMiddle +
      this->OfPlaces;
  }
};

/** Of columns, lines and depths. */
struct DeviceScreenRounding
{
  DeviceCoordinateRounding Columns, Lines, Depths;
};

}

#endif
