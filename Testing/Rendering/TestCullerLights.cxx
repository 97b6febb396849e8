// The culler below passes for many lights: neither it nor any other culler changes what is lit, or how.
#include "CullerScene.h"
#include "TestPasses.h"
#include "vtkDeferredLightsPass.h"
#include "vtkEDLShading.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkLight.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSeeThroughPass.h"

#include <gtest/gtest.h>

namespace
{

class CullerLights : public CullerTest
{
protected:
  /** Boxes behind a lit wall, others beside the view, and lights of which the default CutOff cuts most. */
  void AddLitParts()
  {
    Scene.AddHidden();
    this->Wall = Scene.AddWall();
    this->Wall->GetProperty()->LightingOn();
    for (int i = 0; i < 10; ++i)
    {
      Scene.AddBox({ 60.0 + 30.0 * i, 0.0, -40.0 }, { 1.0, 1.0, 1.0 });
    }
    Scene.Renderer->AutomaticLightCreationOff();
    Scene.Renderer->RemoveAllLights();
    TestRandom random(3);
    for (int i = 0; i < 300; ++i)
    {
      const double x = 2.4 * random.Unit() - 1.2, y = 2.4 * random.Unit() - 1.2;
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPositional(true);
      light->SetConeAngle(180.0);
      light->SetPosition(x, y, 0.1 + 0.3 * random.Unit());
      light->SetFocalPoint(x, y, 0.0);
      const double steepness[] = { 0.5, 20.0, 200.0 };
      light->SetAttenuationValues(1.0, 0.0, steepness[i % 3]);
      light->SetIntensity(0.02);
      Scene.Renderer->AddLight(light);
    }
  }

  vtkSmartPointer<vtkActor> Wall;
};

TEST_P(CullerLights, AreTheSameWithAnyCuller)
{
  this->AddLitParts();
  for (const bool isDeferred : { false, true })
  {
    SCOPED_TRACE(isDeferred);
    vtkSmartPointer<vtkClusteredLightsPass> lights;
    lights = isDeferred ? vtkSmartPointer<vtkDeferredLightsPass>::New().Get() : nullptr;
    lights = lights ? lights : vtkSmartPointer<vtkClusteredLightsPass>::New();
    lights->SetDelegatePass(vtkNew<vtkSeeThroughPass>());
    Scene.Renderer->SetPass(lights);
    Scene.ExpectHidden(230, 1);

    Scene.Culler->CullingOff();
    const Picture plain = Scene.Render();
    vtkNew<vtkFrustumCoverageCuller> frustum;
    Scene.Renderer->AddCuller(frustum);
    EXPECT_TRUE(Matches(Scene.Render(), plain)) << "VTK's culler changes the light";
    Scene.Renderer->RemoveCuller(frustum);
    lights->ReleaseGraphicsResources(Scene.Window);
    Scene.Renderer->SetPass(nullptr);
  }
}

// What stands below a pass for lights is looked at as it is anywhere else.
TEST_P(CullerLights, LookBelowThem)
{
  this->AddLitParts();
  vtkNew<vtkEDLShading> shading;
  shading->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  const vtkSmartPointer<vtkRenderPass> beyond[] = { shading.Get(),
    vtkSmartPointer<UnknownPass>::New() };
  vtkNew<vtkDeferredLightsPass> lights;
  lights->SetCutOff(0.0);
  Scene.Renderer->SetPass(lights);
  for (const vtkSmartPointer<vtkRenderPass>& pass : beyond)
  {
    SCOPED_TRACE(pass->GetClassName());
    lights->SetDelegatePass(pass);
    Scene.ExpectNothingHidden(231, 1);
    pass->ReleaseGraphicsResources(Scene.Window);
  }
  lights->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  Scene.ExpectHidden(231, 1); // the control
  lights->ReleaseGraphicsResources(Scene.Window);
  Scene.Renderer->SetPass(nullptr);
}

// Below ambient occlusion the view alone hides, with a pass for lights in between, too.
TEST_P(CullerLights, FindAmbientOcclusionBelowThem)
{
  this->AddLitParts();
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  vtkNew<vtkClusteredLightsPass> lights;
  lights->SetDelegatePass(occlusion);
  Scene.Renderer->SetPass(lights);
  EXPECT_EQ(Scene.ExpectSame(), 10);
  lights->ReleaseGraphicsResources(Scene.Window);
  Scene.Renderer->SetPass(nullptr);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerLights, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
