#ifndef VITRINE_LOOK_REGION_OF_PARTS_H
#define VITRINE_LOOK_REGION_OF_PARTS_H

#include "Core/geometry/PixelRegion.h"
#include "look/ChosenParts.h"

#include <vector>

class vtkProp;
class vtkRenderer;

namespace vitrine
{

/**
 * Returns a rectangle of the viewport's pixels outside of which no chosen part of the props is drawn, with a margin. It
 * is the whole viewport if a part may be drawn beside its points, or reaches behind the eye.
 */
PixelRegion RegionOfParts(vtkRenderer* renderer, const PixelRegion& viewport,
  const ChosenParts& chosen, const std::vector<vtkProp*>& props, int margin);

}

#endif
