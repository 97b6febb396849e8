#include "Core/culling/steady/SideCuts.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/steady/FaceCorners.h"

namespace vitrine
{

namespace
{

VITRINE_INLINE Lanes LeastIn(const Lanes (&a)[3])
{
  return LeastOf(a[0], a[1], a[2]);
}

VITRINE_INLINE Lanes GreatestIn(const Lanes (&a)[3])
{
  return GreatestOf(a[0], a[1], a[2]);
}

/** The distances of the corners from the one side of the view that faces reach beyond, positive inwards. */
struct CornersFromSide
{
  Lanes A, B, C;
  LaneMask AreKnown; ///< one side cuts the face, and no corner is close to it

  VITRINE_INLINE CornersFromSide(
    const FacePlaces<Lanes>& places, const ScreenMarginOf<Lanes>& margin, const ScreenMatrix& view)
  {
    const Lanes left = LeastIn(places.Columns) - margin.Column;
    const Lanes right = view.Size.x - GreatestIn(places.Columns) - margin.Column;
    const Lanes bottom = LeastIn(places.Lines) - margin.Line - view.Bottom();
    const Lanes top = view.Top() - GreatestIn(places.Lines) - margin.Line;
    const LaneMask isLeft = left < 0.0f, isRight = right < 0.0f, isBelow = bottom < 0.0f,
                   isAbove = top < 0.0f;
    const auto distanceOf = [&](int i) VITRINE_INLINED
    {
      const Lanes column = places.Columns[i], line = places.Lines[i];
      const Lanes upright = Chosen(isBelow, line - view.Bottom(), view.Top() - line);
      return Chosen(isLeft, column, Chosen(isRight, view.Size.x - column, upright));
    };
    this->A = distanceOf(0);
    this->B = distanceOf(1);
    this->C = distanceOf(2);
    const Lanes leastAway = LeastAway * Chosen(isLeft | isRight, margin.Column, margin.Line);
    const Lanes away = LeastOf(SizeOf(this->A), SizeOf(this->B), SizeOf(this->C));
    const LaneMask isInDepth = (GreatestIn(places.Depths) + margin.Depth < 1.0f) &
      (LeastIn(places.Depths) - margin.Depth > 0.0f);
    const LaneMask isOneSide = isLeft + isRight + isBelow + isAbove == -1;
    const LaneMask isAcross =
      (LeastOf(this->A, this->B, this->C) < 0.0f) & (GreatestOf(this->A, this->B, this->C) > 0.0f);
    this->AreKnown = isOneSide & isInDepth & isAcross & (away > leastAway);
  }

  /**
   * Returns the area of the smallest triangle of what is left, as a share of the face. One corner lies on one side of
   * the cut, and two on the other.
   */
  VITRINE_INLINE Lanes LeastShare() const
  {
    const LaneMask isB = (this->B > 0.0f) != (this->A > 0.0f);
    const LaneMask isC = (this->C > 0.0f) != (this->A > 0.0f);
    const LaneMask isA = isB & isC;
    const Lanes alone = Chosen(isA, this->A, Chosen(isB, this->B, this->C));
    const Lanes first = Chosen(isA, this->B, this->A);
    const Lanes second = Chosen(isB, this->C, this->B);
    const Lanes ofFirst = SizeOf(alone) / (SizeOf(alone) + SizeOf(first));
    const Lanes ofSecond = SizeOf(alone) / (SizeOf(alone) + SizeOf(second));
    return Chosen(alone > 0.0f, ofFirst * ofSecond,
      LeastOf(ofSecond * (1.0f - ofFirst), ofFirst * (1.0f - ofSecond)));
  }
};

/** Returns the sides of faces, with the rounding of `inverseOfW` for all corners. */
VITRINE_INLINE SidesOnScreen<Lanes> SidesOf(
  FacePlaces<Lanes> places, const Lanes& inverseOfW, const ScreenRounding& rounding)
{
  for (Lanes& ofCorner : places.InversesOfW)
  {
    ofCorner = inverseOfW;
  }
  return SidesOnScreen<Lanes>(places, rounding);
}

/** Returns the error bound of cross products of sides between any places within a face. */
VITRINE_INLINE Lanes MostOff(const FaceSides<Lanes>& a, const FaceSides<Lanes>& b)
{
  const Lanes largestA = a.Largest(), largestB = b.Largest();
  return 2.0f * RoundingOfFloats * largestA * largestB + largestA * b.SumOff() +
    largestB * a.SumOff() + a.SumOff() * b.SumOff();
}

/** Returns CutCorner::Reach for any place where edges are cut. */
VITRINE_INLINE Lanes ReachOf(const FacePlaces<Lanes>& places, const ScreenMatrix& view)
{
  const float height = view.Top() - view.Bottom();
  Lanes farthest = AllLanes(0.0f);
  for (int i = 0; i < 3; ++i)
  {
    const Lanes times = GreatestOf(
      AllLanes(1.0f), SizeOf(places.Columns[i]) / view.Size.x, SizeOf(places.Lines[i]) / height);
    farthest = GreatestOf(farthest, times / places.InversesOfW[i]);
  }
  return farthest * GreatestIn(places.InversesOfW);
}
}

VITRINE_FOR_EACH_PROCESSOR
std::array<float, LaneCount> SideCuts::UnsteadyOf(const FaceBlock& faces) const
{
  std::array<float, LaneCount> told;
  told.fill(AnyDepth);
  if (!this->Projection.IsBehindNear()) // otherwise some may be pieces of faces
  {
    return told;
  }
  const FaceCorners a(this->Projection, faces.Pointers(), 0),
    b(this->Projection, faces.Pointers(), 1), c(this->Projection, faces.Pointers(), 2);
  const FacePlaces<Lanes> places{ { a.Column, b.Column, c.Column }, { a.Line, b.Line, c.Line },
    { a.Depth, b.Depth, c.Depth }, { a.InverseW, b.InverseW, c.InverseW } };
  const ScreenMatrix& view = this->Projection.View();
  const ScreenRounding& rounding = this->Projection.Rounding();
  const ScreenMargin& snapping = this->Projection.Snapping();
  const Lanes inverseOfW = GreatestIn(places.InversesOfW);
  const CornersFromSide corners(places, rounding.MarginAt(inverseOfW, {}), view);
  const SidesOnScreen<Lanes> anywhere = SidesOf(places, inverseOfW, rounding);
  const Lanes leastArea = LeastOfShares * corners.LeastShare() * SizeOf(anywhere.Area.Value) -
    MostOff(anywhere.Columns, anywhere.Lines);
  const SidesOnScreen<Lanes> cut = SidesOf(places, ReachOf(places, view), this->OfCuts);
  const FaceSlopes<Lanes> slopes(places, rounding, snapping);
  const Lanes byColumn = SizeOf(slopes.ByColumn.Value) + slopes.ByColumn.Off;
  const Lanes byLine = SizeOf(slopes.ByLine.Value) + slopes.ByLine.Off;
  const Lanes ofArea = MostOff(cut.Columns, cut.Lines);
  const Lanes off = (MostOff(cut.Depths, cut.Lines) + byColumn * ofArea) * snapping.Column +
    (MostOff(cut.Columns, cut.Depths) + byLine * ofArea) * snapping.Line;
  const Lanes unsteady = off / leastArea + cut.Tilt(leastArea);
  const LaneMask isKnown = corners.AreKnown & (leastArea > 0.0f) & (slopes.ByColumn.Off >= 0.0f) &
    (slopes.ByLine.Off >= 0.0f) & (unsteady < AnyDepth);
  StoreLanes(Chosen(isKnown, unsteady, AllLanes(AnyDepth)), told.data());
  return told;
}

}
