// Leaves of one mesh that hide each other: no pixel is lost, and none differs from what VTK's own mapper draws.
#include "CullerScene.h"
#include "DividedActor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace
{

class CullerLeaves : public CullerTest
{
protected:
  CullerLeaves()
  {
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->GetProperty()->SetColor(0.3, 0.7, 0.9);
    Scene.Renderer->AddActor(this->Actor);
  }

  /** Shows a mesh of these parts; its cells have colours of their own. */
  void Show(const PartsOfQuads& parts)
  {
    std::vector<Quad> quads;
    for (const std::vector<Quad>& part : parts)
    {
      quads.insert(quads.end(), part.begin(), part.end());
    }
    this->Mesh = MeshOf(quads);
    this->Paint(this->Mesh->GetCellData(), this->Mesh->GetNumberOfCells(), 3);
    this->Mapper->SetInputData(this->Mesh);
  }

  void Paint(vtkDataSetAttributes* attributes, vtkIdType count, int components)
  {
    TestRandom random(310);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(components);
    for (vtkIdType i = 0; i < count * components; ++i)
    {
      colors->InsertNextValue(static_cast<unsigned char>(random.Next() % 256));
    }
    attributes->SetScalars(colors);
  }

  /** Expects the same with the culler, without it, and by VTK's own mapper. Returns how many leaves were left out. */
  int ExpectAsVTK()
  {
    const int leftOut = Scene.ExpectSame();
    const Picture whole = Scene.Render(); // without culling
    this->Plain->SetInputDataObject(this->Mapper->GetInput());
    this->Actor->SetMapper(this->Plain);
    EXPECT_TRUE(Matches(Scene.Render(), whole));
    this->Actor->SetMapper(this->Mapper);
    return leftOut;
  }

  vtkNew<vtkCulledPolyDataMapper> Mapper;
  vtkNew<vtkPolyDataMapper> Plain; ///< VTK's
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkPolyData> Mesh;
};

TEST_P(CullerLeaves, HideEachOther)
{
  this->Show(WallAndPatches());
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  TestRandom random(311);
  for (int pose = 0; pose < 3; ++pose)
  {
    Scene.LookFromAnywhere(random);
    EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  }
}

// What shows lies before, between and behind what does not, in the order of the mesh.
TEST_P(CullerLeaves, KeepColorsAndNormalsOfCells)
{
  PartsOfQuads parts = Patches(0.3), hidden = Patches(-0.4);
  for (std::size_t i = 0; i < hidden.size(); ++i)
  {
    parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(2 * i), hidden[i]);
  }
  parts.insert(parts.begin() + 7, Grid(-2.5, -2.5, 2.5, 2.5, 0.0, PatchCells));
  this->Show(parts);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  this->Actor->GetProperty()->LightingOn();
  TestRandom random(312);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < this->Mesh->GetNumberOfCells(); ++i)
  {
    normals->InsertNextTuple3(random.Unit() - 0.5, random.Unit() - 0.5, 0.3);
  }
  this->Mesh->GetCellData()->SetNormals(normals);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  this->Mesh->GetCellData()->SetScalars(nullptr);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  this->Paint(this->Mesh->GetPointData(), this->Mesh->GetNumberOfPoints(), 3);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  this->Mesh->GetCellData()->SetNormals(nullptr);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
}

// Of faces in one plane the one that is drawn first shows.
TEST_P(CullerLeaves, KeepTheOrderOfFacesAtOnePlace)
{
  PartsOfQuads parts = WallAndPatches();
  const PartsOfQuads inFront = Patches(0.2);
  for (int i = 0; i < 3; ++i)
  {
    parts.insert(parts.begin() + 4 * i, inFront[0]);
    parts.insert(parts.begin() + 3 * i, inFront[static_cast<std::size_t>(i)]);
    parts.push_back(inFront[static_cast<std::size_t>(i)]);
  }
  this->Show(parts);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
}

TEST_P(CullerLeaves, MayBeTranslucent)
{
  this->Show(WallAndPatches());
  Scene.AddWall(-0.2);
  this->Actor->GetProperty()->SetOpacity(0.4);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
  Scene.Use(vtkSmartPointer<vtkLinkedListTransparencyPass>::New());
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
  this->Actor->GetProperty()->SetOpacity(1.0);
  this->Paint(this->Mesh->GetCellData(), this->Mesh->GetNumberOfCells(), 4);
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
}

/** Puts into a mesh what VTK draws otherwise: triangles without extent, polygons of any number of corners, points. */
void Spoil(vtkPolyData* mesh, bool hasQuadsToo)
{
  vtkNew<vtkCellArray> cells;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, count, points);
    const vtkIdType halves[2][3] = { { points[0], points[1], points[2] },
      { points[0], points[2], points[3] } };
    cells->InsertNextCell(3, halves[0]);
    cells->InsertNextCell(3, halves[1]);
    const vtkIdType here[3] = { points[0], points[0], points[1] };
    const vtkIdType corners[5] = { points[0], points[1], points[2], points[3], points[0] };
    if (i % 5 == 0)
    {
      cells->InsertNextCell(3, here);
    }
    if (hasQuadsToo && i % 7 == 0)
    {
      cells->InsertNextCell(5, corners);
      cells->InsertNextCell(2, corners);
    }
  }
  mesh->SetPolys(cells);
}

TEST_P(CullerLeaves, CountTrianglesAsVTKDoes)
{
  for (const bool hasQuadsToo : { false, true })
  {
    for (const bool is64Bit : { false, true })
    {
      PartsOfQuads parts = WallAndPatches();
      const PartsOfQuads inFront = Patches(0.3); // what stands behind the hidden ones in the buffer
      parts.insert(parts.end(), inFront.begin(), inFront.end());
      this->Show(parts);
      Spoil(this->Mesh, hasQuadsToo);
      is64Bit ? this->Mesh->GetPolys()->ConvertTo64BitStorage()
              : this->Mesh->GetPolys()->ConvertTo32BitStorage();
      this->Paint(this->Mesh->GetCellData(), this->Mesh->GetNumberOfCells(), 3);
      EXPECT_GE(this->ExpectAsVTK(), 5);
    }
  }
}

// VTK draws nothing of triangles that are points. A leaf of them is visible. In the buffer it comes after a hidden leaf
// and before a visible one.
TEST_P(CullerLeaves, MayHaveNothingToDraw)
{
  const PartsOfQuads inFront = Patches(0.3);
  PartsOfQuads parts = WallAndPatches();
  parts.emplace_back(PatchCells * PatchCells, Rectangle(0.0, 0.0, 0.0, 0.0, 0.35));
  Scene.PutSampleInMiddle();
  parts.insert(parts.end(), inFront.begin(), inFront.end());
  this->Show(parts);
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
}

// As data that are filled step by step.
TEST_P(CullerLeaves, OfPolygonsWithoutPointsAreNone)
{
  this->Show(WallAndPatches());
  vtkNew<vtkPolyData> early;
  early->SetPolys(this->Mesh->GetPolys());
  this->Mapper->SetInputData(early);
  EXPECT_EQ(this->ExpectAsVTK(), 0);
  early->SetPoints(this->Mesh->GetPoints());
  EXPECT_EQ(this->ExpectAsVTK(), PatchCount);
}

TEST_P(CullerLeaves, ChangeBetweenFrames)
{
  this->Show(WallAndPatches());
  vtkProperty* property = this->Actor->GetProperty();
  const auto move = [&](double z)
  {
    for (vtkIdType i = 0; i < 4 * PatchCells * PatchCells; ++i)
    {
      const double* point = this->Mesh->GetPoint(i);
      this->Mesh->GetPoints()->SetPoint(i, point[0], point[1], z);
    }
    this->Mesh->GetPoints()->Modified();
  };
  vtkNew<vtkCellArray> points;
  const vtkIdType one = 5;
  points->InsertNextCell(1, &one);
  const std::function<void()> changes[] = {
    [&] { move(-0.7); },
    [&] { move(0.1); },
    [&] { property->SetRepresentationToWireframe(); },
    [&] { property->SetRepresentationToSurface(); },
    [&] { property->EdgeVisibilityOn(); },
    [&] { property->EdgeVisibilityOff(); },
    [&] { property->VertexVisibilityOn(); },
    [&] { property->VertexVisibilityOff(); },
    [&] { this->Mesh->SetVerts(points); },
    [&] { this->Mesh->SetVerts(nullptr); },
    [&] { property->SetOpacity(0.4); },
    [&] { property->SetOpacity(1.0); },
    [&] { this->Show(Patches()); },
    [&] { this->Show(WallAndPatches()); },
    [&] { this->Show({ Grid(-1.0, -1.0, 1.0, 1.0, 0.0, 3) }); },
    [&] { this->Show(WallAndPatches()); },
  };
  int i = 0;
  for (const std::function<void()>& change : changes)
  {
    SCOPED_TRACE("change " + std::to_string(i));
    change();
    EXPECT_EQ(this->ExpectAsVTK(), i++ % 2 == 0 ? 0 : PatchCount);
  }
}

// Data that a pipeline makes are looked at in each frame, and cut into leaves where they have changed.
TEST_P(CullerLeaves, MayBeMadeByAPipeline)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.9);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(50);
  this->Mapper->SetInputConnection(sphere->GetOutputPort());
  Scene.Clear();
  Scene.AddMesh(MeshOf({ Rectangle(0.0, -2.0, 2.0, 2.0, 0.95) }));
  Scene.Renderer->AddActor(this->Actor);
  EXPECT_GT(this->ExpectAsVTK(), 0);
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(130);
  EXPECT_GT(this->ExpectAsVTK(), 0);
  sphere->SetThetaResolution(8);
  sphere->SetPhiResolution(8);
  EXPECT_EQ(this->ExpectAsVTK(), 0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerLeaves, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
