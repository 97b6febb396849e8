#ifndef VITRINE_CORE_CULLING_DEPTH_PLANE_H
#define VITRINE_CORE_CULLING_DEPTH_PLANE_H

#include "Core/culling/MeshProjection.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

/** A lower bound of reversed depth in a cell of a line, linear between the cell's sides. */
struct DepthBound
{
  float Left;
  float Right;
};

/** A face's depth as a function of the place on the screen, and what is known of it where that is too steep. */
class DepthPlane
{
public:
  DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
    const ScreenMargin& margin, float aside, float above)
    : Origin(a)
    , Farthest(std::min(std::min(a.Depth, b.Depth), c.Depth) - margin.Depth)
    , Nearest(std::max(std::max(a.Depth, b.Depth), c.Depth) + margin.Depth)
  {
    const float column1 = b.Column - a.Column, line1 = b.Line - a.Line, depth1 = b.Depth - a.Depth;
    const float column2 = c.Column - a.Column, line2 = c.Line - a.Line, depth2 = c.Depth - a.Depth;
    const float area = column1 * line2 - column2 * line1;
    this->ByColumn = (depth1 * line2 - depth2 * line1) / area;
    this->ByLine = (depth2 * column1 - depth1 * column2) / area;
    const float ownOfArea = Rounding * (std::abs(column1 * line2) + std::abs(column2 * line1));
    const float ownByColumn = (Rounding * (std::abs(depth1 * line2) + std::abs(depth2 * line1)) +
                                std::abs(this->ByColumn) * ownOfArea) /
      std::abs(area);
    const float ownByLine = (Rounding * (std::abs(depth2 * column1) + std::abs(depth1 * column2)) +
                              std::abs(this->ByLine) * ownOfArea) /
      std::abs(area);
    this->Slack = margin.Depth + std::abs(this->ByColumn) * aside + std::abs(this->ByLine) * above +
      ownByColumn * (std::max(std::abs(column1), std::abs(column2)) + SBuffer::TileWidth) +
      ownByLine * std::max(std::abs(line1), std::abs(line2));
  }

  /** Of what lies between two columns and two lines: the plane's or the farthest corner's, whichever is nearer. */
  DepthBound Within(float left, float right, float bottom, float top) const
  {
    const float farLine = this->ByLine > 0.0f ? bottom : top;
    const float base =
      this->Origin.Depth + (farLine - this->Origin.Line) * this->ByLine - this->Slack;
    const DepthBound bound{ base + (left - this->Origin.Column) * this->ByColumn,
      base + (right - this->Origin.Column) * this->ByColumn };
    const bool isNearer = bound.Left + bound.Right > 2.0f * this->Farthest;
    return isNearer ? bound : DepthBound{ this->Farthest, this->Farthest };
  }

  /** The greatest depth between two columns and two lines: the plane's or the nearest corner's, whichever is farther. */
  float NearestWithin(float left, float right, float bottom, float top) const
  {
    const float column = this->ByColumn > 0.0f ? right : left;
    const float line = this->ByLine > 0.0f ? top : bottom;
    const float nearest = this->Origin.Depth + (line - this->Origin.Line) * this->ByLine +
      (column - this->Origin.Column) * this->ByColumn + this->Slack;
    return nearest < this->Nearest ? nearest : this->Nearest; // as where it is no number
  }

private:
  static constexpr float Rounding = 0x1p-21f; ///< of a few sums and products in floats

  ScreenPoint Origin;
  float Farthest;
  float Nearest;
  float ByColumn;
  float ByLine;
  float Slack;
};

}

#endif
