/**
 * Whether geometry can be drawn without harm.
 */
#ifndef VITRINE_GEOMETRY_CHECK_H
#define VITRINE_GEOMETRY_CHECK_H

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <string>

namespace program
{

/**
 * What is wrong with the geometry: coordinates that are not finite, cells whose corners are not
 * among the points, data that do not match points or cells. Empty if nothing is.
 */
std::string FindGeometryProblem(vtkPolyData* geometry);

/** True if offsets rise within the corners and all corners are among the points. */
bool HasValidCorners(vtkCellArray* cells, vtkIdType pointCount);

/** True if all arrays have so many tuples. */
bool HasMatchingArrays(vtkDataSetAttributes* data, vtkIdType count);

/** True if no coordinate of its points is infinite or not a number. */
bool HasFinitePoints(vtkPolyData* geometry);

/** True if VTK draws something of it: triangles, lines or points. */
bool HasDrawableCells(vtkPolyData* geometry);

}
#endif
