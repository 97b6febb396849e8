#ifndef VITRINE_CORE_CULLING_COVER_FACET_PLANES_H
#define VITRINE_CORE_CULLING_COVER_FACET_PLANES_H

#include "Core/culling/cover/FewFacetsFrame.h"
#include "Core/culling/mesh/FewFacets.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/FaceSlopes.h"

namespace vitrine
{

/** The corners of facets, one facet per lane. The fourth corner of a triangle is one of the others. */
struct FacetCorners
{
  PointLanes A, B, C, D;

  VITRINE_INLINE FacetCorners(const FewFacets& facets, const PointLanes& points)
    : A(points, facets.Corners[0])
    , B(points, facets.Corners[1])
    , C(points, facets.Corners[2])
    , D(points, facets.Corners[3])
  {
  }

  /** Returns a bit for each facet that is seen from this side. */
  VITRINE_INLINE unsigned Facing(MeshProjection::Facing facing) const
  {
    const Lanes turn = (this->B.X - this->A.X) * (this->C.Y - this->A.Y) -
      (this->C.X - this->A.X) * (this->B.Y - this->A.Y);
    return BitsOf(facing == MeshProjection::Facing::Front ? turn > 0.0f : turn < 0.0f);
  }

  VITRINE_INLINE Lanes LeastOfAll(Lanes PointLanes::*value) const
  {
    return LeastOf(
      LeastOf(this->A.*value, this->B.*value), LeastOf(this->C.*value, this->D.*value));
  }

  VITRINE_INLINE Lanes GreatestOfAll(Lanes PointLanes::*value) const
  {
    return GreatestOf(
      GreatestOf(this->A.*value, this->B.*value), GreatestOf(this->C.*value, this->D.*value));
  }
};

/**
 * The slopes of depth of facets: the plane of one triangle of each, and the steepest slopes of both triangles. The
 * error bounds are as in FaceSlopes.
 */
struct FacetSlopes
{
  FaceSlopes<Lanes> Plane;
  Lanes SteepX, SteepY; ///< the greatest change of depth per column and per line
  Lanes Unsteady, Beyond;

  VITRINE_INLINE FacetSlopes(const FewFacets& facets, const PointLanes& points,
    const FacetCorners& corners, const ScreenMargin& margin, const ScreenMargin& snapping)
    : Plane(SlopesOf(corners.A, corners.B, corners.C, margin, snapping))
  {
    const FaceSlopes<Lanes> others = SlopesOf(PointLanes(points, facets.Others[0]),
      PointLanes(points, facets.Others[1]), PointLanes(points, facets.Others[2]), margin, snapping);
    this->SteepX = GreatestOf(SizeOf(this->Plane.ByColumn.Value), SizeOf(others.ByColumn.Value));
    this->SteepY = GreatestOf(SizeOf(this->Plane.ByLine.Value), SizeOf(others.ByLine.Value));
    this->Unsteady = GreatestOf(this->Plane.Unsteady, others.Unsteady);
    this->Beyond = GreatestOf(this->Plane.Beyond, others.Beyond);
  }

  VITRINE_INLINE void Unsettle(Lanes depth)
  {
    this->Unsteady += depth;
    this->Beyond += depth;
  }

private:
  VITRINE_INLINE static FaceSlopes<Lanes> SlopesOf(const PointLanes& a, const PointLanes& b,
    const PointLanes& c, const ScreenMargin& margin, const ScreenMargin& snapping)
  {
    const Lanes one = AllLanes(1.0f);
    const FacePlaces<Lanes> places{ { a.X, b.X, c.X }, { a.Y, b.Y, c.Y },
      { a.Depth, b.Depth, c.Depth }, { one, one, one } };
    return FaceSlopes<Lanes>(places, UniformScreenRounding(margin, snapping), snapping);
  }
};

/** Bounds the depth of facets. Of slivers little more is known than where they are. */
class FacetPlanes
{
public:
  static constexpr float BeforeAll = 2.0f; ///< above all depths

  /** @param unsteady  by how much more the depths of each facet may be off */
  VITRINE_INLINE FacetPlanes(const FewFacets& facets, const PointLanes& points,
    const MeshProjection& projection, MeshProjection::Facing facing, const FewFacetsFrame& frame,
    Lanes unsteady)
  {
    const FacetCorners corners(facets, points);
    const ScreenMargin& margin = projection.Margin();
    FacetSlopes slopes(facets, points, corners, margin, projection.Snapping());
    slopes.Unsettle(unsteady);
    this->Counted = corners.Facing(facing);
    this->FindPlanes(corners, slopes, margin, frame);
    const Lanes farthest = corners.LeastOfAll(&PointLanes::Depth) - margin.Depth - slopes.Beyond;
    this->Farthest = LeastLane(Chosen(LaneBits(this->Counted), farthest, AllLanes(BeforeAll)));
    if (this->Steady != this->Counted)
    {
      this->FindPlaces(corners, farthest, margin, frame);
    }
  }

  /** Returns a bit for each facet that counts. */
  unsigned Bits() const { return this->Counted; }

  /** Sets eight lines, for DepthsAt(). */
  VITRINE_INLINE void Begin(Lanes y)
  {
    this->Y = y;
    for (unsigned bits = this->Steady; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      this->OnLines[i] = this->Start[i] + this->ByY[i] * y;
    }
  }

  /**
   * Returns a depth for each line at a column, which nothing that is drawn there is farther than. It is BeforeAll if
   * nothing is drawn.
   */
  VITRINE_INLINE Lanes DepthsAt(float x) const
  {
    Lanes depth = AllLanes(BeforeAll);
    for (unsigned bits = this->Steady; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      depth = LeastOf(this->OnLines[i] + this->ByX[i] * x, depth);
    }
    for (unsigned bits = this->Counted & ~this->Steady; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      const bool isBeside = x < this->Left[i] || x > this->Right[i];
      const LaneMask isThere = (this->Y >= this->Bottom[i]) & (this->Y <= this->Top[i]);
      const float farthest = isBeside ? BeforeAll : this->FarthestOf[i];
      depth = LeastOf(Chosen(isThere, AllLanes(farthest), AllLanes(BeforeAll)), depth);
    }
    return GreatestOf(depth, AllLanes(this->Farthest));
  }

private:
  /**
   * Finds the depth at the first column and line, and the slopes. They lie behind all that may be drawn of either
   * triangle.
   */
  VITRINE_INLINE void FindPlanes(const FacetCorners& corners, const FacetSlopes& slopes,
    const ScreenMargin& margin, const FewFacetsFrame& frame)
  {
    const PointLanes &a = corners.A, &d = corners.D;
    const Estimate<Lanes>&column = slopes.Plane.ByColumn, &line = slopes.Plane.ByLine;
    const Lanes byX = column.Value, byY = line.Value;
    const Lanes farX = SizeOf(a.X) + GreatestOf(SizeOf(d.X), AllLanes(frame.Width()));
    const Lanes farY = SizeOf(a.Y) + GreatestOf(SizeOf(d.Y), AllLanes(frame.Height()));
    const Lanes base = a.Depth - a.X * byX - a.Y * byY;
    const Lanes bent = LeastOf(d.Depth - (base + d.X * byX + d.Y * byY), AllLanes(0.0f));
    const Lanes own = column.Own * farX + line.Own * farY +
      RoundingOfFloats * (SizeOf(base) + SizeOf(a.Depth) + SizeOf(byX) * farX + SizeOf(byY) * farY);
    const Lanes slack = margin.Depth + slopes.SteepX * margin.Column +
      slopes.SteepY * (margin.Line + frame.HalfLine()) + slopes.Unsteady + own;
    const Lanes start = base + bent - slack;
    const Lanes sum = start + byX + byY;
    const LaneMask isSteady =
      (slopes.Unsteady + own < FewFacets::MostUnsteady) & (sum - sum == AllLanes(0.0f));
    this->Steady = this->Counted & BitsOf(isSteady);
    StoreLanes(start, this->Start);
    StoreLanes(byX, this->ByX);
    StoreLanes(byY, this->ByY);
  }

  /** Finds the columns and lines around all that a device may draw of each facet, and a depth behind all of it. */
  VITRINE_INLINE void FindPlaces(const FacetCorners& corners, Lanes farthest,
    const ScreenMargin& margin, const FewFacetsFrame& frame)
  {
    const float aside = margin.Column + OwnRoundingOf(frame.Right, 0.0f);
    const float above = margin.Line + frame.HalfLine() +
      OwnRoundingOf(0.0f, static_cast<float>(frame.Lines.Last + 1));
    StoreLanes(corners.LeastOfAll(&PointLanes::X) - aside, this->Left);
    StoreLanes(corners.GreatestOfAll(&PointLanes::X) + aside, this->Right);
    StoreLanes(corners.LeastOfAll(&PointLanes::Y) - above, this->Bottom);
    StoreLanes(corners.GreatestOfAll(&PointLanes::Y) + above, this->Top);
    StoreLanes(farthest, this->FarthestOf);
  }

  unsigned Counted, Steady; ///< a bit for each facet
  float Farthest;           ///< the farthest depth of all facets
  float Start[LaneCount], ByX[LaneCount], ByY[LaneCount];
  float Left[LaneCount], Right[LaneCount], Bottom[LaneCount], Top[LaneCount];
  float FarthestOf[LaneCount];
  Lanes Y;                  ///< the current lines
  Lanes OnLines[LaneCount]; ///< the depths of steady facets on these lines, at the first column
};

}

#endif
