// Parts below actors, blocks and leaves alike: what mappers are told is true of one actor in one view of one frame.
#include "CullerScene.h"
#include "DividedActor.h"
#include "Select.h"
#include "TestPasses.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkLight.h"
#include "vtkPoints.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace
{

using Parameters = std::tuple<CullerSetting, Division>;

class CullerDivided : public testing::TestWithParam<Parameters>
{
public:
  void Abort() { Scene.Window->SetAbortRender(1); }

protected:
  vtkSmartPointer<vtkActor> Add(const PartsOfQuads& parts)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(DividedMapperOf(std::get<Division>(GetParam()), parts));
    actor->GetProperty()->LightingOff();
    Scene.Renderer->AddActor(actor);
    return actor;
  }

  /** Every prop and cell that a selector finds. */
  Picked SelectAll(int association)
  {
    return Select(
      Scene.Renderer, association, 1, 1, Scene.Setting.Width - 2, Scene.Setting.Height - 2);
  }

  CullerScene Scene{ std::get<CullerSetting>(GetParam()) };
};

std::string NameOf(const testing::TestParamInfo<Parameters>& info)
{
  return std::get<CullerSetting>(info.param).Name +
    (std::get<Division>(info.param) == Division::Blocks ? "Blocks" : "Leaves");
}

TEST_P(CullerDivided, ActorsThatMove)
{
  const vtkSmartPointer<vtkActor> actor = this->Add(WallAndPatches());
  TestRandom random(320);
  int most = 0;
  for (int frame = 0; frame < 6; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame) + " of seed 320");
    actor->SetPosition(random.Unit() - 0.5, random.Unit() - 0.5, random.Unit() - 0.5);
    actor->RotateX(70.0 * random.Unit() - 35.0);
    actor->SetScale(frame % 2 == 0 ? 1.0 : -0.8, 0.9, 1.1);
    most = std::max(most, Scene.ExpectSame());
    actor->RotateY(180.0); // the patches stand in front
    EXPECT_LT(Scene.ExpectSame(), PatchCount);
    actor->RotateY(180.0);
  }
  EXPECT_EQ(most, PatchCount);
}

TEST_P(CullerDivided, ActorsWithoutAPartThatShows)
{
  Scene.AddWall();
  this->Add(Patches());
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 1);
}

// An assembly draws the same actor once more, at a place that nobody told of.
TEST_P(CullerDivided, ActorsThatAssembliesDrawElsewhere)
{
  const vtkSmartPointer<vtkActor> actor = this->Add(WallAndPatches());
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(actor);
  assembly->RotateY(180.0);
  assembly->SetScale(0.5);
  assembly->SetPosition(0.0, 0.0, 0.5);
  Scene.Renderer->AddActor(assembly);
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
}

// Parts that the eye does not see may be seen by the light. The user may declare passes with shadows as known. The
// shadows must be the same then.
TEST_P(CullerDivided, PartsThatCastShadows)
{
  PartsOfQuads parts = Patches();
  parts.insert(parts.begin(), Grid(-0.35, -2.0, 0.85, 2.0, 0.0, PatchCells));
  parts.push_back(Grid(-3.0, -3.0, 3.0, 3.0, -0.9, PatchCells));
  const vtkSmartPointer<vtkActor> actor = this->Add(parts);
  actor->GetProperty()->LightingOn();
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetConeAngle(40.0);
  light->SetPosition(4.0, 0.0, 0.5); // it looks behind the wall
  light->SetFocalPoint(-0.2, 0.0, -0.5);
  Scene.Renderer->AddLight(light);
  vtkNew<vtkShadowMapPass> shadows;
  Scene.Renderer->SetPass(ByCamera(InSequence({ shadows->GetShadowMapBakerPass(), shadows })));
  Scene.Culler->AddKnownPass("vtkShadowMapBakerPass");
  Scene.Culler->AddKnownPass("vtkShadowMapPass");
  const Picture culled = Scene.Render();
  EXPECT_GT(Scene.Culler->GetNumberOfCulledParts(), 0);
  Scene.Culler->CullingOff();
  actor->Modified(); // else VTK keeps the shadows that it has
  Scene.ExpectSamePictures(culled, Scene.Render());
}

TEST_P(CullerDivided, ActorsThatRenderersShare)
{
  const vtkSmartPointer<vtkActor> actor = this->Add(WallAndPatches());
  vtkNew<vtkRenderer> behind;
  behind->AddActor(actor);
  behind->AddCuller(Scene.Culler);
  behind->GetActiveCamera()->DeepCopy(Scene.Renderer->GetActiveCamera());
  behind->GetActiveCamera()->Azimuth(180.0);
  Scene.Renderer->SetViewport(0.0, 0.0, 0.47, 1.0);
  behind->SetViewport(0.47, 0.0, 1.0, 1.0);
  Scene.Window->AddRenderer(behind);
  EXPECT_EQ(Scene.ExpectSame(), 0); // of the last one, which sees them all
  behind->SetActiveCamera(Scene.Renderer->GetActiveCamera());
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
}

TEST_P(CullerDivided, EyesOfStereo)
{
  this->Add(WallAndPatches());
  Scene.AddMesh(MeshOf({ Rectangle(-0.5, -0.5, 0.5, 0.5, 0.4) }));
  Scene.Renderer->GetActiveCamera()->SetEyeAngle(12.0);
  for (const int type : { VTK_STEREO_RED_BLUE, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    SCOPED_TRACE(type);
    Scene.Window->SetStereoType(type);
    Scene.Window->StereoRenderOn();
    Scene.Render(); // VTK draws the first frame of one type otherwise than those that follow
    EXPECT_GT(Scene.ExpectSame(), 0);
    Scene.Window->StereoRenderOff();
    Scene.Render();
  }
}

// The next frame has no culler, and no wall: all shows.
TEST_P(CullerDivided, WhatIsToldIsTakenBack)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall(0.2);
  PartsOfQuads parts = Patches();
  parts.push_back(Grid(-0.9, -0.9, -0.6, -0.6, 0.3, PatchCells));
  const vtkSmartPointer<vtkActor> actor = this->Add(parts);
  wall->VisibilityOff();
  Scene.Renderer->RemoveCuller(Scene.Culler);
  const Picture whole = Scene.Render();
  for (int way = 0; way < 3; ++way)
  {
    SCOPED_TRACE("way " + std::to_string(way));
    auto culler = vtkSmartPointer<vtkHierarchicalSBufferCuller>::New();
    Scene.Renderer->AddCuller(culler);
    wall->VisibilityOn();
    if (way == 1)
    {
      const unsigned long started =
        Scene.Renderer->AddObserver(vtkCommand::StartEvent, this, &CullerDivided::Abort);
      Scene.Window->Render();
      Scene.Renderer->RemoveObserver(started);
      Scene.Window->SetAbortRender(0);
    }
    else
    {
      Scene.Render();
      EXPECT_EQ(culler->GetNumberOfCulledParts(), PatchCount);
    }
    wall->VisibilityOff();
    if (way == 2)
    {
      culler->CullingOff();
      EXPECT_TRUE(Matches(Scene.Render(), whole));
    }
    Scene.Renderer->RemoveCuller(culler);
    EXPECT_TRUE(Matches(Scene.Render(), whole));
  }
}

TEST_P(CullerDivided, NothingIsModified)
{
  const vtkSmartPointer<vtkActor> actor = this->Add(WallAndPatches());
  Scene.Render();
  vtkMapper* mapper = actor->GetMapper();
  const vtkMTimeType times[] = { actor->GetMTime(), mapper->GetMTime(),
    mapper->GetInputDataObject(0, 0)->GetMTime() };
  double bounds[6], after[6];
  mapper->GetBounds(bounds);
  TestRandom random(321);
  for (int pose = 0; pose < 3; ++pose)
  {
    Scene.LookFromAnywhere(random);
    Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), PatchCount);
  }
  EXPECT_EQ(actor->GetMTime(), times[0]);
  EXPECT_EQ(mapper->GetMTime(), times[1]);
  EXPECT_EQ(mapper->GetInputDataObject(0, 0)->GetMTime(), times[2]);
  mapper->GetBounds(after);
  EXPECT_TRUE(std::equal(bounds, bounds + 6, after));
}

TEST_P(CullerDivided, PicksAreTheSame)
{
  PartsOfQuads parts = Patches(0.3);
  const PartsOfQuads behind = WallAndPatches();
  parts.insert(parts.begin() + 5, behind.begin(), behind.end());
  parts.insert(parts.begin(), Grid(5.0, 5.0, 6.0, 6.0, 0.5, PatchCells)); // out of view
  const vtkSmartPointer<vtkActor> actor = this->Add(parts);
  Scene.Culler->CullingOff();
  Scene.Render();
  const Picked cells = this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const Picked points = this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_GT(cells.at(actor).size(), 100u);
  Scene.Culler->CullingOn();
  for (int again = 0; again < 2; ++again)
  {
    const Picture before = Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), PatchCount + 1);
    EXPECT_EQ(this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_CELLS), cells);
    EXPECT_EQ(this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_POINTS), points);
    EXPECT_TRUE(Matches(Scene.Render(), before));
  }
  vtkNew<vtkCellPicker> picker;
  ASSERT_TRUE(picker->Pick(40.0, 40.0, 0.0, Scene.Renderer));
  EXPECT_EQ(picker->GetActor(), actor);
  EXPECT_GE(picker->GetCellId(), 0);
}

// Where nothing is hidden, what covers little leaves some of what may be spent to what covers much.
TEST_P(CullerDivided, AWallThatComesBehindMuchThatHidesNothing)
{
  const vtkSmartPointer<vtkActor> wall = this->Add({ Grid(-2.5, -2.5, 2.5, 2.5, 0.0, PatchCells) });
  this->Add(Patches(0.3));
  this->Add(Patches());
  wall->VisibilityOff();
  Scene.Culler->CullingOn();
  for (int frame = 0; frame < 8; ++frame)
  {
    Scene.Render();
  }
  wall->VisibilityOn();
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
}

// What stands before them hides them from the eye, but not from who picks through it.
TEST_P(CullerDivided, PicksThroughAPartThatCannotBePicked)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  wall->PickableOff();
  const vtkSmartPointer<vtkActor> actor = this->Add(Patches());
  Scene.Culler->CullingOff();
  Scene.Render();
  const Picked cells = this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_GT(cells.at(actor).size(), 100u);
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_GE(Scene.Culler->GetNumberOfCulledParts(), PatchCount);
  EXPECT_EQ(this->SelectAll(vtkDataObject::FIELD_ASSOCIATION_CELLS), cells);
}

// One point spoils what the device makes of all: nothing is left out but the whole.
TEST_P(CullerDivided, PointsThatAreNoNumbers)
{
  for (const double value : { std::nan(""), std::numeric_limits<double>::infinity(), 1e300 })
  {
    SCOPED_TRACE(value);
    PartsOfQuads parts = WallAndPatches();
    parts[3][5][1][0] = value;
    const vtkSmartPointer<vtkActor> actor = this->Add(parts);
    EXPECT_EQ(Scene.ExpectSame(), 0);
    Scene.Renderer->RemoveActor(actor);
  }
  this->Add(WallAndPatches());
  EXPECT_EQ(Scene.ExpectSame(), PatchCount);
}

// Coordinates of the whole are what the device's floats are coarse by, far as the parts may lie from each other.
TEST_P(CullerDivided, PartsThatAreFarFromEachOther)
{
  for (const double away : { 1e3, 1e5, 1e7 })
  {
    SCOPED_TRACE(away);
    PartsOfQuads parts = WallAndPatches();
    parts.push_back(Grid(away, away, away + 1.0, away + 1.0, -away, PatchCells));
    const PartsOfQuads close = Patches(-0.01);
    parts.insert(parts.end(), close.begin(), close.end());
    const vtkSmartPointer<vtkActor> actor = this->Add(parts);
    EXPECT_GT(Scene.ExpectSameAround(322, 2), 0);
    Scene.Renderer->RemoveActor(actor);
  }
}

INSTANTIATE_TEST_SUITE_P(Settings, CullerDivided,
  testing::Combine(testing::Values(CullerSettings().front(), CullerSettings().back()),
    testing::Values(Division::Blocks, Division::Leaves)),
  NameOf);

}
