/** Finds the props that may be drawn in a rectangle of pixels. */
#ifndef VITRINE_INSPECTION_PROPS_IN_REGION_H
#define VITRINE_INSPECTION_PROPS_IN_REGION_H

#include "Core/geometry/PixelRegion.h"

#include <vector>

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/**
 * Returns the visible props of the renderer that may be drawn within a rectangle of the window's pixels, in their
 * order: those whose bounds meet the pyramid of the rectangle, with a margin for wide lines and points, and those that
 * may be drawn outside of their bounds. Props of the overlay, and volumes, are left out.
 */
std::vector<vtkProp*> PropsIn(vtkRenderer* renderer, const PixelRegion& region);

}

#endif
