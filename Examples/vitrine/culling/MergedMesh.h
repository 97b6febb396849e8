/**
 * Parts as one mesh.
 */
#ifndef VITRINE_PROGRAM_MERGED_MESH_H
#define VITRINE_PROGRAM_MERGED_MESH_H

#include "scene/Scene.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

namespace program
{

/** Collects the polygons of parts, in world coordinates; cells have the colour of their part. */
class MergedMesh
{
public:
  using Color = std::array<unsigned char, 3>;

  MergedMesh();

  void Add(const Part& part, const Color& color);

  vtkSmartPointer<vtkPolyData> Mesh() const;

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkUnsignedCharArray> Colors;
};

}

#endif
