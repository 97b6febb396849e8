// What is known of a polydata whose faces were read.
#include "CullerScene.h"
#include "DividedActor.h"
#include "culling/PartGeometry.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::PartGeometry;

bool HasBoxes(vtkPolyData* data)
{
  PartGeometry geometry(data);
  EXPECT_GT(geometry.Occluder(data, 1).PointCount(), vitrine::FewPointsOfAMesh);
  return geometry.Boxes() != nullptr;
}

// Boxes around faces tell nothing of what is drawn besides.
TEST(PartGeometry, HasBoxesOfFacesAlone)
{
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf(Grid(-1.0, -1.0, 1.0, 1.0, 0.0, 12));
  EXPECT_TRUE(HasBoxes(mesh));
  const vtkIdType across[] = { 0, 1, 2 };
  const auto cells = [&](int size)
  {
    const auto some = vtkSmartPointer<vtkCellArray>::New();
    some->InsertNextCell(size, across);
    return some;
  };
  mesh->SetVerts(cells(1));
  EXPECT_FALSE(HasBoxes(mesh));
  mesh->SetVerts(nullptr);
  mesh->SetLines(cells(2));
  EXPECT_FALSE(HasBoxes(mesh));
  mesh->SetLines(nullptr);
  mesh->SetStrips(cells(3));
  EXPECT_FALSE(HasBoxes(mesh));
  mesh->SetStrips(nullptr);
  EXPECT_TRUE(HasBoxes(mesh));
}

// Others may come to be at the address of data that are gone.
TEST(PartGeometry, IsOfDataThatAreThere)
{
  vtkSmartPointer<vtkPolyData> mesh = MeshOf(Grid(-1.0, -1.0, 1.0, 1.0, 0.0, 2));
  vtkPolyData* const address = mesh;
  const PartGeometry geometry(mesh);
  mesh->Modified();
  EXPECT_TRUE(geometry.WasOf(address));
  mesh = nullptr;
  EXPECT_FALSE(geometry.WasOf(address));
}

}
