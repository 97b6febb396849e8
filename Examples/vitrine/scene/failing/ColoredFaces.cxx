#include "scene/failing/ColoredFaces.h"

#include "vtkCellData.h"

namespace program
{

ColoredFaces::ColoredFaces()
{
  this->Colors->SetNumberOfComponents(3);
}

void ColoredFaces::Add(const std::vector<std::array<double, 3>>& corners, const Color& color)
{
  this->Polygons->InsertNextCell(static_cast<int>(corners.size()));
  for (const std::array<double, 3>& corner : corners)
  {
    this->Polygons->InsertCellPoint(this->Points->InsertNextPoint(corner.data()));
  }
  for (double component : color)
  {
    this->Colors->InsertNextValue(static_cast<unsigned char>(component * 255.0 + 0.5));
  }
}

Part ColoredFaces::ToPart(const std::string& name, double alpha)
{
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->SetPoints(this->Points);
  faces->SetPolys(this->Polygons);
  faces->GetCellData()->SetScalars(this->Colors);
  return MakeTranslucentPart(name, faces, MakeUnlit({ 1.0, 1.0, 1.0 }, alpha));
}

}
