/** The geometry of parts in world coordinates. */
#ifndef VITRINE_ASSEMBLY_PLACED_GEOMETRY_H
#define VITRINE_ASSEMBLY_PLACED_GEOMETRY_H

#include "vtkSmartPointer.h"

class vtkMatrix4x4;
class vtkPolyData;

namespace vitrine
{

/**
 * Returns a part's geometry in world coordinates. Null stands for the identity. Arrays that the place does not change
 * are shared with `geometry`. The cells of a mirrored part are reversed, so that their fronts stay fronts. Several
 * threads may call this.
 */
vtkSmartPointer<vtkPolyData> PlaceGeometry(vtkPolyData* geometry, vtkMatrix4x4* place);

}

#endif
