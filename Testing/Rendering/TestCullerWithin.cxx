// An eye within what hides, or close to it: no pixel is lost by culling.
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

class CullerWithin : public CullerTest
{
protected:
  vtkCamera* Camera() { return Scene.Renderer->GetActiveCamera(); }
};

// A room around the eye and all else, seen from within.
vtkSmartPointer<vtkActor> AddRoom(CullerScene& scene, double size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-size, size, -size, size, -size, size);
  return scene.AddSource(cube, { 0.3, 0.4, 0.5, 1.0 });
}

std::vector<Point3> EyesAt(const Point3& middle, const Point3& half)
{
  std::vector<Point3> eyes;
  for (const double x :
    { 0.0, 1.0 - 1e-6, 1.0, 1.0 + 1e-6 }) // inside, before and on a face, outside
  {
    eyes.push_back({ middle[0] + x * half[0], middle[1], middle[2] });
    eyes.push_back({ middle[0], middle[1], middle[2] + x * half[2] });
  }
  return eyes;
}

TEST_P(CullerWithin, EyeInsideABoxAndOnItsFaces)
{
  AddRoom(Scene, 6.0);
  const Point3 middle{ 0.1, -0.2, 1.5 }, size{ 0.6, 0.5, 0.4 };
  Scene.AddBox(middle, size);
  Scene.AddMesh(MeshOf({ Rectangle(-1.0, -1.0, 1.0, 1.0, 0.0) }));
  Scene.AddHidden();
  int most = 0;
  for (const Point3& eye : EyesAt(middle, { 0.5 * size[0], 0.5 * size[1], 0.5 * size[2] }))
  {
    SCOPED_TRACE(testing::PrintToString(eye));
    this->Camera()->SetPosition(eye.data());
    this->Camera()->SetFocalPoint(0.05, 0.0, -0.3);
    this->Camera()->SetParallelScale(0.9);
    for (const double nearest : { 1e-4, 0.05, 0.6 })
    {
      this->Camera()->SetClippingRange(nearest, 20.0);
      most = std::max(most, Scene.ExpectSame());
    }
  }
  EXPECT_GT(most, 20);
}

TEST_P(CullerWithin, WhatIsOutsideOfTheRoom)
{
  AddRoom(Scene, 3.8);
  const auto inside = Scene.AddBox({ 0.1, 0.1, -1.0 }, { 0.3, 0.3, 0.3 });
  const auto outside = Scene.AddHidden(-4.2);
  this->Camera()->SetPosition(0.3, 0.2, 1.0);
  this->Camera()->SetFocalPoint(0.1, 0.0, -3.0);
  for (const double nearest : { -1.0, 0.01, 0.1 })
  {
    if (nearest > 0.0 || this->Camera()->GetParallelProjection())
    {
      SCOPED_TRACE(nearest);
      this->Camera()->SetClippingRange(nearest, 8.0);
      const int hidden = Scene.ExpectSame();
      EXPECT_GT(hidden, static_cast<int>(2 * outside.size() / 3))
        << "some are seen from their edge";
      EXPECT_LE(hidden, static_cast<int>(outside.size()));
    }
  }
}

TEST_P(CullerWithin, EyeInsideAPartOfManyFaces)
{
  AddRoom(Scene, 6.0);
  for (int i = 0; i < 3; ++i)
  {
    Scene.AddSphere(0.2 * i - 0.2, 0.1, 1.2 - 0.5 * i, 0.6, { 0.4, 0.3 * i, 0.9, 1.0 }, 24);
  }
  Scene.AddHidden();
  int most = 0;
  for (const double z : { 1.2, 1.6, 1.8, 1.9, 0.7, 0.1 })
  {
    SCOPED_TRACE(z);
    this->Camera()->SetPosition(-0.2, 0.1, z);
    this->Camera()->SetFocalPoint(0.0, 0.0, -0.5);
    this->Camera()->SetParallelScale(0.9);
    this->Camera()->SetClippingRange(0.01, 20.0);
    most = std::max(most, Scene.ExpectSame());
  }
  EXPECT_GT(most, 0);
}

TEST_P(CullerWithin, WallsAcrossTheNearPlane)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.3, -2.0, 2.0, 2.0, -0.1) }));
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall(0.05);
  Scene.AddHidden();
  TestRandom random(18);
  int most = 0;
  for (int pose = 0; pose < 8; ++pose)
  {
    SCOPED_TRACE("pose " + std::to_string(pose) + " of seed 18");
    Scene.LookFromAnywhere(random);
    wall->SetOrientation(60.0 * random.Unit() - 30.0, 120.0 * random.Unit() - 60.0, 0.0);
    const double away = this->Camera()->GetDistance();
    this->Camera()->SetClippingRange(away - 0.2 + 0.4 * random.Unit(), 9.0);
    most = std::max(most, Scene.ExpectSame());
  }
  EXPECT_GT(most, 0);
}

// A floor and a wall that begin behind the eye.
TEST_P(CullerWithin, WhatIsBehindFloorsAndWallsThatReachBehindTheEye)
{
  Scene.AddMesh(MeshOf({ { { { -9.0, -0.9, 9.0 }, { 9.0, -0.9, 9.0 }, { 9.0, -0.9, -9.0 },
    { -9.0, -0.9, -9.0 } } } }));
  Scene.AddMesh(MeshOf(
    { { { { 1.3, -9.0, 9.0 }, { 1.3, 9.0, 9.0 }, { 1.3, 9.0, -9.0 }, { 1.3, -9.0, -9.0 } } } }));
  int hidden = 0;
  int most = 0;
  for (int i = 0; i < 12; ++i)
  {
    Scene.AddBox({ 0.1 * i, -1.1, -0.4 * i }, { 0.3, 0.1, 0.3 });
    Scene.AddBox({ 1.5, 0.1 * i, -0.4 * i }, { 0.1, 0.3, 0.3 });
    hidden += 2;
  }
  for (const double aside : { 0.0, 0.4, 0.8 })
  {
    SCOPED_TRACE(aside);
    this->Camera()->SetPosition(aside, 0.1 * aside, 2.0);
    this->Camera()->SetFocalPoint(1.0, -0.9, -3.0);
    this->Camera()->SetClippingRange(0.01, 16.0);
    most = std::max(most, Scene.ExpectSame());
  }
  EXPECT_GT(most, hidden / 2);
}

TEST_P(CullerWithin, EyeCloseToAFace)
{
  Scene.AddWall();
  Scene.AddHidden();
  int most = 0;
  for (const double away : { 1e-6, 1e-4, 1e-2, 0.1 })
  {
    for (const double aside : { 0.0, 0.7, 3.0 })
    {
      SCOPED_TRACE(std::to_string(away) + " away, " + std::to_string(aside) + " aside");
      this->Camera()->SetPosition(0.2, 0.1, away);
      this->Camera()->SetFocalPoint(0.2 + aside, 0.1, away - 1.0);
      this->Camera()->SetClippingRange(0.5 * away, 10.0);
      most = std::max(most, Scene.ExpectSame());
    }
  }
  EXPECT_GT(most, 0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerWithin, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
