/**
 * Many faces of many colours as one part.
 */
#ifndef VITRINE_COLORED_FACES_H
#define VITRINE_COLORED_FACES_H

#include "scene/Plates.h"
#include "scene/Scene.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <vector>

namespace program
{

/** Collects polygons, each with a colour of its own. */
class ColoredFaces
{
public:
  ColoredFaces();

  void Add(const std::vector<std::array<double, 3>>& corners, const Color& color);

  /** The part of all of them, unlit. Nothing may be added after. */
  Part ToPart(const std::string& name, double alpha);

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkUnsignedCharArray> Colors;
};

}
#endif
