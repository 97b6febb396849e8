#ifndef VITRINE_CORE_CULLING_HIDDEN_HIDDEN_FACES_H
#define VITRINE_CORE_CULLING_HIDDEN_HIDDEN_FACES_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/hidden/SampledFaces.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/culling/steady/CutFaces.h"
#include "Core/culling/steady/FaceBlock.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

class FaceOnLines;

/**
 * Which faces of a part are hidden by what stands in an s-buffer: where the box around a part shows, and those around runs of its faces
 * do, all of its faces may be hidden still. A face is tested by the rectangle around it, and where that shows by the rectangles around what it has
 * of one half of its lines and the other, down to single ones.
 * (after J. E. Warnock: A hidden surface algorithm for computer generated halftone pictures, 1969)
 */
class HiddenFaces
{
public:
  /** @param view  with which parts are projected */
  HiddenFaces(const SBuffer& lines, const ScreenProjection& view)
    : Lines(lines)
    , View(view)
  {
  }

  /** Whether all faces of a part are hidden. Those that face the eye come first: where any shows, one of them is likely to. */
  bool AreAll(const MeshProjection& projection);

  /** Whether all are, however many of them are so thin that nothing is known of their depth. */
  bool AreAllOfAnyThickness(const MeshProjection& projection);

  /**
   * The same of some of them, and of those that a device may cut.
   * @param faces    their numbers, in order
   * @param nearest  than which no other is nearer if it is not cut
   */
  bool AreSomeOfAnyThickness(
    const MeshProjection& projection, const std::vector<std::uint32_t>& faces, float nearest);

  /** Has faces that look one way count no more if the rectangles around them are hidden. */
  void ExcludeHidden(MeshProjection& projection, MeshProjection::Facing facing) const;

  /** Where something was found that may show: as long as that is not hidden, the part is not. */
  const ScreenRectangle& Witness() const { return this->Shown; }

private:
  bool AreCutFacesHidden(
    const MeshProjection& projection, const std::vector<std::uint32_t>& thin, float nearest);
  void BeginSampling(const MeshProjection& projection);
  bool AreFrontsHidden(const MeshProjection& projection);
  bool AreAllHidden(const MeshProjection& projection, const std::vector<std::uint32_t>& faces);
  bool AreHidden(const MeshProjection& projection, const FaceBlock& block, unsigned faces);
  bool AreHiddenTogether(const FaceBlock& block, unsigned faces) const;
  bool AreSampledHiddenOfAnyThickness(const MeshProjection& projection);
  bool AreHiddenOfAnyThickness(const MeshProjection& projection, FaceBlock block);
  bool IsHidden(const MeshProjection& projection, const FaceBlock& block, int lane);
  bool IsHidden(const FaceOnLines& face, const LineRange& lines);
  bool AreLinesHidden(const FaceOnLines& face, const LineRange& lines);
  bool AreSamplesHidden(const FaceOnLines& face, const LineRange& lines);
  bool AreSpansHidden(const FaceOnLines& face, const LineRange& lines);

  const SBuffer& Lines;
  const ScreenProjection& View;
  ScreenRectangle Shown{};
  SampledFaces WithSamples;
  std::vector<std::uint32_t> Sampled, Fronts, Others; ///< faces of the part at hand
  CutFaces Cuts;
  std::vector<std::uint32_t> MaybeCut;
};

/**
 * The greatest reversed depth of what the faces of a mesh have on a screen of so many columns and lines; below all depths if
 * that is nothing.
 */
float NearestOnScreen(const MeshProjection& mesh, int columns, int lines);

}

#endif
