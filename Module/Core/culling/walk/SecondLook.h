#ifndef VITRINE_CORE_CULLING_WALK_SECOND_LOOK_H
#define VITRINE_CORE_CULLING_WALK_SECOND_LOOK_H

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
class SecondLook
{
public:
  /**
   * Of thinner faces nothing is known: as shares of what a device snaps by, and of what its floats round of a column or a line. Corners that those round move by the root of 2 of that at most, each by its own distance:
   * across the face that takes less than three of four times as much as at its farthest corner, so that what a device snaps by is left. (Whatever is affine on the screen and no more than that at the corners changes by less than
   * twice as much over the face's width.)
   */
  static constexpr double ThinOfSnapping = 1.0;
  static constexpr double ThinOfRounding = 4.0;

  /** Planes of faces that are no thinner are so much steeper for a device at most: 4 / (4 - 2 * the root of 2) times, which is 3.41, and some to spare. */
  static constexpr double SteeperOnDevice = 4.2;

  /**
   * @param tools  of the band, whose s-buffer is complete
   * @param view   of the band
   */
  SecondLook(BandTools& tools, ShapeSource& shapes, const ScreenProjection& view);

  /** Puts 0 for those of up to eight parts, from `first` on, that are not hidden. */
  void DropShown(
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
