// vtkSeeThroughPass as the frame: effects of the renderer stay, whether flags or passes, and stay where they were.
#include "TestPasses.h"
#include "TestScene.h"
#include "TestVolume.h"

#include "vtkActor.h"
#include "vtkClearRGBPass.h"
#include "vtkClusteredLightsPass.h"
#include "vtkCommand.h"
#include "vtkDefaultPass.h"
#include "vtkEDLShading.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

/** Opaque spheres before a wall, and translucent ones among them. */
struct FrameScene : TestScene
{
  FrameScene()
    : TestScene(72, 54)
  {
    this->AddRectangle(-3.0, -3.0, 3.0, 3.0, -0.6, { 0.8, 0.8, 0.7, 1.0 })
      ->GetProperty()
      ->LightingOn();
    this->AddSphere(-0.4, 0.0, 0.0, 0.35, { 0.9, 0.2, 0.1, 1.0 });
    this->AddSphere(0.4, 0.3, -0.2, 0.3, { 0.1, 0.5, 0.9, 1.0 });
    for (int i = 0; i < 3; ++i)
    {
      this->Glass.push_back(
        this->AddSphere(0.35 * i - 0.4, 0.15 * i, 0.3, 0.4, { 0.2, 0.3 * i, 0.8, 0.4 }));
    }
  }

  void ShowGlass(bool isShown)
  {
    for (const auto& part : this->Glass)
    {
      part->SetVisibility(isShown);
    }
  }

  std::vector<vtkSmartPointer<vtkActor>> Glass;
};

template <class Class>
vtkSmartPointer<Class> Around(vtkRenderPass* pass)
{
  auto around = vtkSmartPointer<Class>::New();
  around->SetDelegatePass(pass);
  return around;
}

using Chain = std::pair<const char*, std::function<vtkSmartPointer<vtkRenderPass>()>>;

/** Chains of passes that applications put together. */
const std::vector<Chain>& Chains()
{
  static const std::vector<Chain> chains = {
    { "Steps", [] { return vtkSmartPointer<vtkRenderStepsPass>::New(); } },
    { "SSAAOfEDL",
      [] { return Around<vtkSSAAPass>(Around<vtkEDLShading>(vtkNew<vtkRenderStepsPass>())); } },
    { "BlurOfSequence",
      []
      {
        return Around<vtkGaussianBlurPass>(ByCamera(InSequence(
          { vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), vtkNew<vtkTranslucentPass>() })));
      } },
    { "ToneMappingOfDefault",
      []
      {
        return Around<vtkToneMappingPass>(
          ByCamera(InSequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkDefaultPass>() })));
      } },
    { "OpaqueAlone",
      [] {
        return ByCamera(InSequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>() }));
      } },
    { "ShadowsBehindSteps",
      []
      {
        vtkNew<vtkShadowMapPass> shadows;
        return ByCamera(
          InSequence({ vtkNew<vtkRenderStepsPass>(), shadows->GetShadowMapBakerPass(), shadows }));
      } },
  };
  return chains;
}

class FrameChain : public testing::TestWithParam<Chain>
{
protected:
  Picture WithMethod(vtkRenderPass* method)
  {
    vtkNew<vtkSeeThroughPass> frame;
    frame->SetTranslucentPass(method);
    frame->Attach(this->Scene.Renderer);
    Picture picture = this->Scene.Render();
    picture = this->Scene.Render();
    EXPECT_STREQ(frame->GetFallbackReason(), "");
    EXPECT_STREQ(frame->GetSetAsideReason(), "");
    frame->Detach();
    return picture;
  }

  FrameScene Scene;
};
}

TEST_P(FrameChain, StaysAroundWhatIsOpaque)
{
  this->Scene.ShowGlass(false);
  const auto chain = GetParam().second();
  this->Scene.Renderer->SetPass(chain);
  this->Scene.Render();
  const Picture plain = this->Scene.Render();
  EXPECT_TRUE(Matches(this->WithMethod(vtkNew<vtkLinkedListTransparencyPass>()), plain));
  EXPECT_EQ(this->Scene.Renderer->GetPass(), chain);
  EXPECT_TRUE(Matches(this->Scene.Render(), plain)) << "the chain is not what it was";
}

TEST_P(FrameChain, StaysAroundTruth)
{
  this->Scene.Renderer->SetPass(GetParam().second());
  const Picture truth = this->WithMethod(vtkNew<vtkTruthTransparencyPass>());
  const Picture exact = this->WithMethod(vtkNew<vtkLinkedListTransparencyPass>());
  EXPECT_TRUE(Matches(exact, truth, 2)); // effects work on rounded pictures
  this->Scene.ShowGlass(false);
  EXPECT_GT(LargestDifference(exact, this->Scene.Render()), 20) << "the glass is missing";
}

INSTANTIATE_TEST_SUITE_P(Chains, FrameChain, testing::ValuesIn(Chains()),
  [](const auto& info) { return std::string(info.param.first); });

// Opaque geometry that a later pass draws again does not cover what is translucent.
TEST(Frame, DrawsGlassBehindShadowsThatComeLater)
{
  FrameScene scene;
  vtkNew<vtkShadowMapPass> shadows;
  scene.Renderer->SetPass(ByCamera(
    InSequence({ vtkNew<vtkRenderStepsPass>(), shadows->GetShadowMapBakerPass(), shadows })));
  vtkNew<vtkSeeThroughPass> frame;
  frame->Attach(scene.Renderer);
  const Rgba middle = scene.Render().At(36, 27);
  scene.ShowGlass(false);
  const Rgba opaque = scene.Render().At(36, 27);
  EXPECT_NE(middle, opaque);
  scene.Renderer->SetPass(nullptr);
}

TEST(Frame, DrawsFlagsOfTheRendererAsVTK)
{
  const std::pair<const char*, std::function<void(vtkRenderer*, bool)>> flags[] = {
    { "UseFXAA", [](vtkRenderer* renderer, bool isOn) { renderer->SetUseFXAA(isOn); } },
    { "UseSSAO",
      [](vtkRenderer* renderer, bool isOn)
      {
        renderer->SetUseSSAO(isOn);
        renderer->SetSSAORadius(0.5);
        renderer->SetSSAOBias(0.01);
      } },
    { "UseHiddenLineRemoval",
      [](vtkRenderer* renderer, bool isOn) { renderer->SetUseHiddenLineRemoval(isOn); } },
    { "UseShadows", [](vtkRenderer* renderer, bool isOn) { renderer->SetUseShadows(isOn); } },
  };
  FrameScene scene;
  scene.ShowGlass(false);
  scene.AddSphere(0.0, -0.5, 0.2, 0.3, { 1.0, 1.0, 0.2, 1.0 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  vtkNew<vtkLight> spot; // VTK's shadows are those of spot lights
  spot->SetLightTypeToSceneLight();
  spot->SetPositional(true);
  spot->SetPosition(2.0, 1.5, 3.0);
  spot->SetFocalPoint(0.0, 0.0, 0.0);
  spot->SetConeAngle(30.0);
  scene.Renderer->AddLight(spot);
  const Picture none = scene.Render();
  vtkNew<vtkSeeThroughPass> frame;
  for (const auto& [name, set] : flags)
  {
    SCOPED_TRACE(name);
    set(scene.Renderer, true);
    scene.Renderer->SetPass(nullptr);
    const Picture plain = scene.Render();
    // Later releases than 9.1 draw this wireframe alike without its hidden lines.
    const bool mayBeAlike = VTK_MINOR_VERSION > 1 && std::string(name) == "UseHiddenLineRemoval";
    EXPECT_TRUE(mayBeAlike || plain != none) << "the flag has no effect here";
    scene.Renderer->SetPass(frame);
    EXPECT_TRUE(Matches(scene.Render(), plain));
    scene.ShowGlass(true);
    EXPECT_NE(scene.Render(), plain);
    scene.ShowGlass(false);
    set(scene.Renderer, false);
  }
}

// VTK peels glass and volumes together. The frame lets it, and says so.
TEST(Frame, LeavesVolumesToPeelingWhereVTKPeelsThem)
{
  FrameScene scene;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff(); // by time
  scene.Renderer->AddVolume(VolumeOf(
    VoxelsOf(10, { 0.15, 0.15, 0.15 }, { -0.7, -0.7, -0.4 }, [](int i) { return i * 97 % 256; }),
    mapper, 0.2));
  scene.Window->AlphaBitPlanesOn();
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  const Picture plain = scene.Render();
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  EXPECT_TRUE(Matches(scene.Render(), plain));
  EXPECT_NE(
    std::string(frame->GetFallbackReason()).find("UseDepthPeelingForVolumes"), std::string::npos);
  scene.Renderer->UseDepthPeelingForVolumesOff();
  EXPECT_NE(scene.Render(), plain) << "peeling has no effect here";
  EXPECT_STREQ(frame->GetFallbackReason(), "");
}

TEST(Frame, TakesInPassesThatAreSetLater)
{
  FrameScene scene;
  const auto blur = Around<vtkGaussianBlurPass>(vtkNew<vtkRenderStepsPass>());
  vtkNew<vtkSeeThroughPass> frame;
  frame->Attach(scene.Renderer);
  const Picture sharp = scene.Render();
  scene.Renderer->SetPass(blur);
  const Picture blurred = scene.Render();
  EXPECT_EQ(scene.Renderer->GetPass(), frame);
  EXPECT_EQ(frame->GetEffectsPass(), blur);
  EXPECT_NE(blurred, sharp);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), frame);
  scene.Renderer->SetPass(nullptr);
  EXPECT_TRUE(Matches(scene.Render(), sharp));
  scene.Renderer->SetPass(blur);
  scene.Render();
  frame->Detach();
  EXPECT_EQ(scene.Renderer->GetPass(), blur);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), nullptr);
}

// A chain that VTK draws by a pass that nobody knows has no place for the step.
TEST(Frame, SetsAsideWhatHasNoPlaceForTheStep)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  frame->Attach(scene.Renderer);
  const Picture own = scene.Render();
  EXPECT_STREQ(frame->GetSetAsideReason(), "");
  frame->SetEffectsPass(vtkNew<vtkClearRGBPass>());
  EXPECT_NE(std::string(frame->GetSetAsideReason()).find("vtkClearRGBPass is set aside"),
    std::string::npos);
  EXPECT_TRUE(Matches(scene.Render(), own));
  frame->SetEffectsPass(nullptr);
  EXPECT_STREQ(frame->GetSetAsideReason(), "");
}

TEST(Frame, RefusesAChainThatContainsIt)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  int errors = 0;
  vtkNew<vtkSSAAPass> supersampling;
  supersampling->SetDelegatePass(frame);
  struct Counter : vtkCommand
  {
    static Counter* New() { return new Counter; }
    void Execute(vtkObject*, unsigned long, void*) override { ++*this->Count; }
    int* Count = nullptr;
  };
  vtkNew<Counter> counter;
  counter->Count = &errors;
  frame->AddObserver(vtkCommand::ErrorEvent, counter);
  frame->SetEffectsPass(supersampling);
  EXPECT_EQ(errors, 1);
  EXPECT_EQ(frame->GetEffectsPass(), nullptr);
  supersampling->SetDelegatePass(nullptr);
}

// The same lights, whether the pass for them stands around the frame, is the frame's, or stands within a chain.
TEST(Frame, IsLitByItsLightingPass)
{
  FrameScene scene;
  scene.Renderer->AutomaticLightCreationOff();
  for (int i = 0; i < 12; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(true);
    light->SetPosition(0.2 * i - 1.0, 0.5 - 0.1 * i, 1.0);
    light->SetFocalPoint(0.2 * i - 1.0, 0.5 - 0.1 * i, 0.0);
    light->SetConeAngle(60.0);
    light->SetIntensity(0.2);
    scene.Renderer->AddLight(light);
  }
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  const Picture byVTK = scene.Render();
  vtkNew<vtkClusteredLightsPass> lights;
  lights->SetCutOff(0.0);
  frame->SetLightingPass(lights);
  EXPECT_TRUE(Matches(scene.Render(), byVTK));
  EXPECT_EQ(lights->GetNumberOfLights(), 12);
  EXPECT_EQ(lights->GetDelegatePass(), nullptr);
  frame->SetEffectsPass(Around<vtkSSAAPass>(vtkNew<vtkRenderStepsPass>()));
  const Picture supersampled = scene.Render();
  EXPECT_EQ(lights->GetNumberOfLights(), 12);
  frame->SetLightingPass(nullptr);
  EXPECT_TRUE(Matches(scene.Render(), supersampled));
  frame->SetLightingPass(lights);
  frame->SetEffectsPass(nullptr);
  scene.Renderer->SetUseShadows(true);
  scene.Render();
  EXPECT_NE(std::string(lights->GetFallbackReason()).find("shadow maps"), std::string::npos);
  EXPECT_STREQ(frame->GetFallbackReason(), "");
}

// What effects hold is released with the frame, while its window lives; VTK complains where it is not.
TEST(Frame, ReleasesWhatEffectsHold)
{
  FrameScene scene;
  vtkNew<vtkLight> spot;
  spot->SetLightTypeToSceneLight();
  spot->SetPositional(true);
  spot->SetPosition(2.0, 1.5, 3.0);
  scene.Renderer->AddLight(spot);
  scene.Renderer->UseShadowsOn();
  scene.Renderer->UseFXAAOn();
  {
    vtkNew<vtkSeeThroughPass> frame;
    scene.Renderer->SetPass(frame);
    scene.Render();
    scene.Renderer->SetPass(nullptr);
  }
  scene.Renderer->UseShadowsOff();
  scene.Renderer->UseFXAAOff();
  scene.Render();
}
