/** Where parts are in the world and in the window, by their boxes. */
#ifndef VITRINE_INSPECTION_PART_ON_SCREEN_H
#define VITRINE_INSPECTION_PART_ON_SCREEN_H

#include "Core/geometry/PixelRegion.h"
#include "inspection/PixelRays.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

class vtkActor;
class vtkDataObject;
class vtkProp;

namespace vitrine
{

/** The corners of a part's box, in world coordinates. */
using BoxCorners = std::array<glm::dvec3, 8>;

/** Returns the corners of a prop's box, or nothing if it has none. */
std::optional<BoxCorners> CornersOf(vtkProp* prop);

/** Returns the corners of the box of a block's data, placed as its actor is. */
std::optional<BoxCorners> CornersOfBlock(vtkActor* actor, vtkDataObject* data);

/**
 * Returns the smallest rectangle of pixels in the viewport that the corners span, with a margin. It is the whole
 * viewport if a corner is behind the eye, and empty if all are outside of it on one side.
 */
PixelRegion RegionOf(const BoxCorners& corners, const PixelRays& rays, int margin);

/**
 * Returns about how many pixels a part covers: half of the area of its faces on the screen, as a closed part shows each
 * place twice. Of many faces only some are looked at. Faces whose middle is outside of the viewport count nothing.
 */
double AreaOnScreen(vtkActor* actor, vtkDataObject* data, const PixelRays& rays);

}

#endif
