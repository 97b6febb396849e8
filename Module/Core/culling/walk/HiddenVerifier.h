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

/** A part, and the box around it in world coordinates (WC). */
struct BoxedPart
{
  std::uint32_t Part;
  Box Bounds;
};

/**
 * Looks once more at parts of a band that were found hidden where they are: whether they are so where a device may draw them. Rasterisers snap corners to see what faces cover, so that these are
 * drawn beside themselves, too, and be it by 1/256 pixel: there their planes may be nearer than any of their corners; and slivers may have any depth. Lines are drawn beyond their ends.
 */
class HiddenVerifier
{
public:
  /**
   * @param tools  of the band, whose s-buffer is complete
   * @param view   of the band
   */
  HiddenVerifier(BandTools& tools, ShapeSource& shapes, const ScreenProjection& view);

  /** Puts 0 for those of up to eight parts, from `first` on, that are not hidden. */
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
  glm::dvec2 Snapping;              ///< in columns and lines
  FacePlanes::Thickness Thinnest{}; ///< in the world, of faces of which anything is known
  HiddenFaces Faces;
  ScreenProjection ApartView; ///< in which all reaches farther by a pixel
  HiddenFaces FacesApart;
  std::vector<std::uint32_t> ThinFaces; ///< of the part at hand
};

}

#endif
