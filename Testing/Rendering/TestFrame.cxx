// vtkSeeThroughPass as the frame: effects of the renderer stay, whether flags or passes, and stay where they were.
#include "FrameScene.h"
#include "TestMessages.h"
#include "TestPasses.h"
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
#include "vtkTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

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

/** Adds a volume among the glass, and has VTK peel both together. */
void AddPeeledVolume(FrameScene& scene)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff(); // by time
  scene.Renderer->AddVolume(VolumeOf(
    VoxelsOf(10, { 0.15, 0.15, 0.15 }, { -0.7, -0.7, -0.4 }, [](int i) { return i * 97 % 256; }),
    mapper, 0.2));
  scene.Window->AlphaBitPlanesOn();
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
}
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

// A method's framebuffers then had the stencil of the window and the depth of the tone mapping.
TEST(Frame, IsExactInATargetWithoutStencilAfterOneWithIt)
{
  const auto draw = [](vtkTransparencyPass* method, bool startsInWindow)
  {
    FrameScene scene;
    scene.Window->SetStencilCapable(1);
    vtkNew<vtkSeeThroughPass> frame;
    frame->SetTranslucentPass(method);
    scene.Renderer->SetPass(frame);
    if (startsInWindow)
    {
      scene.Render();
    }
    scene.Renderer->SetPass(Around<vtkToneMappingPass>(ByCamera(frame)));
    Picture picture = scene.Render();
    EXPECT_STREQ(frame->GetFallbackReason(), "");
    return picture;
  };
  for (const char* const name : { "linked-list", "truth" })
  {
    SCOPED_TRACE(name);
    const auto method = [name]
    { return vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod(name)); };
    EXPECT_TRUE(Matches(draw(method(), true), draw(method(), false)));
  }
}

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

TEST(Frame, SmoothsWithoutOptionsAsVTK)
{
  FrameScene scene;
  scene.ShowGlass(false);
  scene.Renderer->UseFXAAOn();
  scene.Renderer->SetFXAAOptions(nullptr);
  const Picture plain = scene.Render();
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  EXPECT_TRUE(Matches(scene.Render(), plain));
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
  AddPeeledVolume(scene);
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

// VTK finds out while it peels that a device cannot peel volumes.
TEST(Frame, DrawsVolumesThatVTKCannotPeel)
{
  setenv("VTK_USE_LEGACY_DEPTH_PEELING", "1", 1);
  FrameScene scene;
  AddPeeledVolume(scene);
  const Picture plain = scene.Render();
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  scene.Renderer->UseDepthPeelingForVolumesOn(); // VTK has switched it off.
  EXPECT_TRUE(Matches(scene.Render(), plain));
  EXPECT_FALSE(TakeMessages().empty()) << "VTK does not warn, so it peels them";
  unsetenv("VTK_USE_LEGACY_DEPTH_PEELING");
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

namespace
{

/** Counts the errors of an object during its lifetime. */
class ErrorsOf
{
public:
  explicit ErrorsOf(vtkObject* object)
    : Object(object)
  {
    this->Counting->Count = &this->Number;
    this->Object->AddObserver(vtkCommand::ErrorEvent, this->Counting);
  }
  ~ErrorsOf() { this->Object->RemoveObserver(this->Counting); }
  ErrorsOf(const ErrorsOf&) = delete;
  void operator=(const ErrorsOf&) = delete;

  int Number = 0;

private:
  struct Counter : vtkCommand
  {
    static Counter* New() { return new Counter; }
    void Execute(vtkObject*, unsigned long, void*) override { ++*this->Count; }
    int* Count = nullptr;
  };
  vtkObject* Object;
  vtkNew<Counter> Counting;
};
}

TEST(Frame, RefusesAChainThatContainsIt)
{
  vtkNew<vtkSeeThroughPass> frame;
  const auto supersampling = Around<vtkSSAAPass>(frame);
  const ErrorsOf errors(frame);
  frame->SetEffectsPass(supersampling);
  EXPECT_EQ(errors.Number, 1);
  EXPECT_EQ(frame->GetEffectsPass(), nullptr);
  supersampling->SetDelegatePass(nullptr);
}

TEST(Frame, RefusesLightsThatDrawIt)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  const auto lights = Around<vtkClusteredLightsPass>(Around<vtkSSAAPass>(frame));
  {
    const ErrorsOf errors(frame);
    frame->SetLightingPass(lights);
    EXPECT_EQ(errors.Number, 1);
    EXPECT_EQ(frame->GetLightingPass(), nullptr);
  }
  scene.Renderer->SetPass(lights);
  EXPECT_NE(scene.Render().At(36, 27), TestBackground);
  lights->SetDelegatePass(nullptr);
}

// A pass that is set as a step of its own would draw without end.
TEST(Frame, DrawsOnceWhereItIsItsOwnStep)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(frame);
  for (vtkRenderPass* const step :
    { static_cast<vtkRenderPass*>(frame), static_cast<vtkRenderPass*>(steps) })
  {
    const ErrorsOf errors(frame);
    frame->SetTranslucentPass(step);
    EXPECT_NE(scene.Render().At(36, 27), TestBackground);
    EXPECT_EQ(errors.Number, 1);
  }
  frame->SetTranslucentPass(nullptr);
  steps->SetTranslucentPass(nullptr);
}

// Lights that are told to draw the frame after they became its LightingPass draw it, and go on doing so.
TEST(Frame, RestoresTheDelegateOfItsLights)
{
  FrameScene scene;
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetPosition(0.5, 0.5, 2.0);
  scene.Renderer->AddLight(light);
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  vtkNew<vtkClusteredLightsPass> lights;
  frame->SetLightingPass(lights);
  const Picture expected = scene.Render();
  lights->SetDelegatePass(frame);
  scene.Renderer->SetPass(lights);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  EXPECT_EQ(lights->GetDelegatePass(), frame);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  vtkNew<vtkRenderStepsPass> steps;
  lights->SetDelegatePass(steps);
  scene.Renderer->SetPass(frame);
  frame->SetEffectsPass(vtkNew<vtkRenderStepsPass>());
  EXPECT_TRUE(Matches(scene.Render(), expected));
  EXPECT_EQ(lights->GetDelegatePass(), steps);
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

// A pass that is released for one window keeps what it has in another, and takes nothing from others there.
TEST(Frame, ReleasesEffectsOfOneWindowAlone)
{
  FrameScene first;
  FrameScene second;
  vtkNew<vtkSeeThroughPass> frame;
  vtkNew<vtkSeeThroughPass> other;
  first.Renderer->UseFXAAOn();
  first.Renderer->SetPass(frame);
  second.Renderer->UseFXAAOn();
  second.Renderer->SetPass(other);
  const Picture expected = first.Render();
  EXPECT_TRUE(Matches(second.Render(), expected));
  frame->ReleaseGraphicsResources(second.Window);
  EXPECT_TRUE(Matches(second.Render(), expected));
  EXPECT_TRUE(Matches(first.Render(), expected));
}

// A window that was finalized while the frame was elsewhere has a new context.
TEST(Frame, DrawsEffectsInANewContext)
{
  FrameScene scene;
  scene.Renderer->UseFXAAOn();
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  const Picture expected = scene.Render();
  scene.Renderer->SetPass(nullptr);
  scene.Window->Finalize();
  scene.Renderer->SetPass(frame);
  EXPECT_TRUE(Matches(scene.Render(), expected));
  EXPECT_TRUE(Matches(scene.Render(), expected));
}
