/**
 * Plates and plain colours, of which generated scenes are made.
 */
#ifndef VITRINE_PLATES_H
#define VITRINE_PLATES_H

#include "scene/Random.h"
#include "scene/Scene.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <array>
#include <string>
#include <vector>

namespace program
{

using Color = std::array<double, 3>;

/** A polygon, its corners in order, in float. */
vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<std::array<double, 3>>& corners);

/** A rectangle around the origin, across the z axis. */
vtkSmartPointer<vtkPolyData> MakePlate(double halfWidth, double halfHeight);

/** Three random numbers of 8 bits. */
Color EightBitColor(Random& random);

/** A material that shows its colour whatever the lights. */
vtkSmartPointer<vtkProperty> MakeUnlit(const Color& color, double alpha);

/** A dull material that the lights show. */
vtkSmartPointer<vtkProperty> MakeLit(const Color& color, double alpha);

/** A part that is drawn as translucent, at alpha 1 too. */
Part MakeTranslucentPart(const std::string& name, vtkSmartPointer<vtkPolyData> geometry,
  vtkSmartPointer<vtkProperty> material);

vtkSmartPointer<vtkMatrix4x4> TranslateTo(double x, double y, double z);

/** The matrix of a transform as it is now. */
vtkSmartPointer<vtkMatrix4x4> ToMatrix(vtkTransform* transform);

}
#endif
