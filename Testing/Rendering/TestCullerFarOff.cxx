// Coordinates of a map that come and go: what VTK draws exactly is culled, and nothing else is lost.
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{

const Point3 Corner{ 5.3e5, 5.4e6, 1.2e7 };

class CullerFarOff : public CullerTest
{
protected:
  /** Parts and camera, from wherever they are. */
  void Move(const std::vector<vtkSmartPointer<vtkActor>>& parts, double share)
  {
    const Point3 by{ share * Corner[0], share * Corner[1], share * Corner[2] };
    for (const vtkSmartPointer<vtkActor>& part : parts)
    {
      part->AddPosition(by[0], by[1], by[2]);
    }
    vtkCamera* camera = Scene.Renderer->GetActiveCamera();
    double eye[3], focus[3];
    camera->GetPosition(eye);
    camera->GetFocalPoint(focus);
    camera->SetPosition(eye[0] + by[0], eye[1] + by[1], eye[2] + by[2]);
    camera->SetFocalPoint(focus[0] + by[0], focus[1] + by[1], focus[2] + by[2]);
    camera->SetClippingRange(1.0, 8.0);
  }

  /** A wall whose points are far off themselves. */
  vtkSmartPointer<vtkActor> AddFarWall()
  {
    const vtkSmartPointer<vtkPolyData> mesh = MeshOf({ Rectangle(-2.5, -2.5, 2.5, 2.5, 0.0) });
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double point[3];
      mesh->GetPoint(i, point);
      mesh->GetPoints()->SetPoint(
        i, point[0] + Corner[0], point[1] + Corner[1], point[2] + Corner[2]);
    }
    return Scene.AddMesh(mesh);
  }
};

TEST_P(CullerFarOff, MapThatComesAndGoes)
{
  std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  parts.push_back(Scene.AddWall());
  const int all = Scene.ExpectSame();
  EXPECT_GT(all, 40);
  for (const double share : { 1.0, -1.0, 0.5, -0.5 })
  {
    SCOPED_TRACE(share);
    this->Move(parts, share);
    EXPECT_EQ(Scene.ExpectSame(), all);
  }
}

// Some are not in the scene while all others move to where boxes count from another place, and come again as they were.
TEST_P(CullerFarOff, PartsThatMissTheMove)
{
  std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  this->Move(parts, 1.0);
  EXPECT_EQ(Scene.ExpectSame(), 0);
  const std::vector<vtkSmartPointer<vtkActor>> left(parts.begin(), parts.begin() + 20);
  parts.erase(parts.begin(), parts.begin() + 20);
  for (const vtkSmartPointer<vtkActor>& part : left)
  {
    Scene.Renderer->RemoveActor(part);
  }
  this->Move(parts, -1.0);
  EXPECT_EQ(Scene.ExpectSame(), 0);
  for (const vtkSmartPointer<vtkActor>& part : left)
  {
    Scene.Renderer->AddActor(part);
  }
  this->Move({}, 1.0); // the camera, to where those are
  EXPECT_EQ(Scene.ExpectSame(), static_cast<int>(parts.size()));
}

// VTK draws them about their middle, unless it is told not to.
TEST_P(CullerFarOff, PointsThatAreFarOff)
{
  const std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  this->Move(parts, 1.0);
  this->AddFarWall();
  EXPECT_GT(Scene.ExpectSame(), 40);
}

// Floats could draw them anywhere, so that they hide nothing for sure; others do as before.
TEST_P(CullerFarOff, PointsThatVTKIsNotToMove)
{
  std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  parts.push_back(Scene.AddWall());
  this->Move(parts, 1.0);
  EXPECT_GT(Scene.ExpectSame(), 40);
  static_cast<vtkOpenGLPolyDataMapper*>(this->AddFarWall()->GetMapper())
    ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  EXPECT_GT(Scene.ExpectSame(), 40);
  Scene.Renderer->RemoveActor(parts.back());
  Scene.Culler->CullingOn();
  for (int frame = 0; frame < 16;
       ++frame) // in one of which it is tried again whether the far one hides anything
  {
    Scene.Render();
  }
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

// It moves them by what the camera sees, so that they are always drawn.
TEST_P(CullerFarOff, PointsThatVTKMovesWithTheCamera)
{
  const std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  const vtkSmartPointer<vtkActor> wall =
    Scene.AddMesh(MeshOf({ Rectangle(-2.5, -2.5, 2.5, 2.5, 0.0) }));
  EXPECT_GT(Scene.ExpectSame(), 40);
  static_cast<vtkOpenGLPolyDataMapper*>(wall->GetMapper())
    ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::NEAR_PLANE_SHIFT_SCALE);
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

// Nor does VTK move points that come while it is told to pause.
TEST_P(CullerFarOff, PointsThatVTKPausesToMove)
{
  std::vector<vtkSmartPointer<vtkActor>> parts = Scene.AddHidden();
  parts.push_back(Scene.AddWall(-0.1));
  this->Move(parts, 1.0);
  static_cast<vtkOpenGLPolyDataMapper*>(this->AddFarWall()->GetMapper())->SetPauseShiftScale(true);
  EXPECT_GT(Scene.ExpectSame(), 40) << "behind the wall that stands where it is";
  parts.back()->VisibilityOff();
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerFarOff, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
