#ifndef VITRINE_CORE_CULLING_WALK_HIDDEN_VERIFIER_H
#define VITRINE_CORE_CULLING_WALK_HIDDEN_VERIFIER_H

#include "Core/culling/hidden/HiddenFaces.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/culling/steady/FacePlanes.h"
#include "Core/culling/walk/BandParts.h"
#include "Core/culling/walk/ShapeSource.h"
#include "Core/geometry/Box.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** A part, and its box in world coordinates (WC). */
struct BoxedPart
{
  std::uint32_t Part;
  Box Bounds;
};

/**
 * Verifies that parts of a band are hidden wherever a device may draw them. BandParts has found them hidden at their
 * exact place.
 *
 * A rasteriser snaps corners to a grid, so it draws faces beside their place, if only by 1/256 pixel. There the plane
 * of a face may be nearer than any of its corners. A sliver may have any depth, and lines are drawn beyond their ends.
 */
class HiddenVerifier
{
public:
  /**
   * @param tools  the data structures of the band, whose s-buffer is complete
   * @param view   the view, of the lines of this band
   */
  HiddenVerifier(BandTools& tools, ShapeSource& shapes, const ScreenProjection& view);

  /** Verifies up to eight parts, from index `first` on. Sets `areHidden` to 0 for those that may show. */
  void Verify(
    const std::vector<BoxedPart>& parts, std::size_t first, std::vector<std::uint8_t>& areHidden);

private:
  bool IsHidden(std::uint32_t part, const RectangleLanes& rectangles, int lane);
  float FindThinFaces(std::uint32_t part);
  float TiltOf(const ScreenRectangle& around, float depth) const;
  bool IsHiddenApart(std::uint32_t part, const ScreenRectangle& around);
  bool Project(std::uint32_t part);
  bool AreFacesHidden(std::uint32_t part, const ScreenRectangle& around, bool isBoxHidden);
  bool AreItsLinesHidden(std::uint32_t part);

  BandTools& Tools;
  ShapeSource& Shapes;
  const ScreenProjection& View;
  PlaneView Planes;
  glm::dvec2 Snapping; ///< how far a device snaps corners, in columns and lines
  /** Thinner faces have no known depth. In units of world coordinates (WC). */
  FacePlanes::Thickness Thinnest{};
  HiddenFaces Faces;
  ScreenProjection ApartView; ///< the view with all rectangles grown by a pixel
  HiddenFaces FacesApart;
  std::vector<std::uint32_t> ThinFaces; ///< thin faces of the current part
};

}

#endif
