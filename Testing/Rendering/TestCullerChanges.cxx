// What changes from frame to frame, and how many parts there are: no pixel is lost by culling.
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

class CullerChanges : public CullerTest
{
public:
  void Abort() { Scene.Window->SetAbortRender(1); }

protected:
  // A wall that covers all, boxes behind it, and the same pictures after each change of the wall.
  void ExpectSameAfter(const std::vector<std::function<void(vtkActor*)>>& changes)
  {
    const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
    Scene.AddHidden();
    EXPECT_GT(Scene.ExpectSame(), 40);
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      SCOPED_TRACE("change " + std::to_string(i));
      changes[i](wall);
      // The changes lift the wall and put it back in turn.
      EXPECT_EQ(Scene.ExpectSame() > 40, i % 2 == 1);
    }
  }
};

vtkPolyData* DataOf(vtkActor* actor)
{
  return static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput();
}

void MovePoints(vtkActor* actor, double x)
{
  MovePointsInPlace(DataOf(actor), { x, 0.0, 0.0 });
  DataOf(actor)->GetPoints()->Modified();
}

TEST_P(CullerChanges, WallThatTeleports)
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkTransform> transform;
  this->ExpectSameAfter({
    [](vtkActor* wall) { wall->SetPosition(3.0, 0.0, 0.0); },
    [](vtkActor* wall) { wall->SetPosition(0.0, 0.0, 0.0); },
    [](vtkActor* wall) { wall->SetPosition(0.0, 0.0, -0.6); }, // behind them all
    [](vtkActor* wall) { wall->SetPosition(0.0, 0.0, 0.9); },
    [](vtkActor* wall) { wall->RotateY(90.0); },
    [](vtkActor* wall) { wall->RotateY(90.0); },
    [](vtkActor* wall) { wall->SetScale(0.1); },
    [](vtkActor* wall) { wall->SetScale(1.0); },
    [&](vtkActor* wall)
    {
      matrix->SetElement(0, 3, 4.0);
      wall->SetUserMatrix(matrix);
    },
    [&](vtkActor*) { matrix->SetElement(0, 3, 0.0); }, // the matrix alone tells of it
    [&](vtkActor* wall)
    {
      wall->SetUserTransform(transform);
      transform->Translate(0.0, 4.0, 0.0);
    },
    [&](vtkActor*) { transform->Identity(); },
  });
}

TEST_P(CullerChanges, WallThatTurnsTranslucent)
{
  this->ExpectSameAfter({
    [](vtkActor* wall) { wall->VisibilityOff(); },
    [](vtkActor* wall) { wall->VisibilityOn(); },
    [](vtkActor* wall) { wall->GetProperty()->SetOpacity(0.5); },
    [](vtkActor* wall) { wall->GetProperty()->SetOpacity(1.0); },
    [](vtkActor* wall) { wall->GetProperty()->FrontfaceCullingOn(); },
    [](vtkActor* wall) { wall->GetProperty()->FrontfaceCullingOff(); },
    [](vtkActor* wall) { wall->GetProperty()->SetRepresentationToWireframe(); },
    [](vtkActor* wall) { wall->GetProperty()->SetRepresentationToSurface(); },
    [](vtkActor* wall)
    {
      wall->SetProperty(vtkSmartPointer<vtkProperty>::New());
      wall->GetProperty()->SetOpacity(0.3);
    },
    [](vtkActor* wall) { wall->SetProperty(vtkSmartPointer<vtkProperty>::New()); },
  });
}

TEST_P(CullerChanges, WallOfOtherData)
{
  const vtkSmartPointer<vtkPolyData> small = MeshOf({ Rectangle(-0.2, -0.2, 0.2, 0.2, 0.0) });
  const vtkSmartPointer<vtkPolyData> large = MeshOf({ Rectangle(-2.2, -2.2, 2.2, 2.2, 0.0) });
  const auto mapperOf = [](vtkActor* wall)
  { return static_cast<vtkPolyDataMapper*>(wall->GetMapper()); };
  this->ExpectSameAfter({
    [](vtkActor* wall) { MovePoints(wall, 3.0); },
    [](vtkActor* wall) { MovePoints(wall, -3.0); },
    [&](vtkActor* wall) { mapperOf(wall)->SetInputData(small); },
    [&](vtkActor* wall) { mapperOf(wall)->SetInputData(large); },
    [&](vtkActor* wall) { DataOf(wall)->DeepCopy(small); },
    [&](vtkActor* wall)
    {
      DataOf(wall)->SetPolys(nullptr),
        DataOf(wall)->DeepCopy(MeshOf({ Rectangle(-2, -2, 2, 2, 0) }));
    },
  });
}

TEST_P(CullerChanges, WallOfAnotherMapper)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(0.3);
  cube->SetYLength(5.0);
  vtkNew<vtkPolyDataMapper> ofCube, other;
  ofCube->SetInputConnection(cube->GetOutputPort());
  other->SetInputData(MeshOf({ Rectangle(-0.2, -0.2, 0.2, 0.2, 0.0) }));
  this->ExpectSameAfter({
    [&](vtkActor* wall) { wall->SetMapper(ofCube); },
    [&](vtkActor*) { cube->SetXLength(5.0); }, // the pipeline alone tells of it
    [&](vtkActor* wall) { wall->SetMapper(other); },
    [&](vtkActor*) { other->SetInputData(MeshOf({ Rectangle(-2.2, -2.2, 2.2, 2.2, 0.0) })); },
    [](vtkActor* wall) { DataOf(wall)->SetPolys(vtkSmartPointer<vtkCellArray>::New()); },
  });
}

// Those that hide nothing are hidden as ever. Keys tell nobody when they are changed.
// Actors that were given what a filter makes as data come before the one whose pipeline has it made anew.
TEST_P(CullerChanges, DataOfAnothersPipeline)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(0.1);
  cube->SetYLength(0.1);
  cube->SetZLength(0.1);
  cube->Update();
  vtkNew<vtkPolyDataMapper> ofData, ofPipeline;
  ofData->SetInputData(cube->GetOutput());
  ofPipeline->SetInputConnection(cube->GetOutputPort());
  Scene.AddMesh(MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, 0.0) }));
  for (vtkPolyDataMapper* mapper : { ofData.Get(), ofPipeline.Get() })
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.0, 0.0, mapper == ofData ? -0.1 : -0.3);
    actor->GetProperty()->SetColor(mapper == ofData ? 1.0 : 0.0, 0.5, 0.5);
    Scene.Renderer->AddActor(actor);
  }
  EXPECT_EQ(Scene.ExpectSame(), 2);
  for (const double width : { 1.5, 0.1 })
  {
    cube->SetXLength(width);
    EXPECT_EQ(Scene.ExpectSame() == 2, width < 1.0);
  }
}

TEST_P(CullerChanges, WallThatTheUserMarks)
{
  const auto key = vtkHierarchicalSBufferCuller::NON_OCCLUDING();
  vtkNew<vtkInformation> keys, others;
  keys->Set(key, 1);
  this->ExpectSameAfter({
    [&](vtkActor* wall) { wall->SetPropertyKeys(keys); },
    [&](vtkActor*) { keys->Set(key, 0); },
    [&](vtkActor*) { keys->Set(key, -1); },
    [&](vtkActor*) { keys->Remove(key); },
    [&](vtkActor*) { keys->Set(key, 1); },
    [&](vtkActor* wall) { wall->SetPropertyKeys(others); },
    [&](vtkActor* wall) { wall->SetPropertyKeys(keys); },
    [](vtkActor* wall) { wall->SetPropertyKeys(nullptr); },
  });
}

TEST_P(CullerChanges, HiddenPartsThatTheUserMarks)
{
  Scene.AddWall();
  for (const vtkSmartPointer<vtkActor>& box : Scene.AddHidden())
  {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkHierarchicalSBufferCuller::NON_OCCLUDING(), 1);
    box->SetPropertyKeys(keys);
  }
  EXPECT_EQ(Scene.ExpectSame(), 63);
}

// Actors that go and come again may stand at the address of others.
TEST_P(CullerChanges, PartsThatComeAndGo)
{
  TestRandom random(140);
  std::vector<vtkSmartPointer<vtkActor>> parts;
  int most = 0;
  for (int frame = 0; frame < 12; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame) + " of seed 140");
    for (int i = 0; i < 15; ++i)
    {
      parts.push_back(
        Scene.AddBox({ 1.6 * random.Unit() - 0.8, 1.6 * random.Unit() - 0.8, random.Unit() - 0.9 },
          { 0.8 * random.Unit(), 0.5 * random.Unit(), 0.1 }));
    }
    while (parts.size() > 50)
    {
      const std::size_t gone = random.Next() % parts.size();
      Scene.Renderer->RemoveActor(parts[gone]);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    for (const vtkSmartPointer<vtkActor>& part : parts)
    {
      part->SetVisibility(random.Unit() < 0.9);
      if (random.Unit() < 0.2)
      {
        part->AddPosition(0.1, -0.1, 0.1 * random.Unit());
      }
    }
    Scene.LookFromAnywhere(random);
    most = std::max(most, Scene.ExpectSame());
  }
  EXPECT_GT(most, 0);
}

// What is absent for long is forgotten, and all else is numbered anew.
TEST_P(CullerChanges, PartsThatComeAgainAfterLong)
{
  const std::vector<vtkSmartPointer<vtkActor>> hidden = Scene.AddHidden();
  Scene.AddWall();
  const int all = Scene.ExpectSame(), gone = 20;
  EXPECT_EQ(all, 63);
  for (int i = 0; i < gone; ++i)
  {
    Scene.Renderer->RemoveActor(hidden[static_cast<std::size_t>(i)]);
  }
  Scene.Culler->CullingOn();
  for (int frame = 0; frame < 420; ++frame)
  {
    Scene.Render();
    ASSERT_EQ(Scene.Culler->GetNumberOfCulledParts(), all - gone) << frame;
  }
  for (int i = 0; i < gone; ++i)
  {
    Scene.Renderer->AddActor(hidden[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(Scene.ExpectSame(), all);
}

TEST_P(CullerChanges, NoPartsAndOne)
{
  EXPECT_EQ(Scene.ExpectSame(), 0);
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  EXPECT_EQ(Scene.ExpectSame(), 0);
  wall->VisibilityOff();
  EXPECT_EQ(Scene.ExpectSame(), 0);
  wall->VisibilityOn();
  Scene.AddHidden();
  EXPECT_EQ(Scene.ExpectSame(), 63);
}

// VTK asks no cullers then.
TEST_P(CullerChanges, NoPartsAreTold)
{
  Scene.AddHidden();
  Scene.AddWall();
  EXPECT_GT(Scene.ExpectSame(), 60);
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_NE(Scene.Culler->GetBufferImage(Scene.Renderer), nullptr);
  Scene.Clear();
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 0);
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnParts(), 0);
  EXPECT_EQ(Scene.Culler->GetNumberOfTestedParts(), 0);
  EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), 0);
  EXPECT_EQ(Scene.Culler->GetNumberOfOccluders(), 0);
  EXPECT_EQ(Scene.Culler->GetCullTime(), 0.0);
  EXPECT_EQ(Scene.Culler->GetBufferImage(Scene.Renderer), nullptr);
}

TEST_P(CullerChanges, AllPartsOutOfView)
{
  Scene.AddHidden();
  Scene.AddWall();
  Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -2.0);
  Scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -4.0);
  EXPECT_EQ(Scene.ExpectSame(), 64);
  Scene.LookAhead();
  Scene.ExpectHidden(141, 1);
}

// So many that a frame without culling takes seconds: the picture is that of the scene without those behind the wall.
TEST(CullerManyParts, HundredThousand)
{
  CullerScene scene(CullerSettings()[0]);
  const vtkSmartPointer<vtkActor> wall = scene.AddWall();
  const std::vector<vtkSmartPointer<vtkActor>> inFront = scene.AddHidden(0.2);
  TestRandom random(142);
  for (int i = 0; i < 100000; ++i)
  {
    const double x = 2.4 * random.Unit() - 1.2, y = 2.4 * random.Unit() - 1.2;
    // The renderer itself would look through all of its props for each new one.
    scene.Renderer->GetViewProps()->AddItem(
      scene.MakeBox({ x, y, -1.5 * random.Unit() - 0.03 }, { 0.02, 0.02, 0.02 }));
  }
  const Picture culled = scene.Render();
  EXPECT_GE(scene.Culler->GetNumberOfDrawnProps(), 64);
  EXPECT_LT(scene.Culler->GetNumberOfDrawnProps(), 264) << "some are seen from their edge";
  scene.Clear();
  scene.Renderer->AddActor(wall);
  for (const vtkSmartPointer<vtkActor>& box : inFront)
  {
    scene.Renderer->AddActor(box);
  }
  scene.Culler->CullingOff();
  scene.ExpectSamePictures(culled, scene.Render());
}

// VTK's own culler, which leaves out some parts before, and forgets those without bounds.
TEST_P(CullerChanges, WhatAnotherCullerHasLeft)
{
  Scene.AddWall();
  Scene.AddHidden();
  Scene.AddMesh(vtkSmartPointer<vtkPolyData>::New());
  Scene.Renderer->GetCullers()->RemoveAllItems();
  Scene.Renderer->AddCuller(vtkSmartPointer<vtkFrustumCoverageCuller>::New());
  Scene.Renderer->AddCuller(Scene.Culler);
  Scene.ExpectHidden(145);
}

// Props share out a frame's time by the sum of their multipliers, whatever that is.
TEST_P(CullerChanges, TimesOfAnotherCullerStay)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  for (const auto& [multiplier, total] :
    { std::pair(0.05, 0.05), std::pair(3.0, 3.0), std::pair(0.0, 1.0) })
  {
    wall->SetRenderTimeMultiplier(multiplier);
    vtkProp* props[] = { wall };
    int count = 1, isInitialized = 1;
    Scene.Renderer->ResetCameraClippingRange();
    EXPECT_EQ(Scene.Culler->Cull(Scene.Renderer, props, count, isInitialized), total);
  }
}

// Ghost cells may or may not be drawn: what has some hides nothing, and is hidden, whether it was seen before or not.
TEST_P(CullerChanges, GhostsThatWereSeen)
{
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf({ Rectangle(-0.2, -0.2, 0.2, 0.2, -0.3) });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(0);
  mesh->GetCellData()->AddArray(ghosts);
  Scene.AddMesh(mesh);
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  for (const bool isWall : { true, false, true })
  {
    wall->SetVisibility(isWall);
    EXPECT_EQ(Scene.ExpectSame(), isWall ? 1 : 0);
  }
}

// VTK draws nothing of it in silence, and so it stays.
TEST_P(CullerChanges, MapperWithoutInput)
{
  Scene.AddWall();
  Scene.AddHidden();
  vtkNew<vtkCulledCompositePolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  Scene.Renderer->AddActor(actor);
  EXPECT_GT(Scene.ExpectSame(), 40);
}

TEST_P(CullerChanges, AbortedFrames)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) }));
  Scene.AddHidden();
  Scene.ExpectHidden(143, 1);
  TestRandom random(144);
  for (int frame = 0; frame < 3; ++frame)
  {
    Scene.LookFromAnywhere(random);
    const unsigned long started =
      Scene.Renderer->AddObserver(vtkCommand::StartEvent, this, &CullerChanges::Abort);
    Scene.Culler->CullingOn();
    Scene.Window->Render();
    Scene.Renderer->RemoveObserver(started);
    Scene.Window->SetAbortRender(0);
    EXPECT_GT(Scene.ExpectSame(), 0);
  }
}

// A dense assembly that turns once, a degree a frame: the settings share the frames.
TEST_P(CullerChanges, AssemblyThatTurns)
{
  TestRandom random(145);
  for (int i = 0; i < 140; ++i)
  {
    const auto within = [&] { return 1.5 * random.Unit() - 0.75; };
    const double x = within(), y = within();
    const vtkSmartPointer<vtkActor> part = Scene.AddBox({ x, y, within() },
      { 0.05 + 0.3 * random.Unit(), 0.05 + 0.3 * random.Unit(), 0.05 + 0.2 * random.Unit() });
    part->SetOrientation(i % 3 * 360.0 * random.Unit(), 0.0, i % 2 * 360.0 * random.Unit());
  }
  const std::vector<CullerSetting> settings = CullerSettings();
  const auto setting = std::find_if(settings.begin(), settings.end(),
    [](const CullerSetting& one) { return one.Name == GetParam().Name; });
  const int frames = 360 / static_cast<int>(settings.size());
  const auto first = static_cast<double>(setting - settings.begin()) * frames;
  Scene.Renderer->GetActiveCamera()->Elevation(20.0);
  Scene.Renderer->GetActiveCamera()->Azimuth(first);
  int most = 0;
  for (int frame = 0; frame < frames; ++frame)
  {
    SCOPED_TRACE("degree " + std::to_string(first + frame));
    most = std::max(most, Scene.ExpectSame());
    Scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  }
  EXPECT_GT(most, 0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerChanges, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
