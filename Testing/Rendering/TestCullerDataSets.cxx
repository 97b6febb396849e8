// Actors of vtkDataSetMapper, which has a mapper of its own draw the surface of any data set, hide and are hidden.
#include "CullerScene.h"
#include "vtkAppendFilter.h"
#include "vtkCubeSource.h"
#include "vtkCutter.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> GridOf(vtkPolyData* mesh)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(mesh);
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> WallFrom(double left)
{
  return MeshOf({ Rectangle(left, -2.5, 2.5, 2.5, 0.0) });
}

/** A colour for each point. */
vtkSmartPointer<vtkUnsignedCharArray> ColorsOf(
  vtkDataSet* data, const char* name, unsigned char alpha)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName(name);
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const unsigned char color[] = { 60, 120, 200, alpha };
    colors->InsertNextTypedTuple(color);
  }
  return colors;
}

class CullerDataSets : public CullerTest
{
protected:
  // In place of the actor's own.
  static vtkSmartPointer<vtkDataSetMapper> GiveMapper(vtkActor* actor, vtkDataSet* data)
  {
    auto mapper = vtkSmartPointer<vtkDataSetMapper>::New();
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    return mapper;
  }

  static vtkPolyData* DataOf(vtkActor* actor)
  {
    actor->GetMapper()->Update();
    return static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput();
  }

  // A wall of such a mapper before boxes, drawn once.
  void AddWallAndHidden(bool isGrid)
  {
    this->Wall = Scene.AddWall();
    const vtkSmartPointer<vtkPolyData> data = WallFrom(-2.5);
    this->Mapper = GiveMapper(
      this->Wall, isGrid ? static_cast<vtkDataSet*>(GridOf(data)) : static_cast<vtkDataSet*>(data));
    this->Boxes = Scene.AddHidden();
    EXPECT_EQ(Scene.ExpectSame(), 0) << "the wall has no mapper that draws before it is drawn";
    ASSERT_EQ(Scene.ExpectSame(), this->All());
  }

  int All() const { return static_cast<int>(this->Boxes.size()); }

  vtkSmartPointer<vtkActor> Wall;
  vtkSmartPointer<vtkDataSetMapper> Mapper;
  std::vector<vtkSmartPointer<vtkActor>> Boxes;
};

TEST_P(CullerDataSets, HideAndAreHidden)
{
  for (const bool isGrid : { false, true })
  {
    SCOPED_TRACE(isGrid ? "grids" : "polydata");
    Scene.Clear();
    this->AddWallAndHidden(isGrid);
    for (const vtkSmartPointer<vtkActor>& box : this->Boxes)
    {
      vtkPolyData* const data = DataOf(box);
      GiveMapper(box, isGrid ? static_cast<vtkDataSet*>(GridOf(data)) : data);
    }
    EXPECT_EQ(Scene.ExpectSame(), 0); // they have no mapper that draws before they are drawn
    EXPECT_EQ(Scene.ExpectSame(), this->All());
    Scene.ExpectHidden(411);
  }
}

// A picture, a box of whose pixels is drawn as its surface.
TEST_P(CullerDataSets, OfImagesAreHidden)
{
  this->AddWallAndHidden(false);
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 2);
  image->SetOrigin(-0.3, -0.3, -0.6);
  image->SetSpacing(0.2, 0.2, 0.1);
  const vtkSmartPointer<vtkActor> picture = Scene.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  GiveMapper(picture, image);
  EXPECT_EQ(Scene.ExpectSame(), this->All()) << "the picture was not drawn yet";
  EXPECT_EQ(Scene.ExpectSame(), this->All() + 1);
}

// The mapper that draws learns of all this only when it draws.
TEST_P(CullerDataSets, ChangesCountAtOnce)
{
  for (const bool isGrid : { false, true })
  {
    SCOPED_TRACE(isGrid ? "grids" : "polydata");
    const auto meshOf = [isGrid](vtkPolyData* data) {
      return isGrid ? vtkSmartPointer<vtkDataSet>(GridOf(data)) : vtkSmartPointer<vtkDataSet>(data);
    };
    const vtkSmartPointer<vtkPolyData> colored = WallFrom(-2.5);
    colored->GetPointData()->AddArray(ColorsOf(colored, "opaque", 255));
    colored->GetPointData()->AddArray(ColorsOf(colored, "glass", 90));
    vtkNew<vtkPlane> plane; // keeps one half
    plane->SetNormal(1.0, 0.0, 0.0);
    vtkNew<vtkLookupTable> faint;
    faint->SetAlphaRange(0.3, 0.3);
    const std::vector<std::function<void()>> changes = {
      [&] { this->Mapper->SetInputData(meshOf(WallFrom(0.1))); },
      [&] { this->Mapper->AddClippingPlane(plane); },
      [&]
      {
        this->Mapper->SetInputData(meshOf(colored));
        this->Mapper->SetScalarModeToUsePointFieldData();
        this->Mapper->SelectColorArray("opaque");
        EXPECT_EQ(Scene.ExpectSame(), 0) << "these data were not drawn yet";
        EXPECT_EQ(Scene.ExpectSame(), this->All());
        this->Mapper->SelectColorArray("glass");
      },
      [&]
      {
        vtkDataSet* const data = this->Mapper->GetInput();
        data->GetPointData()->SetScalars(ColorsOf(data, "scalars", 90));
      },
      [&]
      {
        vtkNew<vtkFloatArray> values;
        values->SetNumberOfValues(this->Mapper->GetInput()->GetNumberOfPoints());
        values->FillValue(0.5f);
        this->Mapper->GetInput()->GetPointData()->SetScalars(values);
        EXPECT_EQ(Scene.ExpectSame(), this->All());
        EXPECT_EQ(Scene.ExpectSame(), this->All());
        this->Mapper->SetLookupTable(faint);
      },
    };
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      SCOPED_TRACE("change " + std::to_string(i));
      Scene.Clear();
      this->AddWallAndHidden(isGrid);
      changes[i]();
      EXPECT_EQ(Scene.ExpectSame(), 0) << "what was changed was not drawn yet";
      EXPECT_LT(Scene.ExpectSame(), this->All());
      EXPECT_TRUE(Scene.ShowsUnculled(this->Boxes));
    }
  }
}

// A filter of the user's makes a surface of the same grid as the mapper is given then.
TEST_P(CullerDataSets, InPlaceOfWhatAFilterMadeOfThem)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(9, 2, 2);
  grid->SetOrigin(-1.2, -0.2, -0.6);
  grid->SetSpacing(0.3, 0.4, 0.1);
  Scene.AddMesh(MeshOf({ Rectangle(-0.3, -2.5, 0.3, 2.5, 0.0) }));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, -0.55);
  plane->SetNormal(1.0, 0.0, 1.0);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(grid);
  cutter->SetCutFunction(plane);
  const vtkSmartPointer<vtkActor> actor = Scene.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(cutter->GetOutputPort());
  actor->SetMapper(mapper);
  EXPECT_EQ(Scene.ExpectSame(), 0) << "it was not drawn yet";
  EXPECT_EQ(Scene.ExpectSame(), 1);
  mapper->SetInputData(grid);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(Scene.ExpectSame(), 0) << "it reaches beyond the wall";
  }
}

// The mapper that draws is told of arrays of points and cells alone.
TEST_P(CullerDataSets, ColoredByFieldData)
{
  this->AddWallAndHidden(false);
  Scene.Renderer->RemoveActor(this->Wall);
  Scene.AddMesh(MeshOf({ Rectangle(-2.0, -2.0, 2.0, 2.0, -0.9) }));
  Scene.Renderer->AddActor(this->Wall); // drawn last, so that what is there shines through
  const vtkSmartPointer<vtkPolyData> data = WallFrom(-2.5);
  data->GetFieldData()->AddArray(ColorsOf(data, "glass", 90));
  data->GetFieldData()->AddArray(ColorsOf(data, "opaque", 255));
  data->GetPointData()->AddArray(ColorsOf(data, "glass", 90));
  this->Mapper->SetInputData(data);
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectColorArray("glass");
  EXPECT_EQ(Scene.ExpectSame(), 0) << "it is translucent";
  this->Mapper->SetScalarModeToUseFieldData();
  this->Mapper->SelectColorArray("opaque");
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(Scene.ExpectSame(), 0) << "whether field data are opaque is not known";
  }
}

// Drawing runs no filters before a grid, so neither does the culler: what they would make anew is not drawn yet.
TEST_P(CullerDataSets, OfFiltersThatDrawingDoesNotRun)
{
  this->AddWallAndHidden(false);
  vtkNew<vtkCubeSource> source;
  vtkNew<vtkAppendFilter> grid;
  grid->SetInputConnection(source->GetOutputPort());
  grid->Update();
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(grid->GetOutputPort());
  this->Boxes[0]->SetMapper(mapper);
  EXPECT_EQ(Scene.ExpectSame(), this->All() - 1) << "one was not drawn by this mapper yet";
  EXPECT_EQ(Scene.ExpectSame(), this->All());
  source->SetZLength(40.0);
  EXPECT_EQ(Scene.ExpectSame(), this->All());
  grid->Update();
  EXPECT_LT(Scene.ExpectSame(), this->All());
}

TEST_P(CullerDataSets, WhatIsHiddenComesForward)
{
  this->AddWallAndHidden(false);
  vtkNew<vtkCubeSource> source;
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  this->Boxes[0]->SetMapper(mapper);
  EXPECT_EQ(Scene.ExpectSame(), this->All() - 1) << "one was not drawn by this mapper yet";
  EXPECT_EQ(Scene.ExpectSame(), this->All());
  source->SetZLength(40.0);
  EXPECT_LT(Scene.ExpectSame(), this->All());
  source->SetZLength(1.0);
  EXPECT_EQ(Scene.ExpectSame(), this->All());
  vtkPolyData* const data = DataOf(this->Boxes[1]);
  vtkNew<vtkPolyData> nearer;
  nearer->DeepCopy(data);
  for (vtkIdType i = 0; i < nearer->GetNumberOfPoints(); ++i)
  {
    const double* const point = nearer->GetPoint(i);
    nearer->GetPoints()->SetPoint(i, point[0], point[1], point[2] + 20.0);
  }
  mapper->SetInputData(nearer);
  EXPECT_LT(Scene.ExpectSame(), this->All());
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerDataSets, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
