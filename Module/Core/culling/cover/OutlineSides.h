#ifndef VITRINE_CORE_CULLING_COVER_OUTLINE_SIDES_H
#define VITRINE_CORE_CULLING_COVER_OUTLINE_SIDES_H

#include "Core/culling/cover/FewFacetsFrame.h"
#include "Core/culling/mesh/FewFacets.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/BeyondAll.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vitrine
{

/**
 * Edges as half-planes: Across * x + Along * y + Start is not negative inside (J. Pineda: A parallel algorithm for
 * polygon rasterization, SIGGRAPH 1988). They are moved inwards as far as a device may move them (J. Hasselgren, T.
 * Akenine-Moller, L. Ohlsson: Conservative rasterization, GPU Gems 2, 2005, chapter 42). A level edge is taken to rise
 * a little.
 */
struct HalfPlanes
{
  Lanes Across, Along, Start;
  Lanes Length; ///< length of an edge: columns plus lines

  /** The least rise of an edge that is not level, in lines. */
  static constexpr float LeastRise = 0x1p-20f;

  /** @param moved  how far a device may move edges, in columns and lines */
  VITRINE_INLINE HalfPlanes(const PointLanes& from, const PointLanes& to, LaneMask isForward,
    const ScreenMargin& moved, const FewFacetsFrame& frame)
  {
    const Lanes rise = Chosen(isForward, from.Y - to.Y, to.Y - from.Y);
    const LaneMask isLevel = SizeOf(rise) < LeastRise;
    this->Across = Chosen(isLevel, AllLanes(LeastRise), rise);
    this->Along = Chosen(isForward, to.X - from.X, from.X - to.X);
    this->Length = SizeOf(rise) + SizeOf(this->Along);
    const Lanes farX = SizeOf(from.X) + frame.Width(), farY = SizeOf(from.Y) + frame.Height();
    const Lanes rounding =
      RoundingOfFloats * (SizeOf(this->Across) * farX + SizeOf(this->Along) * farY);
    const Lanes raised = Chosen(isLevel, 2.0f * LeastRise * farX, AllLanes(0.0f));
    this->Start = -(rise * from.X + this->Along * from.Y) -
      (SizeOf(this->Across) * moved.Column + SizeOf(this->Along) * moved.Line) - rounding - raised;
  }
};

/** The edges of an outline. It tells where each edge passes lines, moved inwards as far as a device may move it. */
class OutlineSides
{
public:
  VITRINE_INLINE OutlineSides(const FewFacets& facets, unsigned counted, const PointLanes& points,
    const MeshProjection& projection, MeshProjection::Facing facing, const FewFacetsFrame& frame)
  {
    const ScreenMargin moved = MarginOf(projection, frame);
    const bool isFront = facing == MeshProjection::Facing::Front;
    const LaneMask isCounted = LaneMask{} + static_cast<std::int32_t>(counted);
    for (int first = 0; first < FewFacets::MostEdges; first += LaneCount)
    {
      const LaneMask isLeft = (LoadMask(facets.Left + first) & isCounted) != 0;
      const LaneMask isRight = (LoadMask(facets.Right + first) & isCounted) != 0;
      const PointLanes from(points, facets.From + first), to(points, facets.To + first);
      this->SetEdges(
        HalfPlanes(from, to, isFront ? isLeft : isRight, moved, frame), isLeft ^ isRight, first);
    }
  }

  /** Returns true if it tells what is covered: there is an outline, and the direction of each edge is known. */
  bool AreClear() const { return this->AtLeft != 0 && this->AtRight != 0 && this->TooShort == 0; }

  /** Finds the columns between which eight lines are covered. */
  VITRINE_INLINE void FindColumns(Lanes y, Lanes& left, Lanes& right) const
  {
    left = AllLanes(-BeyondAll);
    right = AllLanes(BeyondAll);
    for (unsigned bits = this->AtLeft; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      left = GreatestOf(this->Slope[i] * y + this->Column[i], left);
    }
    for (unsigned bits = this->AtRight; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      right = LeastOf(this->Slope[i] * y + this->Column[i], right);
    }
  }

private:
  /** Returns how far a device may move outlines, plus the way from the middle of a line to its farthest samples. */
  VITRINE_INLINE static ScreenMargin MarginOf(
    const MeshProjection& projection, const FewFacetsFrame& frame)
  {
    const ScreenRectangle& around = projection.Rectangle();
    const float own = OwnRoundingOf(std::max(std::abs(around.Left), std::abs(around.Right)),
      std::max(std::abs(around.Bottom), std::abs(around.Top)));
    const ScreenMargin& margin = projection.Margin();
    return { margin.Column + own, margin.Line + own + frame.HalfLine(), margin.Depth };
  }

  /** Stores where eight edges from index `first` on pass lines, if they belong to the outline. */
  VITRINE_INLINE void SetEdges(const HalfPlanes& edges, LaneMask isOutline, int first)
  {
    const Lanes column = edges.Start / -edges.Across, slope = edges.Along / -edges.Across;
    const LaneMask isKnown = column + slope - (column + slope) == AllLanes(0.0f);
    StoreLanes(Chosen(isKnown, column, AllLanes(BeyondAll)), this->Column + first);
    StoreLanes(Chosen(isKnown, slope, AllLanes(0.0f)), this->Slope + first);
    const LaneMask isAtLeft = (edges.Across > 0.0f) | ~isKnown;
    this->TooShort |= BitsOf(isOutline & (edges.Length < ShortestEdge));
    this->AtLeft |= BitsOf(isOutline & isAtLeft) << first;
    this->AtRight |= BitsOf(isOutline & ~isAtLeft) << first;
  }

  // The length of an edge in columns plus lines. The direction of a shorter edge is lost in rounding.
  static constexpr float ShortestEdge = 0x1p-10f;

  float Column[FewFacets::MostEdges]; ///< column on the first line
  float Slope[FewFacets::MostEdges];  ///< columns per line
  unsigned AtLeft = 0, AtRight = 0;   ///< a bit for each edge
  unsigned TooShort = 0;              ///< not 0 if any edge is too short
};

}

#endif
