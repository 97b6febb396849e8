/** The parts that a reveal lets show, and those in front, on the screen. */
#ifndef VITRINE_INSPECTION_REVEALED_PARTS_H
#define VITRINE_INSPECTION_REVEALED_PARTS_H

#include "Core/geometry/PixelRegion.h"
#include "inspection/FrontOfPart.h"
#include "inspection/PartOnScreen.h"
#include "scene/FadedLooks.h"
#include "scene/PartNumbers.h"

#include "vtkProp.h"
#include "vtkWeakPointer.h"

#include <optional>
#include <vector>

class vtkRenderer;

namespace vitrine
{

/** Returns the corners of a part's box, by the nodes of its actor's blocks. */
std::optional<BoxCorners> CornersOf(const ShownPart& part, FadedLooks& looks);

/** Returns the area of a part on the screen in pixels, at least 1: that of its faces, and at most that of its box. */
double AreaOf(const ShownPart& part, FadedLooks& looks, const PixelRays& rays);

/** The parts that shall show. */
struct RevealedParts
{
  struct Part
  {
    vtkWeakPointer<vtkProp> Prop;
    unsigned int Block;
  };
  std::vector<Part> Parts;

  bool HasAny() const;

  /** Returns true if the renderer still has all props of parts that live, and there are some. */
  bool AreIn(vtkRenderer* renderer) const;

  /** Returns the numbers of the parts. */
  PartSet NumbersIn(vtkRenderer* renderer) const;

  /** Returns the boxes of the parts, those of parts that have one. */
  std::vector<BoxCorners> Boxes(FadedLooks& looks) const;
};

/** Returns the smallest rectangle of pixels around some boxes, with a margin for lines and points of usual width. */
PixelRegion RegionOf(const std::vector<BoxCorners>& boxes, const PixelRays& rays);

}

#endif
