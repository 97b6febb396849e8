#ifndef VITRINE_CORE_CULLING_PLANE_BELOW_H
#define VITRINE_CORE_CULLING_PLANE_BELOW_H

#include "Core/culling/DepthPlane.h"
#include "Core/culling/MeshProjection.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine
{

/**
 * A plane that lies behind all faces between some corners, and near them: the one that fits the corners best by least squares, moved
 * back until none is behind it. What is between corners of which none is behind a plane is not behind it either.
 */
class PlaneBelow
{
public:
  /** Of corners, at least one, that a device may move by the margin. */
  static PlaneBelow Of(const std::vector<ScreenPoint>& corners, const ScreenMargin& margin)
  {
    PlaneBelow plane;
    plane.FitTo(corners);
    plane.MoveBehind(corners, margin);
    return plane;
  }

  /** Of what lies between two columns and two lines: the plane's or the farthest corner's, whichever is nearer. */
  DepthBound Within(float left, float right, float bottom, float top) const
  {
    const float base =
      this->Base + ((this->ByLine > 0.0f ? bottom : top) - this->Middle.Line) * this->ByLine;
    const DepthBound bound{ base + (left - this->Middle.Column) * this->ByColumn,
      base + (right - this->Middle.Column) * this->ByColumn };
    const bool isNearer = bound.Left + bound.Right > 2.0f * this->Farthest;
    return isNearer ? bound : DepthBound{ this->Farthest, this->Farthest };
  }

private:
  void FitTo(const std::vector<ScreenPoint>& corners)
  {
    ScreenPoint sum{ 0.0f, 0.0f, 0.0f };
    for (const ScreenPoint& corner : corners)
    {
      sum.Column += corner.Column;
      sum.Line += corner.Line;
      sum.Depth += corner.Depth;
    }
    const float share = 1.0f / static_cast<float>(corners.size());
    this->Middle = { sum.Column * share, sum.Line * share, sum.Depth * share };
    float xx = 0.0f, xy = 0.0f, yy = 0.0f, xd = 0.0f, yd = 0.0f;
    for (const ScreenPoint& corner : corners)
    {
      const float x = corner.Column - this->Middle.Column, y = corner.Line - this->Middle.Line,
                  depth = corner.Depth - this->Middle.Depth;
      xx += x * x;
      xy += x * y;
      yy += y * y;
      xd += x * depth;
      yd += y * depth;
    }
    const float area = xx * yy - xy * xy;
    const bool isWide = area > LeastWidth * xx * yy;
    this->ByColumn = isWide ? (xd * yy - yd * xy) / area : 0.0f;
    this->ByLine = isWide ? (yd * xx - xd * xy) / area : 0.0f;
  }

  void MoveBehind(const std::vector<ScreenPoint>& corners, const ScreenMargin& margin)
  {
    float base = 2.0f, farthest = 2.0f, largest = 0.0f;
    for (const ScreenPoint& corner : corners)
    {
      const float byColumn = (corner.Column - this->Middle.Column) * this->ByColumn;
      const float byLine = (corner.Line - this->Middle.Line) * this->ByLine;
      base = std::min(base, corner.Depth - byColumn - byLine);
      farthest = std::min(farthest, corner.Depth);
      largest = std::max(largest, std::abs(corner.Depth) + std::abs(byColumn) + std::abs(byLine));
    }
    this->Farthest = farthest - margin.Depth;
    this->Base = base - margin.Depth - std::abs(this->ByColumn) * margin.Column -
      std::abs(this->ByLine) * margin.Line - Rounding * largest;
  }

  static constexpr float Rounding = 0x1p-21f; ///< of a few sums and products in floats
  static constexpr float LeastWidth = 1e-3f;  ///< of corners that are not in one row

  ScreenPoint Middle{};
  float Base = 0.0f; ///< the depth there
  float ByColumn = 0.0f;
  float ByLine = 0.0f;
  float Farthest = 0.0f;
};

}

#endif
