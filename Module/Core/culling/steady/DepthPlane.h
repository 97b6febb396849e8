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

/**
 * The depth of a face as a function of the place on the screen, with bounds for what a device may draw. Where the face
 * is too steep only the depths of its corners count (FaceSlopes.h).
 */
class DepthPlane
{
public:
  /**
   * @param margin    how far a device may move points, in all
   * @param snapping  the part of the margin by which it moves points to find what they cover
   */
  DepthPlane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
    const ScreenMargin& margin, const ScreenMargin& snapping);

  /** Makes the plane of a face of a mesh. A device rounds its corners the more the nearer they are. */
  DepthPlane(const MeshProjection& projection, const MeshFace& face);

  /** Lets the depths be off by `depth` more. */
  void Unsettle(float depth)
  {
    this->Below.Slack += depth;
    this->Below.Farthest -= depth;
    this->Nearest += depth;
  }

  /** Lets no depth be nearer than `depth`. */
  void LimitNearest(float depth) { this->Nearest = std::min(this->Nearest, depth); }

  /** A bound of depth that nothing that may be drawn is farther than. */
  const SlantedDepth& Bound() const { return this->Below; }

  /** Returns that bound between two columns and two lines: the plane or the farthest corner, whichever is nearer. */
  DepthBound BoundIn(float left, float right, float bottom, float top) const
  {
    return this->Below.BoundIn(left, right, bottom, top);
  }

  /**
   * Returns a segment that nothing drawn between two columns and two lines is nearer than: the plane or the nearest
   * corner, whichever is farther.
   */
  HideableSegment NearestSegment(float left, float right, float bottom, float top) const
  {
    const SlantedDepth& plane = this->Below;
    const float depth = this->NearDepthsAtOrigin(bottom, top);
    return { left, right, plane.Origin.Column, depth, plane.ByColumn, this->Nearest };
  }

  /**
   * Returns the greatest depth of the plane between two lines, at the column of its origin. It works on one pair of
   * lines or on eight (Lanes).
   */
  template <class Number>
  VITRINE_INLINE Number NearDepthsAtOrigin(const Number& bottom, const Number& top) const
  {
    const SlantedDepth& plane = this->Below;
    const Number line = plane.ByLine > 0.0f ? top : bottom;
    return plane.Origin.Depth + (line - plane.Origin.Line) * plane.ByLine + plane.Slack;
  }

  /** Returns the greatest depth between two columns and two lines. */
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
