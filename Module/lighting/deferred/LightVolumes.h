/**
 * Light volumes of classic deferred shading. The volume of a light is a rectangle of the picture; it reaches nothing
 * outside.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_LIGHT_VOLUMES_H
#define VITRINE_LIGHTING_DEFERRED_LIGHT_VOLUMES_H

#include "Core/lighting/LightRectangles.h"

class vtkPolyData;

namespace vitrine
{

/** Makes the rectangles in NDC of the viewport. The third coordinate is the number of the rectangle, from 0 on. */
void MakeLightVolumes(
  const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles, vtkPolyData* volumes);

}

#endif
