#ifndef VITRINE_CORE_CULLING_STEADY_FACE_SLOPES_H
#define VITRINE_CORE_CULLING_STEADY_FACE_SLOPES_H

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/SlantedDepth.h"
#include "Core/geometry/Lanes.h"

namespace vitrine
{

inline constexpr float AnyDepth = 2.0f; ///< more than all depths differ

/** A number, and by how much it may be off. */
template <class Number>
struct Estimate
{
  Number Value;
  Number Own; ///< by our sums in floats
  Number Off; ///< by a device's other corners, too
};

/** A coordinate of a face's corners: what its two sides that begin at the first one have of it, and how far off a device may be in each. */
template <class Number>
struct FaceSides
{
  Number First;
  Number Second;
  Number Off[3];

  /** @param inversesOfW  of the corners */
  template <class Rounding>
  VITRINE_INLINE FaceSides(
    const Number (&values)[3], const Number (&inversesOfW)[3], const Rounding& rounding)
    : First(values[1] - values[0])
    , Second(values[2] - values[0])
    , Off{ rounding.OffAt(values[0], inversesOfW[0]), rounding.OffAt(values[1], inversesOfW[1]),
      rounding.OffAt(values[2], inversesOfW[2]) }
  {
  }

  /** By how much its cross products change at most that another coordinate of the corners is off by so much. */
  VITRINE_INLINE Number Times(const Number (&off)[3]) const
  {
    return off[0] * SizeOf(this->Second - this->First) + off[1] * SizeOf(this->Second) +
      off[2] * SizeOf(this->First);
  }

  /** From one corner to another at most. */
  VITRINE_INLINE Number Largest() const
  {
    return GreatestOf(
      GreatestOf(SizeOf(this->First), SizeOf(this->Second)), SizeOf(this->Second - this->First));
  }

  VITRINE_INLINE Number SumOff() const { return this->Off[0] + this->Off[1] + this->Off[2]; }
};

/** Where a face's corners are on the screen, and 1 over their w. */
template <class Number>
struct FacePlaces
{
  Number Columns[3], Lines[3], Depths[3], InversesOfW[3];
};

/** A difference of products of sides, be it twice the area of a face or what a slope has of that. */
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
  Estimate<Number> Area; ///< twice, and signed

  template <class Rounding>
  VITRINE_INLINE SidesOnScreen(const FacePlaces<Number>& places, const Rounding& rounding)
    : Columns(places.Columns, places.InversesOfW, rounding.Columns)
    , Lines(places.Lines, places.InversesOfW, rounding.Lines)
    , Depths(places.Depths, places.InversesOfW, rounding.Depths)
    , Area(Cross(this->Columns, this->Lines))
  {
  }

  /** What the area is surely more than, if that is positive. */
  VITRINE_INLINE Number LeastArea() const { return SizeOf(this->Area.Value) - this->Area.Off; }

  /**
   * By how much of its depth a device's plane tilts: the products of which it subtracts one from another to find slopes and the area
   * are large where a sliver is long. Each slope counts as far as the face reaches.
   */
  VITRINE_INLINE Number Tilt(const Number& area) const
  {
    return RoundingOfTilt * this->Columns.Largest() * this->Lines.Largest() *
      this->Depths.Largest() / area;
  }
};

/**
 * How a face's depth changes from column to column and from line to line, and what is not known of that: of one face (float, double) or of eight (Lanes).
 *
 * A device snaps corners to see what they cover. Some take depths from corners that are not snapped, so that the plane counts
 * beside the face, too; and they round corners before, which slopes differ by. A sliver's are steep, and where rounding may take all of its area nothing is known of them.
 */
template <class Number>
class FaceSlopes
{
public:
  /**
   * @param rounding  what a device's floats round of points: ScreenRounding or DeviceScreenRounding
   * @param snapping  what it moves them by to see what they cover
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
    this->Unsteady = leastArea > Number{} ? this->ByColumn.Off * snapping.Column +
        this->ByLine.Off * snapping.Line + sides.Tilt(leastArea)
                                          : anyDepth;
    const Number beside = this->Unsteady + SizeOf(this->ByColumn.Value) * snapping.Column +
      SizeOf(this->ByLine.Value) * snapping.Line;
    this->Beyond = beside < anyDepth ? beside : anyDepth; // as where it is no number
  }

  Estimate<Number> ByColumn, ByLine;
  Number Unsteady; ///< what depths may be off by, that slopes are not known better
  Number Beyond;   ///< by how much depths may exceed those of the corners

private:
  /** Off is negative, infinite or no number if nothing is known. */
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
