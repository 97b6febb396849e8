/**
 * The models of the papers' scenes: one to look through, one that hides.
 */
#ifndef VITRINE_PAPERS_MODELS_H
#define VITRINE_PAPERS_MODELS_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace program
{

/** What a figure eight adds to a pixel where it crosses itself, seen along z. */
inline constexpr int FigureEightLayers = 4;

/**
 * A twisted tube along a figure eight that lies across the z axis and crosses itself there, 3 wide. It has 2 * rings * sides triangles and smooth normals.
 */
vtkSmartPointer<vtkPolyData> MakeFigureEight(int rings, int sides);

/** Where one of the two holes of a figure eight has its middle, along x. */
inline constexpr double FigureEightHole = 0.75;

/** A vase of 2,256 triangles along z around the origin. */
vtkSmartPointer<vtkPolyData> MakeVase();

}
#endif
