#include "Core/culling/FewFacetsCoverage.h"

#include "Core/culling/FaceSlopes.h"
#include "Core/culling/LineExtent.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

const float Nowhere = 3e38f;
const float BeforeAll = 2.0f; // above all depths
// Columns and lines: where a shorter edge leads is rounding.
const float ShortestEdge = 0x1p-10f;

const float LeastRise = 0x1p-20f; // of an edge that is not level, in lines

/** Lines, and columns of the screen, that a mesh may cover; what is looked at counts from the first ones. */
struct Frame
{
  LineRange Lines;
  float Left, Right;
  float Inset; ///< from a line's sides to samples

  VITRINE_INLINE Frame(const SBuffer& buffer, const ScreenRectangle& around)
    : Left(std::max(around.Left, 0.0f))
    , Right(std::min(around.Right, static_cast<float>(buffer.Columns())))
    , Inset(buffer.Samples().Inset())
  {
    const float bottom = std::max(around.Bottom, 0.0f);
    const float top = std::min(around.Top, static_cast<float>(buffer.Lines()));
    if (this->Left <= this->Right && bottom <= top)
    {
      this->Lines = { static_cast<int>(std::ceil(bottom - this->Inset)),
        static_cast<int>(std::floor(top - 1.0f + this->Inset)) };
    }
  }

  /** The middle of the first line. */
  float FirstMiddle() const { return static_cast<float>(this->Lines.First) + 0.5f; }

  float Width() const { return this->Right - this->Left; }
  float Height() const { return static_cast<float>(this->Lines.Last - this->Lines.First); }

  /** From a line's middle to the farthest samples in it. */
  float HalfLine() const { return 0.5f - this->Inset; }
};

/** The points of a mesh as they lie around the first column and the middle of the first line of a frame. */
struct PointLanes
{
  Lanes X, Y, Depth;

  VITRINE_INLINE PointLanes(const MeshProjection& projection, const Frame& frame)
    : X(LoadLanes(projection.ColumnsOfPoints().data()) - frame.Left)
    , Y(LoadLanes(projection.LinesOfPoints().data()) - frame.FirstMiddle())
    , Depth(LoadLanes(projection.DepthsOfPoints().data()))
  {
  }

  VITRINE_INLINE PointLanes(const PointLanes& points, const std::int32_t* lanes)
    : X(Picked(points.X, LoadMask(lanes)))
    , Y(Picked(points.Y, LoadMask(lanes)))
    , Depth(Picked(points.Depth, LoadMask(lanes)))
  {
  }
};

/** How far facets may be. Of slivers little is known of that, but where they are. */
class FacetPlanes
{
public:
  VITRINE_INLINE FacetPlanes(const FewFacets& facets, const PointLanes& points,
    const MeshProjection& projection, MeshProjection::Facing facing, const Frame& frame)
  {
    const PointLanes a(points, facets.Corners[0]), b(points, facets.Corners[1]),
      c(points, facets.Corners[2]), d(points, facets.Corners[3]);
    const ScreenMargin& margin = projection.Margin();
    const ScreenMargin& snapping = projection.Snapping();
    const ScreenMargin off = OffOf(margin, snapping);
    const Lanes turn = (b.X - a.X) * (c.Y - a.Y) - (c.X - a.X) * (b.Y - a.Y);
    const bool isFront = facing == MeshProjection::Facing::Front;
    this->Counted = BitsOf(isFront ? turn > 0.0f : turn < 0.0f);

    const FaceSlopes<Lanes> slopes = SlopesOf(a, b, c, off, snapping);
    const FaceSlopes<Lanes> others = SlopesOf(PointLanes(points, facets.Others[0]),
      PointLanes(points, facets.Others[1]), PointLanes(points, facets.Others[2]), off, snapping);
    const Lanes unsteady = GreatestOf(slopes.Unsteady, others.Unsteady);
    const Lanes beyond = GreatestOf(slopes.Beyond, others.Beyond);
    const Lanes steepX = GreatestOf(SizeOf(slopes.ByColumn.Value), SizeOf(others.ByColumn.Value));
    const Lanes steepY = GreatestOf(SizeOf(slopes.ByLine.Value), SizeOf(others.ByLine.Value));
    const Lanes byX = slopes.ByColumn.Value, byY = slopes.ByLine.Value;
    const Lanes farX = SizeOf(a.X) + GreatestOf(SizeOf(d.X), AllLanes(frame.Width()));
    const Lanes farY = SizeOf(a.Y) + GreatestOf(SizeOf(d.Y), AllLanes(frame.Height()));
    const Lanes base = a.Depth - a.X * byX - a.Y * byY;
    const Lanes bent = LeastOf(d.Depth - (base + d.X * byX + d.Y * byY), AllLanes(0.0f));
    const Lanes own = slopes.ByColumn.Own * farX + slopes.ByLine.Own * farY +
      RoundingOfFloats * (SizeOf(base) + SizeOf(a.Depth) + SizeOf(byX) * farX + SizeOf(byY) * farY);
    const Lanes slack = margin.Depth + steepX * margin.Column +
      steepY * (margin.Line + frame.HalfLine()) + unsteady + own;
    const Lanes start = base + bent - slack;
    const LaneMask isSteady =
      (unsteady + own < MostUnsteady) & (start + byX + byY - (start + byX + byY) == AllLanes(0.0f));
    StoreLanes(start, this->Start);
    StoreLanes(byX, this->ByX);
    StoreLanes(byY, this->ByY);
    this->Steady = this->Counted & BitsOf(isSteady);
    const Lanes farthest =
      LeastOf(LeastOf(a.Depth, b.Depth), LeastOf(c.Depth, d.Depth)) - margin.Depth - beyond;
    this->Farthest = LeastLane(LaneBits(this->Counted) ? farthest : AllLanes(BeforeAll));
    if (this->Steady != this->Counted)
    {
      this->FindPlaces(a, b, c, d, farthest, margin, frame);
    }
  }

  /** A bit for each that counts. */
  unsigned Bits() const { return this->Counted; }

  /** Lines come on which depths are asked for. */
  VITRINE_INLINE void Begin(Lanes y)
  {
    this->Y = y;
    for (unsigned bits = this->Steady; bits != 0; bits &= bits - 1)
    {
      const int i = LowestBit(bits);
      this->OnLines[i] = this->Start[i] + this->ByY[i] * y;
    }
  }

  /** At a column of those lines what all that may be drawn there is no farther than; BeforeAll where that is nothing. */
  VITRINE_INLINE Lanes At(float x) const
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
      depth = LeastOf(isThere ? AllLanes(farthest) : AllLanes(BeforeAll), depth);
    }
    return GreatestOf(depth, AllLanes(this->Farthest));
  }

private:
  VITRINE_INLINE static FaceSlopes<Lanes> SlopesOf(const PointLanes& a, const PointLanes& b,
    const PointLanes& c, const ScreenMargin& off, const ScreenMargin& snapping)
  {
    const FaceSides<Lanes> columns{ b.X - a.X, c.X - a.X, off.Column };
    const FaceSides<Lanes> lines{ b.Y - a.Y, c.Y - a.Y, off.Line };
    const FaceSides<Lanes> depths{ b.Depth - a.Depth, c.Depth - a.Depth, off.Depth };
    return FaceSlopes<Lanes>(columns, lines, depths, snapping);
  }

  // Of depth. Of what is known less well only the farthest corner counts.
  static constexpr float MostUnsteady = 0x1p-12f;

  VITRINE_INLINE void FindPlaces(const PointLanes& a, const PointLanes& b, const PointLanes& c,
    const PointLanes& d, Lanes farthest, const ScreenMargin& margin, const Frame& frame)
  {
    const float aside = margin.Column + OwnRoundingOf(frame.Right, 0.0f);
    const float above = margin.Line + frame.HalfLine() +
      OwnRoundingOf(0.0f, static_cast<float>(frame.Lines.Last + 1));
    StoreLanes(LeastOf(LeastOf(a.X, b.X), LeastOf(c.X, d.X)) - aside, this->Left);
    StoreLanes(GreatestOf(GreatestOf(a.X, b.X), GreatestOf(c.X, d.X)) + aside, this->Right);
    StoreLanes(LeastOf(LeastOf(a.Y, b.Y), LeastOf(c.Y, d.Y)) - above, this->Bottom);
    StoreLanes(GreatestOf(GreatestOf(a.Y, b.Y), GreatestOf(c.Y, d.Y)) + above, this->Top);
    StoreLanes(farthest, this->FarthestOf);
  }

  unsigned Counted, Steady; ///< a bit for each
  float Farthest;           ///< of all
  float Start[LaneCount], ByX[LaneCount], ByY[LaneCount];
  float Left[LaneCount], Right[LaneCount], Bottom[LaneCount], Top[LaneCount];
  float FarthestOf[LaneCount];
  Lanes Y;                  ///< of lines
  Lanes OnLines[LaneCount]; ///< depths of steady ones there, at the first column
};

/** The edges of an outline: where each passes lines, drawn in by what a device may move it by. */
class OutlineSides
{
public:
  VITRINE_INLINE OutlineSides(const FewFacets& facets, unsigned counted, const PointLanes& points,
    const MeshProjection& projection, MeshProjection::Facing facing, const Frame& frame)
  {
    const ScreenRectangle& around = projection.Rectangle();
    const float own = OwnRoundingOf(std::max(std::abs(around.Left), std::abs(around.Right)),
      std::max(std::abs(around.Bottom), std::abs(around.Top)));
    const float aside = projection.Margin().Column + own;
    const float above = projection.Margin().Line + own + frame.HalfLine();
    const bool isFront = facing == MeshProjection::Facing::Front;
    const LaneMask isCounted = LaneMask{} + static_cast<std::int32_t>(counted);
    for (int first = 0; first < FewFacets::MostEdges; first += LaneCount)
    {
      const LaneMask isLeft = (LoadMask(facets.Left + first) & isCounted) != 0;
      const LaneMask isRight = (LoadMask(facets.Right + first) & isCounted) != 0;
      const PointLanes from(points, facets.From + first), to(points, facets.To + first);
      // What is covered lies where across * x + along * y + start is not negative; a level edge is taken to rise a little.
      const LaneMask isForward = isFront ? isLeft : isRight;
      const Lanes rise = isForward ? from.Y - to.Y : to.Y - from.Y;
      const LaneMask isLevel = SizeOf(rise) < LeastRise;
      const Lanes across = isLevel ? AllLanes(LeastRise) : rise;
      const Lanes along = isForward ? to.X - from.X : from.X - to.X;
      const Lanes rounding = RoundingOfFloats *
        (SizeOf(across) * (SizeOf(from.X) + frame.Width()) +
          SizeOf(along) * (SizeOf(from.Y) + frame.Height()));
      const Lanes raised =
        isLevel ? 2.0f * LeastRise * (SizeOf(from.X) + frame.Width()) : AllLanes(0.0f);
      const Lanes start = -(rise * from.X + along * from.Y) -
        (SizeOf(across) * aside + SizeOf(along) * above) - rounding - raised;
      const Lanes column = start / -across, slope = along / -across;
      const LaneMask isKnown = column + slope - (column + slope) == AllLanes(0.0f);
      StoreLanes(isKnown ? column : AllLanes(Nowhere), this->Column + first);
      StoreLanes(isKnown ? slope : AllLanes(0.0f), this->Slope + first);
      const LaneMask isOutline = isLeft ^ isRight, isAtLeft = (across > 0.0f) | ~isKnown;
      this->TooShort |= BitsOf(isOutline & (SizeOf(rise) + SizeOf(along) < ShortestEdge));
      this->AtLeft |= BitsOf(isOutline & isAtLeft) << first;
      this->AtRight |= BitsOf(isOutline & ~isAtLeft) << first;
    }
  }

  /** Whether it tells what is covered: there is an outline, and where each of its edges leads is known. */
  bool AreClear() const { return this->AtLeft != 0 && this->AtRight != 0 && this->TooShort == 0; }

  /** Columns between which eight lines are covered. */
  VITRINE_INLINE void Between(Lanes y, Lanes& left, Lanes& right) const
  {
    left = AllLanes(-Nowhere);
    right = AllLanes(Nowhere);
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
  float Column[FewFacets::MostEdges]; ///< on the first line
  float Slope[FewFacets::MostEdges];  ///< columns a line
  unsigned AtLeft = 0, AtRight = 0;   ///< a bit for each edge
  unsigned TooShort = 0;              ///< not 0 if any is
};
}

VITRINE_FOR_EACH_PROCESSOR
std::optional<std::size_t> FewFacetsCoverage::Insert(SBuffer& buffer, const FewFacets& facets,
  const MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part)
{
  const Frame frame(buffer, projection.Rectangle());
  if (frame.Lines.First > frame.Lines.Last)
  {
    return 0;
  }
  const PointLanes points(projection, frame);
  FacetPlanes planes(facets, points, projection, facing, frame);
  if (planes.Bits() == 0)
  {
    return 1;
  }
  const OutlineSides sides(facets, planes.Bits(), points, projection, facing, frame);
  if (!sides.AreClear())
  {
    return std::nullopt;
  }
  for (int first = frame.Lines.First; first <= frame.Lines.Last; first += LaneCount)
  {
    const bool isCovered = frame.Lines.Last - frame.Lines.First >= LaneCount &&
      buffer.OpenLines(
        first, frame.Lines.Last, frame.Left, frame.Right, projection.Rectangle().Nearest) == 0;
    if (isCovered)
    {
      continue;
    }
    const Lanes y = LanesFrom(static_cast<float>(first - frame.Lines.First));
    Lanes left, right;
    sides.Between(y, left, right);
    planes.Begin(y);
    const LaneMask isThere =
      (y <= AllLanes(frame.Height())) & (left <= right) & (left <= frame.Width()) & (right >= 0.0f);
    left = GreatestOf(left + frame.Left, AllLanes(frame.Left));
    right = LeastOf(right + frame.Left, AllLanes(frame.Right));
    buffer.InsertLines(first, isThere ? left : AllLanes(Nowhere),
      isThere ? right : AllLanes(-Nowhere), part,
      [&](float column) VITRINE_INLINED
      {
        const Lanes depth = planes.At(column - frame.Left);
        return depth < BeforeAll ? depth : AllLanes(SampleDepths::NotCovered);
      });
  }
  return std::size_t{ LaneCount } + static_cast<std::size_t>(frame.Lines.Last - frame.Lines.First);
}

}
