#ifndef VITRINE_CORE_CULLING_FACE_SLOPES_H
#define VITRINE_CORE_CULLING_FACE_SLOPES_H

#include "Core/culling/Lanes.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SlantedDepth.h"

#include <cmath>

namespace vitrine
{

/** Without its sign. */
VITRINE_INLINE float SizeOf(float a)
{
  return std::abs(a);
}

/** A number, and by how much it may be off. */
template <class Number>
struct Estimate
{
  Number Value;
  Number Own; ///< by our sums in floats
  Number Off; ///< by a device's other corners, too
};

/** Of a face's two sides that begin at its first corner: what they have of a coordinate, and how far off a device may be in that. */
template <class Number>
struct FaceSides
{
  Number First;
  Number Second;
  float Off;

  VITRINE_INLINE Number Sum() const { return SizeOf(this->First) + SizeOf(this->Second); }
};

/**
 * How a face's depth changes from column to column and from line to line, and what is not known of that: of one face (float) or of eight (Lanes).
 *
 * A device snaps corners to see what they cover. Some take depths from corners that are not snapped, so that the plane counts
 * beside the face, too; and they round corners before, which slopes differ by. A sliver's are steep, and where rounding may take all of its area nothing is known of them.
 */
template <class Number>
class FaceSlopes
{
public:
  /** @param snapping  what a device moves points by to see what they cover */
  VITRINE_INLINE FaceSlopes(const FaceSides<Number>& columns, const FaceSides<Number>& lines,
    const FaceSides<Number>& depths, const ScreenMargin& snapping)
  {
    const Estimate<Number> area = Cross(columns, lines);
    this->ByColumn = Quotient(Cross(depths, lines), area);
    this->ByLine = Quotient(Cross(columns, depths), area);
    const Number anyDepth = Number{} + AnyDepth;
    this->Unsteady = SizeOf(area.Value) > area.Off
      ? this->ByColumn.Off * snapping.Column + this->ByLine.Off * snapping.Line
      : anyDepth;
    const Number beside = this->Unsteady + SizeOf(this->ByColumn.Value) * snapping.Column +
      SizeOf(this->ByLine.Value) * snapping.Line;
    this->Beyond = beside < anyDepth ? beside : anyDepth; // as where it is no number
  }

  Estimate<Number> ByColumn, ByLine;
  Number Unsteady; ///< what depths may be off by, that slopes are not known better
  Number Beyond;   ///< by how much depths may exceed those of the corners

private:
  static constexpr float AnyDepth = 2.0f; // more than all depths differ

  VITRINE_INLINE static Estimate<Number> Cross(
    const FaceSides<Number>& a, const FaceSides<Number>& b)
  {
    const Number first = a.First * b.Second, second = a.Second * b.First;
    const Number own = RoundingOfFloats * (SizeOf(first) + SizeOf(second));
    return { first - second, own, own + a.Off * b.Sum() + b.Off * a.Sum() + 2.0f * a.Off * b.Off };
  }

  /** Off is negative, infinite or no number if nothing is known. */
  VITRINE_INLINE static Estimate<Number> Quotient(
    const Estimate<Number>& a, const Estimate<Number>& b)
  {
    const Number value = a.Value / b.Value, size = SizeOf(b.Value);
    return { value, (a.Own + SizeOf(value) * b.Own) / size,
      (a.Off + SizeOf(value) * b.Off) / (size - b.Off) };
  }
};

/** How far off a device may be in the difference of two points. */
inline ScreenMargin OffOf(const ScreenMargin& margin, const ScreenMargin& snapping)
{
  return { 2.0f * (margin.Column - snapping.Column), 2.0f * (margin.Line - snapping.Line),
    2.0f * (margin.Depth - snapping.Depth) };
}

}

#endif
