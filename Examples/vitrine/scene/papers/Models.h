/**
 * The models of the papers' scenes: one to look through, one that hides.
 */
#ifndef VITRINE_PAPERS_MODELS_H
#define VITRINE_PAPERS_MODELS_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace program
{

/**
 * The most layers that a shell adds to a pixel, from wherever it is seen: both of its walls are convex. Only on its
 * outline may a pixel have two more, where triangles are smaller than pixels and their corners are rounded.
 */
inline constexpr int ShellLayers = 4;

/**
 * A thick-walled closed shell around the origin, 3 long along x and 1.9 wide. It has 4 * stations * sides triangles,
 * half of them on its inner wall.
 */
vtkSmartPointer<vtkPolyData> MakeShell(int stations, int sides);

/** A vase of 2,256 triangles along z around the origin, 0.84 high. */
vtkSmartPointer<vtkPolyData> MakeVase();

}
#endif
