#ifndef VITRINE_STUDY_FACES_FACE_SCAN_H
#define VITRINE_STUDY_FACES_FACE_SCAN_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/geometry/Box.h"
#include "study/faces/ConvexFace.h"
#include "study/faces/FaceOrder.h"

namespace vitrine
{

/**
 * The scan conversion of a convex face at the middles of lines. If a line is one of pixels, this is all that is drawn
 * of the face. (A. V. Boreskov, the hierarchical s-buffer)
 *
 * Faces that share a side end at the same places and depths there. A face with a corner that is not finite covers
 * nothing.
 */
class FaceScan
{
public:
  FaceScan(const ConvexFace& face, int columns, int lines);

  /** Returns the lines that the face may cover. */
  const LineRange& Lines() const { return this->Range; }

  /** Returns the covered part of a line's middle on the screen. Its length is 0 if nothing is covered. */
  FaceSegment At(int line) const;

private:
  struct Crossing;

  Crossing CrossingOf(std::size_t side, double middle) const;

  const ConvexFace& Face;
  int Columns;
  LineRange Range;
};

/** Inserts a face into an s-buffer. */
void InsertFace(SBuffer& buffer, const ConvexFace& face);

/** Inserts a face into an s-buffer, using and extending the known orders of faces. */
void InsertFace(SBuffer& buffer, const ConvexFace& face, FaceOrder& order);

/**
 * Returns true if all of a face is hidden by surfaces that are nearer by more than `margin`. A face with a corner that
 * is not finite is not hidden.
 */
bool HidesFace(const SBuffer& buffer, const ConvexFace& face, float margin);

/**
 * Returns true if the box's faces towards the eye are hidden by surfaces that are nearer by more than `margin`. Then
 * all of the box is hidden. A box around the eye, or one that reaches behind the eye or in front of the near plane, is
 * not hidden.
 * @param sight       the eye, or the direction of a parallel view, in world coordinates (WC)
 * @param isParallel  true if `sight` is a direction
 */
bool HidesBox(const SBuffer& buffer, const ScreenProjection& projection, const Box& box,
  const glm::dvec3& sight, bool isParallel, float margin);

}

#endif
