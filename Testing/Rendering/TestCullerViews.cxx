// Where the eye is, and what the window is like: no pixel is lost by culling.
#include "CullerScene.h"
#include "gl/Capabilities.h"
#include "gl/VitrineOpenGL.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

class CullerViews : public CullerTest
{
public:
  void TakeTile()
  {
    this->MostOfTiles = std::max(this->MostOfTiles, Scene.Culler->GetNumberOfCulledParts());
  }

protected:
  vtkCamera* Camera() { return Scene.Renderer->GetActiveCamera(); }
  // A wall over half of the view and more, and what lies behind it.
  void AddHalfWallAndHidden()
  {
    Scene.AddMesh(MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) }));
    Scene.AddHidden();
  }

  // Expects the same pictures whatever the camera does, and that it hides something in each.
  void ExpectHiddenBy(const std::vector<std::function<void(vtkCamera*)>>& changes)
  {
    this->AddHalfWallAndHidden();
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      SCOPED_TRACE("change " + std::to_string(i));
      vtkNew<vtkCamera> camera;
      Scene.Renderer->SetActiveCamera(camera);
      changes[i](camera);
      Scene.ExpectHidden(170 + i, 2);
    }
  }

  Picture Screenshot(int scale, bool culls)
  {
    Scene.Culler->SetCulling(culls);
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(Scene.Window);
    filter->SetScale(scale);
    filter->SetFixBoundary(scale > 2);
    filter->ReadFrontBufferOff();
    filter->Update();
    return ToPicture(filter->GetOutput());
  }

  // Scales all parts and moves them: every other one by its matrix, the rest by their points.
  void MoveParts(const Point3& corner, double scale)
  {
    vtkActorCollection* actors = Scene.Renderer->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); ++i)
    {
      auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
      vtkNew<vtkTransform> transform;
      transform->Translate(corner.data());
      transform->Scale(scale, scale, scale);
      if (i % 2 == 0)
      {
        actor->SetUserTransform(transform);
        continue;
      }
      transform->Concatenate(actor->GetMatrix());
      actor->GetMapper()->Update();
      vtkNew<vtkPolyData> moved;
      moved->DeepCopy(actor->GetMapper()->GetInput());
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      transform->TransformPoints(moved->GetPoints(), points);
      moved->SetPoints(points);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(moved);
      actor->SetMapper(mapper);
      actor->SetPosition(0.0, 0.0, 0.0);
      actor->SetScale(1.0);
    }
  }

  int MostOfTiles = 0;
};

TEST_P(CullerViews, OddCameras)
{
  const auto ahead = [this](vtkCamera*) { Scene.LookAhead(); };
  const auto with = [&](const std::function<void(vtkCamera*)>& change)
  {
    return [=](vtkCamera* camera)
    {
      ahead(camera);
      change(camera);
    };
  };
  vtkNew<vtkTransform> shear;
  shear->Scale(1.1, 0.9, 1.0);
  shear->RotateZ(5.0);
  vtkNew<vtkTransform> lens;
  lens->Translate(0.1, -0.05, 0.0);
  lens->Scale(0.9, 1.05, 1.0);
  const double width = Scene.Setting.Width, height = Scene.Setting.Height;
  this->ExpectHiddenBy({
    with([](vtkCamera* camera) { camera->SetWindowCenter(0.25, -0.2); }),
    with([](vtkCamera* camera) { camera->SetViewShear(0.15, -0.1, 1.0); }),
    with([&](vtkCamera* camera) { camera->SetUserViewTransform(shear); }),
    with([&](vtkCamera* camera) { camera->SetUserTransform(lens); }),
    with([&](vtkCamera* camera) { camera->SetModelTransformMatrix(shear->GetMatrix()); }),
    with([](vtkCamera* camera) { camera->UseHorizontalViewAngleOn(); }),
    with(
      [&](vtkCamera* camera)
      {
        camera->UseOffAxisProjectionOn(); // through a screen that stands aslant before the eye
        camera->SetScreenBottomLeft(-1.3 * width / height, -1.2, -3.5);
        camera->SetScreenBottomRight(1.2 * width / height, -1.2, -3.8);
        camera->SetScreenTopRight(1.2 * width / height, 1.3, -3.8);
      }),
    with(
      [&](vtkCamera* camera)
      {
        vtkNew<vtkMatrix4x4> explicitly;
        explicitly->DeepCopy(camera->GetProjectionTransformMatrix(width / height, -1, 1));
        explicitly->SetElement(0, 1, 0.07);
        explicitly->SetElement(3, 0, Scene.Setting.IsParallel ? 0.02 : -0.05);
        camera->SetExplicitProjectionTransformMatrix(explicitly);
        camera->UseExplicitProjectionTransformMatrixOn();
      }),
  });
}

// VTK keeps a camera's matrices until the camera tells that it has changed.
TEST_P(CullerViews, MatricesThatChangeUntold)
{
  this->AddHalfWallAndHidden();
  vtkNew<vtkMatrix4x4> moved;
  Scene.LookAhead();
  this->Camera()->SetModelTransformMatrix(moved);
  EXPECT_GT(Scene.ExpectSame(), 0);
  moved->SetElement(0, 3, -0.9);
  EXPECT_GT(Scene.ExpectSame(), 0);
  this->Camera()->Modified();
  EXPECT_GT(Scene.ExpectSame(), 0);
}

TEST_P(CullerViews, ViewportsAndLayersOfOneCuller)
{
  this->AddHalfWallAndHidden();
  const vtkSmartPointer<vtkActor> shared = Scene.AddBox({ 0.2, 0.1, 0.4 }, { 0.5, 0.6, 0.1 });
  Scene.Renderer->SetViewport(0.0, 0.0, 0.53, 1.0);
  CullerScene other(GetParam());
  other.AddMesh(MeshOf(StripsBetweenSlits(0.02, 19)));
  other.AddHidden();
  vtkNew<vtkRenderer> beside, above;
  for (vtkRenderer* renderer : { beside.Get(), above.Get() })
  {
    for (int i = 0; i < other.Renderer->GetActors()->GetNumberOfItems(); ++i)
    {
      renderer->AddActor(vtkActor::SafeDownCast(other.Renderer->GetActors()->GetItemAsObject(i)));
    }
    renderer->AddActor(shared);
    renderer->AddCuller(Scene.Culler);
    Scene.Window->AddRenderer(renderer);
  }
  beside->SetViewport(0.53, 0.2, 1.0, 0.9);
  beside->SetActiveCamera(this->Camera());
  above->SetActiveCamera(this->Camera());
  above->SetViewport(0.3, 0.3, 0.7, 0.61);
  above->SetLayer(1);
  Scene.Window->SetNumberOfLayers(2);
  Scene.ExpectHidden(190, 5);
}

TEST_P(CullerViews, TilesOfAScreenshot)
{
  this->AddHalfWallAndHidden();
  Scene.Renderer->AddObserver(vtkCommand::EndEvent, this, &CullerViews::TakeTile);
  TestRandom random(191);
  for (const int scale : { 2, 3 })
  {
    SCOPED_TRACE(scale);
    Scene.LookFromAnywhere(random);
    this->MostOfTiles = 0;
    const Picture culled = this->Screenshot(scale, true);
    EXPECT_GT(this->MostOfTiles, 0);
    ASSERT_EQ(culled.Width, scale * Scene.Setting.Width);
    Scene.ExpectSamePictures(culled, this->Screenshot(scale, false));
  }
}

TEST_P(CullerViews, CoordinatesOfAMap)
{
  for (const double feature : { 2e3, 1.0, 1e-3 })
  {
    SCOPED_TRACE(feature);
    Scene.Clear();
    this->AddHalfWallAndHidden();
    const Point3 corner{ 5.3e5, 5.4e6, 1.2e7 };
    this->MoveParts(corner, feature);
    int most = 0;
    TestRandom random(192);
    for (int pose = 0; pose < 4; ++pose)
    {
      Scene.LookFromAnywhere(random);
      double eye[3], focus[3];
      this->Camera()->GetPosition(eye);
      this->Camera()->GetFocalPoint(focus);
      for (int axis = 0; axis < 3; ++axis)
      {
        eye[axis] = corner[axis] + feature * eye[axis];
        focus[axis] = corner[axis] + feature * focus[axis];
      }
      this->Camera()->SetPosition(eye);
      this->Camera()->SetFocalPoint(focus);
      this->Camera()->SetParallelScale(1.3 * feature);
      this->Camera()->SetClippingRange(feature, 9.0 * feature);
      most = std::max(most, Scene.ExpectSame());
    }
    EXPECT_GT(most, 0);
  }
}

TEST_P(CullerViews, FarAndNear)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) }));
  for (const double behind : { 1e-7, 1e-5, 1e-3, 0.1 }) // the nearest by less than a step of depth
  {
    Scene.AddHidden(-0.02 - behind);
  }
  Scene.AddBox({ 0.8, 0.0, -0.7 },
    { 0.9, 0.9, 0.9 }); // floats are so coarse here that sides of small ones may be edge-on
  Scene.AddBox({ 0.0, 0.0, -5e3 }, { 3e3, 3e3, 1.0 });
  TestRandom random(193);
  int most = 0;
  for (int pose = 0; pose < 4; ++pose)
  {
    Scene.LookFromAnywhere(random);
    for (const double far : { 1e4, 1e6 })
    {
      this->Camera()->SetClippingRange(1e-6 * far, far);
      most = std::max(most, Scene.ExpectSame());
    }
  }
  // In perspective with several pixels per line, the wall hides nothing at such ranges, since faces count that a device
  // may cut.
  const bool hasThickLines = GetParam().BufferLines < GetParam().Height;
  EXPECT_GE(most, hasThickLines && !GetParam().IsParallel ? 0 : 1);
  Scene.LookAhead();
  EXPECT_GT(Scene.ExpectSame(), 40) << "at a range that is usual";
}

// Each eye is culled by itself. There is no headset here: two eyes of a window are the nearest to it.
TEST_P(CullerViews, Stereo)
{
  this->AddHalfWallAndHidden();
  this->Camera()->SetEyeAngle(12.0);
  for (const int type : { VTK_STEREO_RED_BLUE, VTK_STEREO_INTERLACED, VTK_STEREO_LEFT,
         VTK_STEREO_RIGHT, VTK_STEREO_DRESDEN, VTK_STEREO_ANAGLYPH, VTK_STEREO_CHECKERBOARD,
         VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    SCOPED_TRACE(type);
    Scene.Window->SetStereoType(type);
    Scene.Window->StereoRenderOn();
    EXPECT_GT(Scene.ExpectSameAround(194, 1), 0);
    Scene.Window->StereoRenderOff();
    EXPECT_GT(Scene.ExpectSameAround(195, 1), 0);
  }
  Scene.Window->StereoRenderOn();
  this->Camera()->UseOffAxisProjectionOn();
  this->Camera()->SetEyeSeparation(0.3);
  this->Camera()->SetScreenBottomLeft(-1.4, -1.2, -3.6);
  this->Camera()->SetScreenBottomRight(1.4, -1.2, -3.6);
  this->Camera()->SetScreenTopRight(1.4, 1.2, -3.6);
  Scene.ExpectHidden(196, 2);
}

// Windows of 8k take a machine longer than a test should: 4096 pixels by 16 are as wide as any here.
TEST_P(CullerViews, WindowsOfAnySize)
{
  this->AddHalfWallAndHidden();
  TestRandom random(197);
  for (const std::array<int, 2>& size : { std::array<int, 2>{ 64, 48 }, { 1, 1 }, { 33, 200 },
         { 1, 57 }, { 4096, 16 }, { 301, 2 }, { 64, 48 } })
  {
    SCOPED_TRACE(testing::PrintToString(size));
    Scene.Window->SetSize(size[0], size[1]);
    Scene.LookFromAnywhere(random);
    const int culled = Scene.ExpectSame();
    EXPECT_TRUE(culled > 0 || size[0] * size[1] < 700) << culled;
  }
}

// The seams of a wall of two halves lie where no sample is, most of them.
TEST(CullerSamples, BetweenThemNothingShows)
{
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    CullerScene scene({ "", samples, true, 270, 96, 54 });
    scene.AddHidden();
    const vtkSmartPointer<vtkActor> left = scene.AddMesh(MeshOf({ Rectangle(-3, -3, 0, 3, 0) }));
    const vtkSmartPointer<vtkActor> right = scene.AddMesh(MeshOf({ Rectangle(0, -3, 3, 3, 0) }));
    int closed = 0;
    for (int seam = 0; seam < 20; ++seam)
    {
      const double x = 0.0037 * seam;
      left->SetPosition(x, 0.0, 0.0);
      right->SetPosition(x, 0.0, 0.0);
      closed += scene.ExpectSame() == 63;
    }
    EXPECT_GE(closed, 10);
  }
}

TEST(CullerSamples, LieInCellsOfPixels)
{
  for (const int samples : { 0, 2, 4, 8 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    CullerScene scene({ "", samples, true, 270, 96, 54 });
    scene.AddWall();
    scene.Render();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
    window->MakeCurrent();
    window->GetRenderFramebuffer()->Bind();
    GLint has = 0;
    glGetIntegerv(GL_SAMPLES, &has);
    const int cells = vitrine::SampleCells();
    EXPECT_EQ(cells == 0, has <= 1) << "each device that is known has up to 8 there";
    EXPECT_EQ(scene.Culler->GetNumberOfBufferLines(), 54 * std::min(std::max(cells, 1), 4));
    for (GLint sample = 0; sample < has && cells > 0; ++sample)
    {
      GLfloat place[2];
      glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(sample), place);
      for (const float across : place)
      {
        EXPECT_EQ(std::fmod(across * static_cast<float>(cells), 1.0f), 0.5f);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerViews, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
