// What works on the whole picture once the parts are drawn: no pixel is lost by culling.
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkRenderStepsPass.h"
#include "vtkToneMappingPass.h"

#include <gtest/gtest.h>

namespace
{

class CullerFilters : public CullerTest
{
protected:
  // Of a background that they change, and parts that lie behind the eye.
  void LookAway()
  {
    Scene.Renderer->GradientBackgroundOn();
    Scene.Renderer->SetBackground2(0.9, 0.2, 0.1);
    Scene.AddHidden();
    Scene.AddWall();
    Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -2.0);
    Scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -4.0);
  }
};

// VTK leaves them out where it has nothing to draw.
TEST_P(CullerFilters, WorkWhereAllIsBesideTheView)
{
  this->LookAway();
  const int all = Scene.ExpectSame();
  Scene.Renderer->UseSSAOOn();
  EXPECT_EQ(Scene.ExpectSame(), all - 1);
  Scene.Renderer->UseSSAOOff();
  Scene.Renderer->UseFXAAOn();
  EXPECT_EQ(Scene.ExpectSame(), all - 1);
  Scene.Renderer->UseFXAAOff();
  EXPECT_EQ(Scene.ExpectSame(), all);
  Scene.Renderer->BackingStoreOn();
  EXPECT_EQ(Scene.ExpectSame(), all - 1);
}

// VTK's own culler, say, which stands before unless it is taken out.
TEST_P(CullerFilters, MayBeLeftWithNothingByAnotherCuller)
{
  this->LookAway();
  Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -50.0); // far off: it asks spheres
  Scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -60.0);
  Scene.Renderer->RemoveCuller(Scene.Culler);
  vtkNew<vtkFrustumCoverageCuller> before;
  Scene.Renderer->AddCuller(before);
  Scene.Renderer->AddCuller(Scene.Culler);
  Scene.Renderer->UseFXAAOn();
  EXPECT_EQ(Scene.ExpectSame(), 0);
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 0);
  Scene.Renderer->RemoveCuller(before);
  EXPECT_GT(Scene.ExpectSame(), 0) << "without it there is something left to leave out";
}

TEST_P(CullerFilters, WorkWhereSomethingShows)
{
  Scene.AddHidden();
  Scene.AddWall();
  const int all = Scene.ExpectSame();
  Scene.Renderer->UseFXAAOn();
  EXPECT_EQ(all, 63);
  EXPECT_EQ(Scene.ExpectSame(), all);
}

// It draws by a copy of the camera, which has not the matrix in VTK 9.1.
TEST_P(CullerFilters, DrawByACopyOfTheCamera)
{
  Scene.AddHidden();
  Scene.AddMesh(MeshOf({ Rectangle(-0.2, -0.2, 0.2, 0.2, 0.5) }));
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkToneMappingPass> mapping;
  mapping->SetDelegatePass(steps);
  Scene.Renderer->SetPass(mapping);
  Scene.ExpectHidden(361, 1);
  vtkCamera* const camera = Scene.Renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> closer;
  closer->DeepCopy(
    camera->GetProjectionTransformMatrix(Scene.Renderer->GetTiledAspectRatio(), -1.0, 1.0));
  for (int i = 0; i < 2; ++i)
  {
    closer->SetElement(i, i, 6.0 * closer->GetElement(i, i));
  }
  camera->SetExplicitProjectionTransformMatrix(closer);
  camera->UseExplicitProjectionTransformMatrixOn();
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  EXPECT_EQ(Scene.ExpectSame() > 40, copy->GetUseExplicitProjectionTransformMatrix() != 0);
  mapping->ReleaseGraphicsResources(Scene.Window);
  Scene.Renderer->SetPass(nullptr);
  EXPECT_GT(Scene.ExpectSame(), 40);
}

// VTK's ambient occlusion, as its peeling, asks OpenGL in vain to copy depths of several samples.
INSTANTIATE_TEST_SUITE_P(
  Settings, CullerFilters, testing::ValuesIn(CullerSettingsOfOneSample()), CullerSettingName);

}
