#ifndef VITRINE_CORE_CULLING_STEADY_SLANTED_DEPTH_H
#define VITRINE_CORE_CULLING_STEADY_SLANTED_DEPTH_H

#include "Core/culling/screen/MeshProjection.h"

namespace vitrine
{

/** A lower bound of reversed depth in a cell of a line, linear between the sides of the cell. */
struct DepthBound
{
  float Left;
  float Right;
};

/** A lower bound of reversed depth: a plane minus a slack, or the farthest corner, whichever is nearer. */
struct SlantedDepth
{
  ScreenPoint Origin{}; ///< a point of the plane
  float ByColumn = 0.0f;
  float ByLine = 0.0f;
  float Slack = 0.0f;
  float Farthest = 0.0f;

  /**
   * Returns the bound between two columns and two lines: that of the plane or of the farthest corner, whichever is
   * nearer.
   */
  DepthBound BoundIn(float left, float right, float bottom, float top) const
  {
    const float farLine = this->ByLine > 0.0f ? bottom : top;
    const float base =
      this->Origin.Depth + (farLine - this->Origin.Line) * this->ByLine - this->Slack;
    const DepthBound bound{ base + (left - this->Origin.Column) * this->ByColumn,
      base + (right - this->Origin.Column) * this->ByColumn };
    const bool isNearer = bound.Left + bound.Right > 2.0f * this->Farthest;
    return isNearer ? bound : DepthBound{ this->Farthest, this->Farthest };
  }
};

}

#endif
