#ifndef VITRINE_CORE_CULLING_STEADY_DEPTH_PLANE_H
#define VITRINE_CORE_CULLING_STEADY_DEPTH_PLANE_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/SlantedDepth.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>

namespace vitrine
{

template <class Number>
struct FacePlaces;

/** A face's depth as a function of the place on the screen, and what is known of it where that is too steep (FaceSlopes.h). */
class DepthPlane
{
public:
  /**
   * @param margin    all that a device may move points by
   * @param snapping  what of that it moves them by to see what they cover
   */
  DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
    const ScreenMargin& margin, const ScreenMargin& snapping);

  /** Of a face of a mesh, whose corners a device rounds the more the nearer they are. */
  DepthPlane(const MeshProjection& projection, const MeshFace& face);

  /** Has what may be drawn be off by more. */
  void Unsettle(float depth)
  {
    this->Below.Slack += depth;
    this->Below.Farthest -= depth;
    this->Nearest += depth;
  }

  /** Has nothing of it be nearer than that. */
  void LimitNearest(float depth) { this->Nearest = std::min(this->Nearest, depth); }

  /** What nothing that may be drawn is farther than. */
  const SlantedDepth& Bound() const { return this->Below; }

  /** Of what lies between two columns and two lines: the plane's or the farthest corner's, whichever is nearer. */
  DepthBound BoundIn(float left, float right, float bottom, float top) const
  {
    return this->Below.BoundIn(left, right, bottom, top);
  }

  /** What may be drawn between two columns and two lines, as near as it may be: as the plane or the nearest corner, whichever is farther. */
  HideableSegment NearestSegment(float left, float right, float bottom, float top) const
  {
    const SlantedDepth& plane = this->Below;
    const float depth = this->NearDepthsAtOrigin(bottom, top);
    return { left, right, plane.Origin.Column, depth, plane.ByColumn, this->Nearest };
  }

  /** The depth of its plane at the column of its origin: between two lines, or between two of each of eight pairs (Lanes). */
  template <class Number>
  VITRINE_INLINE Number NearDepthsAtOrigin(const Number& bottom, const Number& top) const
  {
    const SlantedDepth& plane = this->Below;
    const Number line = plane.ByLine > 0.0f ? top : bottom;
    return plane.Origin.Depth + (line - plane.Origin.Line) * plane.ByLine + plane.Slack;
  }

  /** The greatest depth of that. */
  float NearestIn(float left, float right, float bottom, float top) const
  {
    return this->NearestSegment(left, right, bottom, top)
      .NearestAt(this->Below.ByColumn > 0.0f ? right : left);
  }

private:
  template <class Rounding>
  DepthPlane(const FacePlaces<float>& places, const Rounding& rounding, const ScreenMargin& margin,
    const ScreenMargin& snapping);

  SlantedDepth Below;
  float Nearest;
};

}

#endif
