#ifndef VITRINE_CORE_CULLING_HIDDEN_FACES_H
#define VITRINE_CORE_CULLING_HIDDEN_FACES_H

#include "Core/culling/LineExtent.h"
#include "Core/culling/MeshProjection.h"
#include "Core/culling/SBuffer.h"
#include "Core/culling/ScreenProjection.h"

#include <cstdint>

namespace vitrine
{

/**
 * Which faces of a part are hidden by what stands in an s-buffer: where the box around a part shows, and those around runs of its faces
 * do, all of its faces may be hidden still. A face is tested by the rectangle around it, and where that shows by the rectangles around what it has
 * of one half of its lines and the other, down to single ones.
 * (after J. E. Warnock: A hidden surface algorithm for computer generated halftone pictures, 1969)
 */
class HiddenFaces
{
public:
  enum class Sides
  {
    Front, ///< faces that face the eye
    Others
  };

  /** @param view  with which parts are projected */
  HiddenFaces(const SBuffer& lines, const ScreenProjection& view)
    : Lines(lines)
    , View(view)
  {
  }

  /** Whether all faces of a part are hidden, of which the facings are known. */
  bool AreAll(const MeshProjection& projection, Sides sides);

  /** Whether all faces are hidden that a device may draw as slivers, at other depths than they have. */
  bool AreThinOnes(const MeshProjection& projection);

  /** Has faces that look one way count no more if the rectangles around them are hidden. */
  void Drop(MeshProjection& projection, MeshProjection::Facing facing) const;

  /** Where something was found that may show: as long as that is not hidden, the part is not. */
  const ScreenRectangle& Witness() const { return this->Shown; }

private:
  class Outlined;

  static bool IsThin(const MeshProjection& projection, const MeshFace& face);
  bool IsHidden(const MeshProjection& projection, const MeshFace& face);
  bool IsHidden(const Outlined& face, const LineRange& lines);
  bool IsPieceHidden(const Outlined& face, const ScreenRectangle& piece);

  const SBuffer& Lines;
  const ScreenProjection& View;
  ScreenRectangle Shown{};
};

}

#endif
