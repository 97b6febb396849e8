/**
 * Light volumes as classic deferred shading has them, each a rectangle of the picture that the light reaches nothing outside of.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_LIGHT_VOLUMES_H
#define VITRINE_LIGHTING_DEFERRED_LIGHT_VOLUMES_H

#include "Core/lighting/LightRectangles.h"

class vtkPolyData;

namespace vitrine
{

/** The rectangles, in coordinates of the viewport; the third is the light's place among them, from 0 on. */
void MakeLightVolumes(
  const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles, vtkPolyData* volumes);

}

#endif
