// What lies below the pointer is the same with and without culling, as often as one asks.
#include "CullerScene.h"
#include "Select.h"

#include "vtkAreaPicker.h"
#include "vtkPolyData.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"

#include <gtest/gtest.h>

namespace
{

class CullerSelection : public CullerTest
{
protected:
  std::vector<vtkProp*> PickProps()
  {
    std::vector<vtkProp*> picked;
    vtkNew<vtkPropPicker> picker;
    for (int y = 3; y < Scene.Setting.Height; y += 29)
    {
      for (int x = 3; x < Scene.Setting.Width; x += 23)
      {
        picked.push_back(picker->PickProp(x, y, Scene.Renderer) ? picker->GetViewProp() : nullptr);
      }
    }
    return picked;
  }

  // Everything that can be picked, with and without culling, again and again.
  void ExpectSamePicks(std::size_t leastProps)
  {
    const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    const int right = Scene.Setting.Width - 2, top = Scene.Setting.Height - 2;
    Scene.Culler->CullingOff();
    Scene.Render();
    const Picked ofCells = Select(Scene.Renderer, cells, 1, 1, right, top);
    const Picked ofPoints = Select(Scene.Renderer, points, 1, 1, right, top);
    const std::vector<vtkProp*> props = this->PickProps();
    EXPECT_GE(ofCells.size(), leastProps);
    Scene.Culler->CullingOn();
    for (int again = 0; again < 2; ++again)
    {
      Scene.Render();
      EXPECT_GT(Scene.Culler->GetNumberOfCulledParts(), 0);
      EXPECT_EQ(Select(Scene.Renderer, cells, 1, 1, right, top), ofCells);
      EXPECT_EQ(Select(Scene.Renderer, points, 1, 1, right, top), ofPoints);
      EXPECT_EQ(this->PickProps(), props);
    }
  }
};

TEST_P(CullerSelection, WhatShows)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) }));
  Scene.AddHidden();
  this->ExpectSamePicks(20);
}

TEST_P(CullerSelection, ThroughAPartThatCannotBePicked)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  Scene.AddHidden();
  wall->PickableOff();
  this->ExpectSamePicks(60);
}

TEST_P(CullerSelection, ByAFrustum)
{
  Scene.AddWall();
  Scene.AddHidden();
  vtkNew<vtkAreaPicker> picker;
  int picked[2];
  for (const bool culls : { false, true })
  {
    Scene.Culler->SetCulling(culls);
    Scene.Render();
    picker->AreaPick(2, 2, Scene.Setting.Width / 2, Scene.Setting.Height / 2, Scene.Renderer);
    picked[culls] = picker->GetProp3Ds()->GetNumberOfItems();
  }
  EXPECT_GT(Scene.Culler->GetNumberOfCulledParts(), 0);
  EXPECT_GT(picked[0], 10);
  EXPECT_EQ(picked[1], picked[0]);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerSelection, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
