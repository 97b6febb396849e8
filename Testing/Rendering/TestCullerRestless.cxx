// Parts whose data change in each frame: they are drawn as they are, and not read again and again.
#include "CullerScene.h"
#include "DividedActor.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

const int Boxes = 60;       // so that their wall is worth its time
const int MostFrames = 300; // of calm, until data are read again

class CullerRestless : public CullerTest
{
protected:
  CullerRestless()
  {
    for (int i = 0; i < Boxes; ++i)
    {
      Scene.AddBox({ 0.2 * (i % 10) - 1.0, 0.2 * (i / 10) - 0.5, -1.0 }, { 0.1, 0.1, 0.1 });
    }
  }

  vtkSmartPointer<vtkPolyData> Wall = MeshOf(Grid(-2.5, -2.5, 2.5, 2.5, 0.0, PatchCells));
};

TEST_P(CullerRestless, HideNothingUntilTheyStayAsTheyAre)
{
  Scene.AddMesh(this->Wall);
  EXPECT_EQ(Scene.ExpectSame(), Boxes);
  Scene.Culler->CullingOn();
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Wall->GetPoints()->Modified();
    Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), Boxes) << "it changes now and then";
  }
  for (int frame = 0; frame < 12; ++frame)
  {
    this->Wall->GetPoints()->Modified();
    Scene.Render();
  }
  EXPECT_EQ(Scene.ExpectSame(), 0);
  Scene.Culler->CullingOn();
  int frames = 0;
  while (frames < MostFrames && Scene.Culler->GetNumberOfCulledParts() < Boxes)
  {
    Scene.Render();
    ++frames;
  }
  EXPECT_GT(frames, 20);
  EXPECT_EQ(Scene.ExpectSame(), Boxes);
  this->Wall->GetPoints()->Modified();
  EXPECT_EQ(Scene.ExpectSame(), 0) << "it begins to move again";
}

// Colours, say.
TEST_P(CullerRestless, HideAsLongAsTheyStayWhereTheyAre)
{
  Scene.AddMesh(this->Wall);
  EXPECT_EQ(Scene.ExpectSame(), Boxes);
  Scene.Culler->CullingOn();
  for (int frame = 0; frame < 20; ++frame)
  {
    this->Wall->Modified();
    Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), Boxes);
  }
}

TEST_P(CullerRestless, AreHiddenByNothing)
{
  Scene.AddWall(0.5);
  const auto patch = MeshOf(Grid(-0.2, -0.2, 0.2, 0.2, 0.3, PatchCells));
  Scene.AddMesh(patch);
  EXPECT_EQ(Scene.ExpectSame(), Boxes + 1);
  for (int frame = 0; frame < 12; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    patch->GetPoints()->SetPoint(0, -0.2 - 0.01 * frame, -0.2, 0.3 - 0.01 * frame);
    patch->GetPoints()->Modified();
    EXPECT_GE(Scene.ExpectSame(), Boxes);
  }
  EXPECT_EQ(Scene.ExpectSame(), Boxes);
}

// However many parts share them.
TEST_P(CullerRestless, SharedByManyParts)
{
  for (int i = 0; i < 300; ++i)
  {
    Scene.AddMesh(this->Wall)->SetPosition(0.0, 0.0, 0.001 * i);
  }
  for (int frame = 0; frame < 30; ++frame)
  {
    this->Wall->GetPoints()->Modified();
    Scene.Render();
  }
  EXPECT_EQ(Scene.ExpectSame(), 0);
  Scene.AddWall(0.6);
  EXPECT_GE(Scene.ExpectSame(), Boxes) << "behind a wall of other data";
}

// Other data in each frame.
TEST_P(CullerRestless, Exchanged)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(this->Wall);
  auto* mapper = static_cast<vtkPolyDataMapper*>(wall->GetMapper());
  for (int frame = 0; frame < 30; ++frame)
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(this->Wall);
    mapper->SetInputData(other);
    Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), frame < 8 ? Boxes : 0);
  }
  EXPECT_EQ(Scene.ExpectSame(), 0);
  Scene.AddMesh(this->Wall);
  EXPECT_GE(Scene.ExpectSame(), Boxes) << "of another part nothing is known";
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerRestless, testing::ValuesIn(CullerSettings()), CullerSettingName);
}
