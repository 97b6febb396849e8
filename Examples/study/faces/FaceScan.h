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
 * A convex face line by line, at the lines' middles: at the screen's own resolution, where a line is one of pixels, that is all that
 * is drawn of it. (A. V. Boreskov, the hierarchical s-buffer)
 *
 * Faces that share a side end at the same places and depths there. Faces with a corner that is not finite cover nothing.
 */
class FaceScan
{
public:
  FaceScan(const ConvexFace& face, int columns, int lines);

  /** Those that it may cover. */
  const LineRange& Lines() const { return this->Range; }

  /** What it covers of a line's middle on the screen; without length where that is nothing. */
  FaceSegment At(int line) const;

private:
  struct Crossing;

  Crossing CrossingOf(std::size_t side, double middle) const;

  const ConvexFace& Face;
  int Columns;
  LineRange Range;
};

/** Puts a face into an s-buffer. */
void InsertFace(SBuffer& buffer, const ConvexFace& face);

/** The same, by what is known of the order of faces. */
void InsertFace(SBuffer& buffer, const ConvexFace& face, FaceOrder& order);

/** Whether all of a face is behind what is nearer by more than `margin`. One with a corner that is not finite is not. */
bool HidesFace(const SBuffer& buffer, const ConvexFace& face, float margin);

/**
 * Whether the faces of a box that look towards the eye are behind what is nearer by more than `margin`: then all of the box
 * is. A box around the eye, or that reaches behind it or before the near plane, is not.
 * @param sight       the eye, or, of a parallel view, its direction, in world coordinates
 * @param isParallel  which of the two it is
 */
bool HidesBox(const SBuffer& buffer, const ScreenProjection& projection, const Box& box,
  const glm::dvec3& sight, bool isParallel, float margin);

}

#endif
