#include "culling/ItemBuffer.h"

#include "methods/VTKMethods.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <set>

namespace program
{

namespace
{

/** Collects parts into one mesh. */
class NumberedMesh
{
public:
  void Add(const Part& part, std::uint32_t number)
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
      const unsigned char color[3] = { static_cast<unsigned char>(number >> 16),
        static_cast<unsigned char>(number >> 8), static_cast<unsigned char>(number) };
      this->Colors->InsertNextTypedTuple(color);
    }
  }

  vtkSmartPointer<vtkPolyData> Mesh() const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polygons);
    mesh->GetCellData()->SetScalars(this->Colors);
    return mesh;
  }

  NumberedMesh() { this->Colors->SetNumberOfComponents(3); }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/** Numbers count from 1; the background is none of them. */
Scene NumberParts(const Scene& scene, std::size_t& count)
{
  NumberedMesh mesh;
  for (const Part& part : scene.Parts)
  {
    if (!IsTranslucent(part) && part.Geometry->GetNumberOfPolys() > 0)
    {
      mesh.Add(part, static_cast<std::uint32_t>(++count));
    }
  }
  Scene numbered;
  numbered.Placement = scene.Placement;
  Part all;
  all.Geometry = mesh.Mesh();
  all.Material = vtkSmartPointer<vtkProperty>::New();
  all.Material->LightingOff();
  numbered.Parts.push_back(all);
  return numbered;
}
}

ItemBuffer::ItemBuffer(const Scene& scene, PictureSize size)
  : Numbered(NumberParts(scene, this->Parts))
  , Window(this->Numbered, MakeVTKOIT(), size, 0)
{
}

std::size_t ItemBuffer::CountOwners(vtkCamera* camera)
{
  this->Window.Draw(camera);
  const std::vector<std::uint8_t> pixels = this->Window.ReadPixels();
  std::set<std::uint32_t> owners;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
  {
    const std::uint32_t number = pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2];
    if (number >= 1 && number <= this->Parts)
    {
      owners.insert(number);
    }
  }
  return owners.size();
}

}
