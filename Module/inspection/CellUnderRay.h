/** Finds the cell of a part that a pixel shows. */
#ifndef VITRINE_INSPECTION_CELL_UNDER_RAY_H
#define VITRINE_INSPECTION_CELL_UNDER_RAY_H

#include "scene/PartNumbers.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

namespace vitrine
{

class PixelRays;

/**
 * Returns the id of the cell of a part whose intersection with a pixel's ray is nearest in depth to `inWindow`. The ray
 * goes through the place. Returns -1 if the ray meets no cell.
 */
vtkIdType CellUnderRay(const ShownPart& part, const PixelRays& rays, const glm::dvec3& inWindow);

}

#endif
