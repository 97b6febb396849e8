#ifndef VITRINE_CORE_CULLING_HIDDEN_FACE_ON_LINES_H
#define VITRINE_CORE_CULLING_HIDDEN_FACE_ON_LINES_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/steady/DepthPlane.h"
#include "Core/culling/steady/FaceBlock.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>

namespace vitrine
{

/** The columns that a face may touch on lines, wherever a device draws it, and how near it may be there. */
class FaceOnLines
{
public:
  /** The columns that the face touches on each of eight lines. Left exceeds Right on lines that it does not touch. */
  struct ExtentLanes
  {
    float Left[LaneCount];
    float Right[LaneCount];
  };

  /** Prepares one face of a block. */
  FaceOnLines(const MeshProjection& projection, const FaceBlock& block, int lane);

  /** Returns the lines that the face may touch, of a screen with `count` lines. */
  LineRange Lines(int count) const;

  /**
   * Returns the rectangle around the samples that the face touches between two places on lines. Left exceeds Right if
   * there are none.
   */
  ScreenRectangle RectangleBetween(float bottom, float top, const SBuffer& buffer) const;

  /**
   * Returns the columns that the face touches on a line and on the seven above it. Places nearer than `inset` to the
   * sides of a line do not count.
   */
  ExtentLanes Extents(int line, float inset) const;

  /** Returns the segment between two columns and two places on lines, as if the face touched all of it. */
  HideableSegment Piece(float left, float right, float bottom, float top) const
  {
    return this->Plane.NearestSegment(
      left, right, std::max(bottom, this->Around.Bottom), std::min(top, this->Around.Top));
  }

  /**
   * Returns the segments on a line and on the seven above it, over all columns. Places nearer than `inset` to the sides
   * of a line do not count.
   */
  HideableSegmentLanes Pieces(int line, float inset) const;

private:
  FaceOnLines(
    const MeshProjection& projection, const MeshFace& face, const ScreenRectangle& around);

  ScreenRectangle Around; ///< the rectangle of the face, margin included
  ScreenEdge Edges[3];
  float Own;
  float Aside, Above;
  DepthPlane Plane;
};

}

#endif
