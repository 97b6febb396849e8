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
 * Tests whether the faces of a part are hidden by an s-buffer. They may all be hidden even if the box of the part and
 * the boxes of runs of faces show.
 *
 * A face is tested by its rectangle. If that shows, the rectangles of its lower and its upper half are tested, and so
 * on down to single lines.
 * (after J. E. Warnock: A hidden surface algorithm for computer generated halftone pictures, 1969)
 */
class HiddenFaces
{
public:
  /** @param view  the view of the projections */
  HiddenFaces(const SBuffer& lines, const ScreenProjection& view)
    : Lines(lines)
    , View(view)
  {
  }

  /**
   * Returns true if all faces are hidden. Front faces are tested first: if any face shows, one of them is likely to.
   */
  bool AreAll(const MeshProjection& projection);

  /**
   * Returns true if all faces are hidden, even if some are slivers, of whose depth floats tell nothing. The depths of
   * slivers are found in doubles.
   */
  bool AreAllOfAnyThickness(const MeshProjection& projection);

  /**
   * Returns true if all of the given faces are hidden, and all faces that a device may cut at the sides of the view.
   * Faces may be slivers.
   * @param faces    numbers of faces, in ascending order
   * @param nearest  no other face is nearer than this depth, unless it is cut
   */
  bool AreSomeOfAnyThickness(
    const MeshProjection& projection, const std::vector<std::uint32_t>& faces, float nearest);

  /** Excludes faces of one facing from the projection if their rectangles are hidden, so that they are not inserted. */
  void ExcludeHidden(MeshProjection& projection, MeshProjection::Facing facing) const;

  /** A place where a face may show. As long as this is not hidden, the part is not. */
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
  std::vector<std::uint32_t> Sampled, Fronts, Others; ///< numbers of faces of the current part
  CutFaces Cuts;
  std::vector<std::uint32_t> MaybeCut;
};

/**
 * Returns the greatest reversed depth of the faces of a mesh on a screen with this number of columns and lines. Returns
 * -1 if no face lies on the screen.
 */
float NearestOnScreen(const MeshProjection& mesh, int columns, int lines);

}

#endif
