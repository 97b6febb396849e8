#ifndef VITRINE_CORE_CULLING_STEADY_FACE_SLOPES_H
#define VITRINE_CORE_CULLING_STEADY_FACE_SLOPES_H

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/SlantedDepth.h"
#include "Core/geometry/Lanes.h"

namespace vitrine
{

inline constexpr float AnyDepth = 2.0f; ///< more than the difference of any two depths

/** A number with bounds of its error. */
template <class Number>
struct Estimate
{
  Number Value;
  Number Own; ///< error by the floats of the culler
  Number Off; ///< error by other corners of a device as well
};

/**
 * One coordinate of the corners of a face: its differences along the two sides from the first corner, and the error
 * bound of each corner on a device.
 */
template <class Number>
struct FaceSides
{
  Number First;
  Number Second;
  Number Off[3];

  /** @param inversesOfW  1 / w of the corners */
  template <class Rounding>
  VITRINE_INLINE FaceSides(
    const Number (&values)[3], const Number (&inversesOfW)[3], const Rounding& rounding)
    : First(values[1] - values[0])
    , Second(values[2] - values[0])
    , Off{ rounding.OffAt(values[0], inversesOfW[0]), rounding.OffAt(values[1], inversesOfW[1]),
      rounding.OffAt(values[2], inversesOfW[2]) }
  {
  }

  /**
   * Returns the bound by which its cross products with another coordinate change if that is off by `off` at the
   * corners.
   */
  VITRINE_INLINE Number Times(const Number (&off)[3]) const
  {
    return off[0] * SizeOf(this->Second - this->First) + off[1] * SizeOf(this->Second) +
      off[2] * SizeOf(this->First);
  }

  /** Returns the greatest difference between two corners. */
  VITRINE_INLINE Number Largest() const
  {
    return GreatestOf(
      GreatestOf(SizeOf(this->First), SizeOf(this->Second)), SizeOf(this->Second - this->First));
  }

  VITRINE_INLINE Number SumOff() const { return this->Off[0] + this->Off[1] + this->Off[2]; }
};

/** The corners of a face on the screen, and 1 / w of each. */
template <class Number>
struct FacePlaces
{
  Number Columns[3], Lines[3], Depths[3], InversesOfW[3];
};

/** Returns the cross product of sides: twice the area of a face, or the numerator of a slope. */
template <class Number>
VITRINE_INLINE Estimate<Number> Cross(const FaceSides<Number>& a, const FaceSides<Number>& b)
{
  const Number first = a.First * b.Second, second = a.Second * b.First;
  const Number own = RoundingOfFloats * (SizeOf(first) + SizeOf(second));
  return { first - second, own, own + a.Times(b.Off) + b.Times(a.Off) + a.SumOff() * b.SumOff() };
}

/** The sides of a face on the screen. */
template <class Number>
struct SidesOnScreen
{
  FaceSides<Number> Columns, Lines, Depths;
  Estimate<Number> Area; ///< twice the signed area

  template <class Rounding>
  VITRINE_INLINE SidesOnScreen(const FacePlaces<Number>& places, const Rounding& rounding)
    : Columns(places.Columns, places.InversesOfW, rounding.Columns)
    , Lines(places.Lines, places.InversesOfW, rounding.Lines)
    , Depths(places.Depths, places.InversesOfW, rounding.Depths)
    , Area(Cross(this->Columns, this->Lines))
  {
  }

  /** Returns a lower bound of the absolute area, if it is positive. */
  VITRINE_INLINE Number LeastArea() const { return SizeOf(this->Area.Value) - this->Area.Off; }

  /**
   * Returns by how much the plane that a device computes may tilt. It finds slopes and area as differences of products,
   * which are large for a long sliver. Each slope counts as far as the face reaches.
   */
  VITRINE_INLINE Number Tilt(const Number& area) const
  {
    return RoundingOfTilt * this->Columns.Largest() * this->Lines.Largest() *
      this->Depths.Largest() / area;
  }
};

/**
 * How the depth of a face changes from column to column and from line to line, with error bounds. It works on one face
 * (float, double) or on eight (Lanes).
 *
 * A device snaps corners to find what they cover. Some devices take depths from corners that are not snapped, so that
 * the plane counts beside the face, too. They round these corners, which changes the slopes. The slopes of a sliver are
 * steep. If rounding may take all of its area, nothing is known of them.
 */
template <class Number>
class FaceSlopes
{
public:
  /**
   * @param rounding  what the floats of a device round of points: ScreenRounding or DeviceScreenRounding
   * @param snapping  how far a device moves points to find what they cover
   */
  template <class Rounding>
  VITRINE_INLINE FaceSlopes(
    const FacePlaces<Number>& places, const Rounding& rounding, const ScreenMargin& snapping)
  {
    const SidesOnScreen<Number> sides(places, rounding);
    this->ByColumn = Quotient(Cross(sides.Depths, sides.Lines), sides.Area);
    this->ByLine = Quotient(Cross(sides.Columns, sides.Depths), sides.Area);
    const Number anyDepth = Number{} + AnyDepth;
    const Number leastArea = sides.LeastArea();
    this->Unsteady = Chosen(leastArea > Number{},
      this->ByColumn.Off * snapping.Column + this->ByLine.Off * snapping.Line +
        sides.Tilt(leastArea),
      anyDepth);
    const Number beside = this->Unsteady + SizeOf(this->ByColumn.Value) * snapping.Column +
      SizeOf(this->ByLine.Value) * snapping.Line;
    this->Beyond = Chosen(beside < anyDepth, beside, anyDepth); // also if it is no number
  }

  Estimate<Number> ByColumn, ByLine;
  Number Unsteady; ///< bound of the depths' error that results from uncertain slopes
  Number Beyond;   ///< how far depths may exceed those of the corners

private:
  /** Returns a quotient. Off is negative, infinite or no number if nothing is known. */
  VITRINE_INLINE static Estimate<Number> Quotient(
    const Estimate<Number>& a, const Estimate<Number>& b)
  {
    const Number value = a.Value / b.Value, size = SizeOf(b.Value);
    return { value, (a.Own + SizeOf(value) * b.Own) / size,
      (a.Off + SizeOf(value) * b.Off) / (size - b.Off) };
  }
};

}

#endif
