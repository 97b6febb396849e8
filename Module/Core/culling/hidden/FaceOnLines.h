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

/** What a face may touch of lines, wherever a device draws it, and how near it may be there. */
class FaceOnLines
{
public:
  /** From where to where it reaches on each of eight lines; Left exceeds Right where it touches none of one. */
  struct ExtentLanes
  {
    float Left[LaneCount];
    float Right[LaneCount];
  };

  /** Of one of the faces of a block. */
  FaceOnLines(const MeshProjection& projection, const FaceBlock& block, int lane);

  /** Those that it may touch, of a screen that has so many. */
  LineRange Lines(int count) const;

  /** Around the samples that it touches between two places on lines; Left exceeds Right if there are none. */
  ScreenRectangle RectangleBetween(float bottom, float top, const SBuffer& buffer) const;

  /** What it touches of a line and of those above it that is not nearer to their sides than `inset`. */
  ExtentLanes Extents(int line, float inset) const;

  /** What it has between two columns and two places on lines, which it may touch all of. */
  HideableSegment Piece(float left, float right, float bottom, float top) const
  {
    return this->Plane.NearestSegment(
      left, right, std::max(bottom, this->Around.Bottom), std::min(top, this->Around.Top));
  }

  /** The same of a line and those above it that is not nearer to their sides than `inset`, whatever columns. */
  HideableSegmentLanes Pieces(int line, float inset) const;

private:
  FaceOnLines(
    const MeshProjection& projection, const MeshFace& face, const ScreenRectangle& around);

  ScreenRectangle Around; ///< the face, margin included
  ScreenEdge Edges[3];
  float Own;
  float Aside, Above;
  DepthPlane Plane;
};

}

#endif
