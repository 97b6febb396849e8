// Surfaces of one material each have its number in the G-buffer: the picture stays VTK's.
#include "DeferredScene.h"
#include "vtkElevationFilter.h"
#include "vtkMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace
{

/** A ball whose colours change along it. */
vtkSmartPointer<vtkActor> MakeColouredBall()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.3);
  vtkNew<vtkElevationFilter> colours;
  colours->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(colours->GetOutputPort());
  auto ball = vtkSmartPointer<vtkActor>::New();
  ball->SetMapper(mapper);
  ball->SetPosition(0.3, 0.2, 0.8);
  return ball;
}

vtkTypeInt64 BytesOf(DeferredScene& scene)
{
  return scene.Deferred->GetBytes();
}
}

TEST(DeferredMaterials, TakeLessMemoryThanSurfaces)
{
  DeferredScene scene;
  scene.AddLights(2);
  scene.ExpectAsVTK(DeferredParts);
  const vtkTypeInt64 before = BytesOf(scene);
  scene.Renderer->AddActor(MakeColouredBall());
  scene.ExpectAsVTK(DeferredParts + 1);
  EXPECT_GT(BytesOf(scene) - before, 61 * 47 * 16 * 2);
}

TEST(DeferredMaterials, MayBeJoinedByWhatHasNone)
{
  for (const int multisamples : { 0, 4 })
  {
    SCOPED_TRACE(multisamples);
    DeferredScene scene(false, false, multisamples);
    scene.AddLights(2);
    const auto ball = MakeColouredBall();
    scene.Renderer->AddActor(ball);
    for (int frame = 0; frame < 6; ++frame)
    {
      ball->SetVisibility(frame % 3 == 1);
      const Picture expected = scene.InVTKsLight();
      EXPECT_TRUE(Matches(scene.InDeferredLight(), expected)) << frame;
    }
  }
}

TEST(DeferredMaterials, AreLeftAloneBeforeTheWindowIsResized)
{
  DeferredScene scene;
  scene.AddLights(2);
  const auto ball = MakeColouredBall();
  scene.Renderer->AddActor(ball);
  scene.InDeferredLight();
  ball->VisibilityOff();
  scene.InDeferredLight();
  for (const int width : { 37, 80 })
  {
    scene.Window->SetSize(width, 50);
    scene.ExpectAsVTK(DeferredParts);
  }
}

TEST(DeferredMaterials, AreAsManyAsThereAre)
{
  DeferredScene scene;
  scene.AddLights(4);
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    scene.Parts[i]->GetProperty()->SetSpecular(0.6);
    scene.Parts[i]->GetProperty()->SetSpecularPower(5.0 + 20.0 * static_cast<double>(i));
    scene.Parts[i]->GetProperty()->SetColor(0.7, 0.7, 0.7);
  }
  scene.ExpectAsVTK(DeferredParts);
  scene.Parts[0]->GetProperty()->SetAmbient(0.3);
  scene.Parts[0]->GetProperty()->SetAmbientColor(0.1, 0.9, 0.3);
  scene.ExpectAsVTK(DeferredParts);
}

TEST(DeferredMaterials, MayHaveAnotherSide)
{
  DeferredScene scene(false);
  scene.AddLights(4);
  vtkNew<vtkProperty> back;
  back->SetColor(0.1, 0.9, 0.2);
  back->SetSpecular(0.8);
  scene.Parts.back()->SetBackfaceProperty(back);
  scene.Parts.back()->RotateY(180.0);
  scene.Parts.back()->SetPosition(0.0, 0.0, -1.0);
  scene.ExpectAsVTK(DeferredParts);
}

TEST(DeferredMaterials, AreNotThoseOfVertices)
{
  DeferredScene scene;
  scene.AddLights(4);
  vtkProperty* const property = scene.Parts[0]->GetProperty();
  property->EdgeVisibilityOn();
  property->VertexVisibilityOn(); // which VTK draws with edges alone
  property->SetVertexColor(1.0, 0.0, 0.0);
  property->SetPointSize(7.0);
  property->RenderPointsAsSpheresOn(); // which are lit
  scene.ExpectAsVTK(DeferredParts);
}
