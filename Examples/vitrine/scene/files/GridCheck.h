/**
 * Whether VTK's filters can take data that are no surfaces.
 */
#ifndef VITRINE_GRID_CHECK_H
#define VITRINE_GRID_CHECK_H

#include "vtkDataSet.h"

#include <string>

namespace program
{

/**
 * What is wrong with a grid: dimensions that its points do not fill, cells whose corners are not among the points or
 * are more or fewer than their kind has, data that do not match points or cells. Empty if nothing is.
 */
std::string FindGridProblem(vtkDataSet* grid);

/** True if a cell of the grid has a volume. */
bool HasVolumeCells(vtkDataSet* grid);

}
#endif
