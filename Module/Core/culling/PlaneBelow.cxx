#include "Core/culling/PlaneBelow.h"

#include "Core/culling/Lanes.h"

#include <cmath>

namespace vitrine
{

namespace
{

const float LeastWidth = 1e-3f; // of corners that are not in one row

/** Eight corners as they lie around the origin, which those that do not count are put at. */
struct CornerLanes
{
  LaneMask Counts;
  Lanes X, Y, Depth;

  VITRINE_INLINE CornerLanes(const CountedPoints& points, std::size_t first, const ScreenPoint& at)
  {
    __builtin_memcpy(&this->Counts, points.Counts + first, sizeof(this->Counts));
    const Lanes none = AllLanes(0.0f);
    this->X = this->Counts ? LoadLanes(points.Columns + first) - at.Column : none;
    this->Y = this->Counts ? LoadLanes(points.Lines + first) - at.Line : none;
    this->Depth = this->Counts ? LoadLanes(points.Depths + first) - at.Depth : none;
  }
};

VITRINE_INLINE SlantedDepth BestFit(const CountedPoints& corners, const ScreenPoint& origin)
{
  Lanes n{}, x{}, y{}, d{}, xx{}, xy{}, yy{}, xd{}, yd{};
  for (std::size_t i = 0; i < corners.Room; i += LaneCount)
  {
    const CornerLanes corner(corners, i, origin);
    n += corner.Counts ? AllLanes(1.0f) : AllLanes(0.0f);
    x += corner.X;
    y += corner.Y;
    d += corner.Depth;
    xx += corner.X * corner.X;
    xy += corner.X * corner.Y;
    yy += corner.Y * corner.Y;
    xd += corner.X * corner.Depth;
    yd += corner.Y * corner.Depth;
  }
  const float share = 1.0f / SumOfLanes(n);
  const float sumX = SumOfLanes(x), sumY = SumOfLanes(y), middleDepth = SumOfLanes(d) * share;
  const float ofXX = SumOfLanes(xx) - sumX * sumX * share;
  const float ofXY = SumOfLanes(xy) - sumX * sumY * share;
  const float ofYY = SumOfLanes(yy) - sumY * sumY * share;
  const float ofXD = SumOfLanes(xd) - sumX * middleDepth;
  const float ofYD = SumOfLanes(yd) - sumY * middleDepth;
  const float area = ofXX * ofYY - ofXY * ofXY;
  const bool isWide = area > LeastWidth * ofXX * ofYY;
  SlantedDepth plane;
  plane.Origin = origin;
  plane.ByColumn = isWide ? (ofXD * ofYY - ofYD * ofXY) / area : 0.0f;
  plane.ByLine = isWide ? (ofYD * ofXX - ofXD * ofXY) / area : 0.0f;
  return plane;
}

VITRINE_INLINE void MoveBehind(
  const CountedPoints& corners, const ScreenMargin& margin, SlantedDepth& plane)
{
  const ScreenPoint origin = plane.Origin;
  Lanes base{}, farthest{}, largest{};
  for (std::size_t i = 0; i < corners.Room; i += LaneCount)
  {
    const CornerLanes corner(corners, i, origin);
    const Lanes byColumn = corner.X * plane.ByColumn, byLine = corner.Y * plane.ByLine;
    base = LeastOf(base, corner.Depth - byColumn - byLine);
    farthest = LeastOf(farthest, corner.Depth);
    largest = GreatestOf(largest, SizeOf(corner.Depth) + SizeOf(byColumn) + SizeOf(byLine));
  }
  plane.Origin.Depth = origin.Depth + LeastLane(base);
  plane.Farthest = origin.Depth + LeastLane(farthest) - margin.Depth;
  plane.Slack = margin.Depth + std::abs(plane.ByColumn) * margin.Column +
    std::abs(plane.ByLine) * margin.Line +
    RoundingOfFloats * (std::abs(origin.Depth) + GreatestLane(largest));
}
}

VITRINE_FOR_EACH_PROCESSOR
SlantedDepth PlaneBelow(
  const CountedPoints& corners, const ScreenPoint& origin, const ScreenMargin& margin)
{
  SlantedDepth plane = BestFit(corners, origin);
  MoveBehind(corners, margin, plane);
  return plane;
}

}
