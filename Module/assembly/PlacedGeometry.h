/** The geometry of parts in world coordinates. */
#ifndef VITRINE_ASSEMBLY_PLACED_GEOMETRY_H
#define VITRINE_ASSEMBLY_PLACED_GEOMETRY_H

#include "vtkSmartPointer.h"

class vtkBoundingBox;
class vtkMatrix4x4;
class vtkPolyData;

namespace vitrine
{

/**
 * Returns true if world coordinates in 32-bit float would be too coarse for a part, as of a screw in a building that
 * stands in coordinates of a map.
 */
bool IsFarForItsSize(vtkPolyData* geometry, vtkMatrix4x4* place);

/**
 * Returns a part's geometry in world coordinates, in 64-bit float if it is far for its size. Null stands for the
 * identity. Arrays that the place does not change are shared with `geometry`. The cells of a mirrored part are
 * reversed, so that their fronts stay fronts. Several threads may call this once the geometry knows its bounds.
 */
vtkSmartPointer<vtkPolyData> PlaceGeometry(vtkPolyData* geometry, vtkMatrix4x4* place);

/**
 * Returns the box of a part's points in world coordinates. Null stands for the identity. It takes the time of a pass
 * over the points only where the place turns them.
 */
vtkBoundingBox PlacedBox(vtkPolyData* geometry, vtkMatrix4x4* place);

}

#endif
