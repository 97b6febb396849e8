#include "culling/MergedMesh.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"

namespace program
{

MergedMesh::MergedMesh()
{
  this->Points->SetDataTypeToDouble(); // so that parts far from the origin stay where they are
  this->Colors->SetNumberOfComponents(3);
}

void MergedMesh::Add(const Part& part, const Color& color)
{
  const vtkIdType first = this->Points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < part.Geometry->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    part.Geometry->GetPoint(i, point);
    if (part.Transform)
    {
      part.Transform->MultiplyPoint(point, point);
    }
    this->Points->InsertNextPoint(point);
  }
  const auto cells = vtk::TakeSmartPointer(part.Geometry->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(count, corners);
    this->Polygons->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Polygons->InsertCellPoint(first + corners[i]);
    }
    this->Colors->InsertNextTypedTuple(color.data());
  }
}

vtkSmartPointer<vtkPolyData> MergedMesh::Mesh() const
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(this->Points);
  mesh->SetPolys(this->Polygons);
  mesh->GetCellData()->SetScalars(this->Colors);
  return mesh;
}

}
