// Tests what a device draws if that differs from the state of VTK's objects. It gets points only when they themselves
// were modified, images of textures while it draws, and uniforms from observers.
#include "CullerScene.h"
#include "DividedActor.h"
#include "vtkCommand.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageData.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{

const double WallSize = 2.5;
const int ManyCells = 70; // of a side of a wall that is large enough to be divided

class CullerUntold : public CullerTest
{
};

TEST_P(CullerUntold, PointsThatAreMovedInPlace)
{
  Scene.AddHidden();
  const auto mesh = MeshOf({ Rectangle(-WallSize, -WallSize, WallSize, WallSize, 0.0) });
  Scene.AddMesh(mesh);
  const int all = Scene.ExpectSame();
  MovePointsInPlace(mesh, { WallSize, 0.0, 0.0 });
  mesh->Modified();
  EXPECT_EQ(Scene.ExpectSame(), all) << "a device has them where they were";
  mesh->GetPoints()->Modified();
  EXPECT_LT(Scene.ExpectSame(), all);
}

TEST_P(CullerUntold, PointsOfLeavesThatAreMovedInPlace)
{
  Scene.AddHidden();
  const auto mesh = MeshOf(Grid(-WallSize, -WallSize, WallSize, WallSize, 0.0, ManyCells));
  vtkNew<vtkCulledPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  Scene.AddMesh(mesh)->SetMapper(mapper);
  EXPECT_GT(Scene.ExpectSame(), 10);
  Scene.Culler->CullingOn();
  Scene.Render();
  const int all = Scene.ExpectSame();
  EXPECT_GT(all, 10);
  MovePointsInPlace(mesh, { WallSize, 0.0, 0.0 });
  mesh->Modified();
  EXPECT_EQ(Scene.ExpectSame(), all);
}

/** Of all cells, with so many components. */
vtkSmartPointer<vtkUnsignedCharArray> ColorsOf(vtkPolyData* mesh, int components)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(mesh->GetNumberOfCells());
  colors->Fill(120);
  return colors;
}

TEST_P(CullerUntold, ColorsThatChangeInPlace)
{
  Scene.AddHidden();
  const auto mesh = MeshOf({ Rectangle(-WallSize, -WallSize, WallSize, WallSize, 0.0) });
  mesh->GetCellData()->SetScalars(ColorsOf(mesh, 3));
  Scene.AddMesh(mesh);
  EXPECT_GT(Scene.ExpectSame(), 40);
  EXPECT_GT(Scene.ExpectSame(), 40) << "now that VTK has made a table of colours";
  mesh->GetCellData()->SetScalars(ColorsOf(mesh, 4));
  Scene.ExpectNothingHidden(373, 1);
}

TEST_P(CullerUntold, ColorsOfLeavesThatChangeInPlace)
{
  const vtkSmartPointer<vtkMapper> mapper = DividedMapperOf(Division::Leaves, WallAndPatches());
  vtkPolyData* const mesh = static_cast<vtkPolyDataMapper*>(mapper.Get())->GetInput();
  Scene.AddMesh(mesh)->SetMapper(mapper);
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
  EXPECT_EQ(Scene.ExpectSame(), PatchCount) << "now that VTK has made a table of colours";
  mesh->GetCellData()->SetScalars(ColorsOf(mesh, 4));
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

// A device is given the points of all blocks once any of them was modified.
TEST_P(CullerUntold, PointsOfBlocksThatAreMovedInPlace)
{
  Scene.AddHidden();
  const PartsOfQuads walls{ { Rectangle(-WallSize, -WallSize, 0.0, WallSize, 0.0) },
    { Rectangle(0.0, -WallSize, WallSize, WallSize, 0.0) } };
  const vtkSmartPointer<vtkMapper> mapper = DividedMapperOf(Division::Blocks, walls);
  Scene.AddMesh(vtkNew<vtkPolyData>())->SetMapper(mapper);
  EXPECT_GT(Scene.ExpectSame(), 40);
  Scene.Culler->CullingOn();
  Scene.Render();
  const int all = Scene.ExpectSame();
  EXPECT_GT(all, 40);
  auto* blocks = static_cast<vtkMultiBlockDataSet*>(mapper->GetInputDataObject(0, 0));
  auto* left = static_cast<vtkPolyData*>(blocks->GetBlock(0));
  MovePointsInPlace(left, { -0.5 * WallSize, 0.0, 0.0 });
  left->Modified();
  EXPECT_LT(Scene.ExpectSame(), all);
}

// If a device draws far points about the origin, their places are hardly known. That remains so if VTK is asked later
// to draw them about their middle.
TEST_P(CullerUntold, WaysToMovePointsThatComeLate)
{
  const double away = 3e7;
  const std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  auto mesh = MeshOf({ Rectangle(-WallSize, -WallSize, WallSize, WallSize, 0.0) });
  MovePointsInPlace(mesh, { away, 0.0, 0.0 });
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(mesh);
  wall->SetPosition(-away, 0.0, 0.0);
  auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(wall->GetMapper());
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  Scene.Culler->CullingOff();
  Scene.Render();
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
  EXPECT_EQ(Scene.ExpectSame(), 0);
  Scene.AddWall(0.5);
  EXPECT_GE(Scene.ExpectSame(), static_cast<int>(parts.size()));
}

// It draws what it has, and makes the next image as it does: the one frame that shows both is the same, too.
TEST_P(CullerUntold, ImagesThatGetAnAlpha)
{
  struct World
  {
    explicit World(bool isCulled)
      : Scene(GetParam())
    {
      this->Scene.Culler->SetCulling(isCulled);
      this->Scene.AddHidden();
      this->Image->AddInputData(PlainImage(3, 200.0));
      vtkNew<vtkTexture> texture;
      texture->SetInputConnection(this->Image->GetOutputPort());
      this->Wall->SetTexture(texture);
    }

    CullerScene Scene;
    vtkSmartPointer<vtkActor> Wall = Scene.AddMesh(TexturedWall());
    vtkNew<vtkImageAppendComponents> Image;
  } culled(true), whole(false);
  const auto expectSame = [&]
  {
    culled.Scene.ExpectSamePictures(culled.Scene.Render(), whole.Scene.Render());
    return culled.Scene.Culler->GetNumberOfCulledParts();
  };
  EXPECT_EQ(expectSame(), 0) << "what the first image is is not known";
  EXPECT_GT(expectSame(), 40);
  for (World* world : { &culled, &whole })
  {
    world->Image->AddInputData(PlainImage(1, 90.0));
  }
  EXPECT_EQ(expectSame(), 0);
  EXPECT_EQ(expectSame(), 0) << "it is translucent";
  for (World* world : { &culled, &whole })
  {
    world->Image->RemoveAllInputs();
    world->Image->AddInputData(PlainImage(3, 100.0));
    world->Wall->Modified(); // to be asked once more whether it hides anything
  }
  EXPECT_EQ(expectSame(), 0);
  EXPECT_GT(expectSame(), 40);
}

// What changes in such a frame is noticed in the next one.
TEST_P(CullerUntold, PointsThatAreMovedWhileImagesAreMade)
{
  const auto mesh = TexturedWall();
  Scene.AddHidden();
  Scene.AddMesh(mesh);
  vtkNew<vtkImageAppendComponents> image;
  image->AddInputData(PlainImage(3, 200.0));
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(image->GetOutputPort());
  Scene.AddMesh(MeshOf({ Rectangle(-0.1, -0.1, 0.1, 0.1, 0.3) }))->SetTexture(texture);
  Scene.Render();
  const int all = Scene.ExpectSame();
  EXPECT_GT(all, 40);
  MovePointsInPlace(mesh, { WallSize, 0.0, 0.0 });
  mesh->GetPoints()->Modified();
  image->Modified();
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), 0);
  EXPECT_LT(Scene.ExpectSame(), all);
}

TEST_P(CullerUntold, PointsThatAreMovedWhileOneOfTwoIsNotThere)
{
  Scene.AddHidden();
  const auto mesh = MeshOf({ Rectangle(-WallSize, -WallSize, WallSize, WallSize, 0.0) });
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(mesh);
  Scene.AddMesh(mesh)->SetPosition(0.0, 0.0, -3.0);
  const int all = Scene.ExpectSame();
  wall->VisibilityOff();
  MovePointsInPlace(mesh, { WallSize, 0.0, 0.0 });
  mesh->GetPoints()->Modified();
  EXPECT_EQ(Scene.ExpectSame(), 0) << "the wall is not there";
  wall->VisibilityOn();
  EXPECT_LT(Scene.ExpectSame(), all);
}

// VTK asks an image's scalars whether it is translucent, and draws another one of its arrays.
TEST_P(CullerUntold, ImagesOfWhichAnotherArrayIsDrawn)
{
  Scene.AddHidden();
  const vtkSmartPointer<vtkImageData> image = PlainImage(3, 200.0);
  const vtkSmartPointer<vtkDataArray> other = PlainImage(4, 90.0)->GetPointData()->GetScalars();
  other->SetName("other");
  image->GetPointData()->AddArray(other);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  Scene.AddMesh(TexturedWall())->SetTexture(texture);
  EXPECT_GT(Scene.ExpectSame(), 40);
  texture->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "other");
  Scene.ExpectNothingHidden(371, 1);
}

/** Makes what a mapper draws translucent. */
class Fading : public vtkCommand
{
public:
  static Fading* New() { return new Fading; }

  void Execute(vtkObject*, unsigned long, void* program) override
  {
    static_cast<vtkShaderProgram*>(program)->SetUniformf("opacityUniform", 0.4f);
  }
};

TEST_P(CullerUntold, UniformsThatAnObserverSets)
{
  Scene.AddHidden();
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  EXPECT_GT(Scene.ExpectSame(), 40);
  vtkNew<Fading> fading;
  const unsigned long tag = wall->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, fading);
  Scene.ExpectNothingHidden(372, 1);
  wall->GetMapper()->RemoveObserver(tag);
  wall->Modified(); // an actor is not told of that
  EXPECT_GT(Scene.ExpectSame(), 40);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerUntold, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
