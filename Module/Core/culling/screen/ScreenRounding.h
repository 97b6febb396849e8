#ifndef VITRINE_CORE_CULLING_SCREEN_SCREEN_ROUNDING_H
#define VITRINE_CORE_CULLING_SCREEN_SCREEN_ROUNDING_H

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/Lanes.h"

namespace vitrine
{

/**
 * Bounds of how far a device may draw a thing from its true place: in columns, lines and reversed depth. They are for
 * one thing, or for Lanes of things.
 */
template <typename Number>
struct ScreenMarginOf
{
  Number Column{};
  Number Line{};
  Number Depth{};
};
using ScreenMargin = ScreenMarginOf<float>;

/**
 * Float rounding of one coordinate of a point on the device, times w. It is Own plus OfW times the coordinate, which is
 * at most Largest on the screen. OfPlaces is added in the window, whatever w is.
 */
struct CoordinateRounding
{
  float Own;
  float OfW;
  float Largest;
  float OfPlaces = 0.0f;
  float Least = 0.0f; ///< Least coordinate of the screen.

  /** Returns the rounding on the screen for w = 1. It is proportional to 1/w. */
  float OnScreenAtOne() const { return this->Own + this->Largest * this->OfW; }

  /**
   * Returns the rounding at any place. Off the screen, the rounding of w and of the place itself grows with the
   * distance.
   */
  template <class Number>
  VITRINE_INLINE Number OffAt(Number place, Number inverseOfW) const
  {
    const Number fromLeast = place - this->Least;
    const Number beyond = GreatestOf(GreatestOf(-fromLeast, fromLeast - this->Largest), Number{});
    return (this->Own + this->OfW * (this->Largest + 1.5f * beyond)) * inverseOfW + this->OfPlaces;
  }
};

/** The rounding of columns, lines and depths. */
struct ScreenRounding
{
  CoordinateRounding Columns, Lines, Depths;

  /** Returns the rounding on the screen for w = 1. It is proportional to 1/w. */
  ScreenMargin OnScreenAtOne() const
  {
    return { this->Columns.OnScreenAtOne(), this->Lines.OnScreenAtOne(),
      this->Depths.OnScreenAtOne() };
  }

  /** Returns the margin of points on the screen: rounding and snapping. */
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

/** A rounding that is the same for all points. */
struct UniformRounding
{
  float Off;

  template <class Number>
  VITRINE_INLINE Number OffAt(Number, Number) const
  {
    return Number{} + this->Off;
  }
};

/** The same rounding of all points in columns, lines and depths. */
struct UniformScreenRounding
{
  UniformRounding Columns, Lines, Depths;

  /** Takes the part of a margin that is not snapping. */
  UniformScreenRounding(const ScreenMargin& margin, const ScreenMargin& snapping)
    : Columns{ margin.Column - snapping.Column }
    , Lines{ margin.Line - snapping.Line }
    , Depths{ margin.Depth - snapping.Depth }
  {
  }
};

/**
 * Rounding of one coordinate by the device alone, for points in the view. The share of w grows with the distance from
 * the view's middle.
 */
struct DeviceCoordinateRounding
{
  double OfSums, OfW; ///< These are multiplied by 1/w.
  double Middle;      ///< Middle of the view.
  double OfPlaces;    ///< Rounding in the window.

  double OffAt(double place, double inverseOfW) const
  {
    const double fromMiddle = SizeOf(place - this->Middle);
    return (this->OfSums + this->OfW * fromMiddle) * inverseOfW + RoundingOfQuotients * fromMiddle +
      this->OfPlaces;
  }
};

/** The rounding by the device alone in columns, lines and depths. */
struct DeviceScreenRounding
{
  DeviceCoordinateRounding Columns, Lines, Depths;
};

}

#endif
