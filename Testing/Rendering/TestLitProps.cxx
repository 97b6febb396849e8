// Lights end where nothing is lit, and nowhere else.

#include "LightScene.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

namespace
{

/** A spot light that reaches from one place towards another. */
void AimSpot(LightScene& scene, const std::array<double, 3>& from, const std::array<double, 3>& to,
  double angle)
{
  const auto spot = scene.AddLight(LightKind::Spot, 1.0, 0.0);
  spot->SetPosition(from[0], from[1], from[2]);
  spot->SetFocalPoint(to[0], to[1], to[2]);
  spot->SetConeAngle(angle);
}

void ExpectAsVTK(LightScene& scene)
{
  const Picture expected = scene.InVTKsLight();
  EXPECT_TRUE(Matches(scene.InClusteredLight(), expected));
}

/** The wall, seen from just above its plane: at its far edge a pixel is as wide as the way there. */
struct GrazedFloor : LightScene
{
  explicit GrazedFloor(int multisamples)
    : LightScene(false, false, multisamples)
  {
    for (const auto& part : this->Parts)
    {
      part->SetVisibility(part == this->Parts.back());
    }
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -4.0, -0.45);
    camera->SetFocalPoint(0.0, 4.0, -0.482); // the midst of the edge's pixels is beyond it
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.5, 30.0);
    this->AddLight(LightKind::Directional, 0.2);
    AimSpot(*this, { 0.0, 3.3, -0.45 }, { 0.0, 20.0, -0.5 }, 40.0); // beyond the edge, at nothing
  }
};
}

TEST(LitProps, EndSpotLightsThatShineAtThem)
{
  LightScene scene(false);
  for (int i = 0; i < 12; ++i)
  {
    AimSpot(
      scene, { 0.3 * i - 1.6, 0.1 * i - 0.5, -0.3 }, { 0.3 * i - 1.6, 0.1 * i - 0.5, -0.5 }, 50.0);
  }
  AimSpot(scene, { 0.0, 0.0, -0.8 }, { 0.0, 0.0, -2.0 }, 50.0); // behind the wall, away from it
  ExpectAsVTK(scene);
  EXPECT_GT(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -3.5), 0); // at the wall
  EXPECT_EQ(scene.Lights->GetNumberOfLightsAt(0.0, 0.0, -4.9), 0); // far behind
}

TEST(LitProps, EndNoLightsThatReachWhatIsDrawnBeyondTheirBounds)
{
  LightScene scene(false);
  vtkActor* const wall = scene.Parts.back();
  wall->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
    "//VTK::PositionVC::Impl\n  vertexVCVSOutput.z -= 1.0;\n", false);
  AimSpot(scene, { 0.0, 0.0, -0.8 }, { 0.0, 0.0, -2.0 }, 60.0); // behind where the wall would be
  ExpectAsVTK(scene);
}

TEST(LitProps, EndNoLightsThatReachSamplesBeyondAFace)
{
  for (const int multisamples : { 0, 4 })
  {
    SCOPED_TRACE(multisamples);
    GrazedFloor floor(multisamples);
    ExpectAsVTK(floor);
  }
}

TEST(LitProps, UseTheClustersThatTheyAreIn)
{
  LightScene scene(false);
  for (int i = 0; i < 9; ++i)
  {
    scene.AddLight(LightKind::Point);
  }
  for (const auto& part : scene.Parts)
  {
    part->SetVisibility(part == scene.Parts[0] || part == scene.Parts[1]);
  }
  ExpectAsVTK(scene);
  EXPECT_GT(scene.Lights->GetNumberOfUsedClusters(), 3);
  EXPECT_LT(scene.Lights->GetNumberOfUsedClusters(), scene.Lights->GetNumberOfClusters() / 3);
  scene.Parts[0]->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::PositionVC::Impl", true, "//VTK::PositionVC::Impl\n", false);
  ExpectAsVTK(scene); // of what is drawn nobody knows where
  EXPECT_EQ(scene.Lights->GetNumberOfUsedClusters(), scene.Lights->GetNumberOfClusters());
}

TEST(LitProps, AreLitWhereverTheyAre)
{
  for (const double away : { 0.0, 1e3, 1e6 })
  {
    for (int frame = 0; frame < 6; ++frame)
    {
      LightScene scene(frame % 2 == 0);
      scene.Lights->SetTileSize(8);
      for (int i = 0; i < 6; ++i)
      {
        const auto light = scene.AddLight(i % 2 == 0 ? LightKind::Point : LightKind::Spot);
        const double* const at = light->GetPosition();
        light->SetPosition(at[0] + away, at[1], at[2]);
        const double* const to = light->GetFocalPoint();
        light->SetFocalPoint(to[0] + away, to[1], to[2]);
      }
      for (const auto& part : scene.Parts)
      {
        part->AddPosition(away, 0.0, 0.0);
        part->RotateX(20.0 * frame);
      }
      vtkCamera* const camera = scene.Renderer->GetActiveCamera();
      const double* const eye = camera->GetPosition();
      camera->SetPosition(eye[0] + away, eye[1], eye[2] - 0.4 * frame);
      camera->SetFocalPoint(away, 0.0, 0.0);
      SCOPED_TRACE(std::to_string(away) + " " + std::to_string(frame));
      ExpectAsVTK(scene);
    }
  }
}

TEST(LitProps, MayBeNone)
{
  LightScene scene;
  for (const auto& part : scene.Parts)
  {
    part->VisibilityOff();
  }
  scene.AddLight(LightKind::Point);
  scene.AddLight(LightKind::Spot);
  ExpectAsVTK(scene);
}
