#include "Core/culling/PlaneBelow.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

const float LeastWidth = 1e-3f; // of corners that are not in one row

ScreenPoint MiddleOf(const std::vector<ScreenPoint>& corners)
{
  ScreenPoint sum{ 0.0f, 0.0f, 0.0f };
  for (const ScreenPoint& corner : corners)
  {
    sum.Column += corner.Column;
    sum.Line += corner.Line;
    sum.Depth += corner.Depth;
  }
  const float share = 1.0f / static_cast<float>(corners.size());
  return { sum.Column * share, sum.Line * share, sum.Depth * share };
}

SlantedDepth BestFit(const std::vector<ScreenPoint>& corners)
{
  SlantedDepth plane;
  plane.Origin = MiddleOf(corners);
  float xx = 0.0f, xy = 0.0f, yy = 0.0f, xd = 0.0f, yd = 0.0f;
  for (const ScreenPoint& corner : corners)
  {
    const float x = corner.Column - plane.Origin.Column, y = corner.Line - plane.Origin.Line,
                depth = corner.Depth - plane.Origin.Depth;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xd += x * depth;
    yd += y * depth;
  }
  const float area = xx * yy - xy * xy;
  const bool isWide = area > LeastWidth * xx * yy;
  plane.ByColumn = isWide ? (xd * yy - yd * xy) / area : 0.0f;
  plane.ByLine = isWide ? (yd * xx - xd * xy) / area : 0.0f;
  return plane;
}

void MoveBehind(
  const std::vector<ScreenPoint>& corners, const ScreenMargin& margin, SlantedDepth& plane)
{
  float base = 2.0f, farthest = 2.0f, largest = 0.0f;
  for (const ScreenPoint& corner : corners)
  {
    const float byColumn = (corner.Column - plane.Origin.Column) * plane.ByColumn;
    const float byLine = (corner.Line - plane.Origin.Line) * plane.ByLine;
    base = std::min(base, corner.Depth - byColumn - byLine);
    farthest = std::min(farthest, corner.Depth);
    largest = std::max(largest, std::abs(corner.Depth) + std::abs(byColumn) + std::abs(byLine));
  }
  plane.Farthest = farthest - margin.Depth;
  plane.Origin.Depth = base;
  plane.Slack = margin.Depth + std::abs(plane.ByColumn) * margin.Column +
    std::abs(plane.ByLine) * margin.Line + RoundingOfFloats * largest;
}
}

SlantedDepth PlaneBelow(const std::vector<ScreenPoint>& corners, const ScreenMargin& margin)
{
  SlantedDepth plane = BestFit(corners);
  MoveBehind(corners, margin, plane);
  return plane;
}

}
