// Chains of passes in which opaque geometry is drawn by nested steps. One layer of glass per pixel is drawn as VTK
// draws it; vtkTranslucentPass blends a single layer exactly.
#include "TestPasses.h"
#include "TestScene.h"
#include "TestVolume.h"
#include "frame/ChainEdit.h"
#include "scene/PassTraits.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkClusteredLightsPass.h"
#include "vtkDefaultPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTranslucentPass.h"
#include "vtkTruthTransparencyPass.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumetricPass.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

/** A volume before the right-hand pane of PanesScene. */
vtkSmartPointer<vtkVolume> AddVolume(vtkRenderer* renderer)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff(); // by time
  const vtkSmartPointer<vtkVolume> volume =
    VolumeOf(VoxelsOf(10, { 0.06, 0.06, 0.02 }, { 0.2, -0.3, 0.75 },
               [](int i) { return 100 + i % 10 * 15; }),
      mapper, 0.5);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  renderer->AddVolume(volume);
  return volume;
}

/** Opaque spheres before a wall, glass panes side by side, and a plate of the overlay over one of them. */
struct PanesScene : TestScene
{
  PanesScene()
    : TestScene(72, 54)
  {
    this->AddRectangle(-3.0, -3.0, 3.0, 3.0, -0.6, { 0.8, 0.8, 0.7, 1.0 });
    this->AddSphere(-0.4, 0.0, 0.0, 0.35, { 0.9, 0.2, 0.1, 1.0 });
    this->AddSphere(0.4, 0.3, -0.2, 0.3, { 0.1, 0.5, 0.9, 1.0 });
    this->AddRectangle(-0.9, -0.5, -0.05, 0.6, 0.6, { 0.2, 0.4, 0.8, 0.4 });
    this->AddRectangle(0.05, -0.5, 0.9, 0.6, -0.3, { 0.3, 0.9, 0.2, 0.6 });
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(12.0, 20.0, 0.0);
    plane->SetPoint1(24.0, 20.0, 0.0);
    plane->SetPoint2(12.0, 30.0, 0.0);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor2D> label;
    label->SetMapper(mapper);
    label->GetProperty()->SetColor(0.9, 0.1, 0.6);
    this->Renderer->AddActor2D(label);
  }

  /** Add a pane that cuts the others, so that no order of props is right. */
  void AddLayers()
  {
    this->AddTriangle(
      { { { -0.9, -0.6, 0.9 }, { 0.9, -0.6, -0.4 }, { -0.9, 0.6, 0.3 } } }, { 0.9, 0.7, 0.1, 0.5 });
  }
};

/** A pass of an application that Vitrine does not know and that draws nothing. */
class SilentPass : public vtkRenderPass
{
public:
  static SilentPass* New() { VTK_STANDARD_NEW_BODY(SilentPass); }
  vtkTypeMacro(SilentPass, vtkRenderPass);
  void Render(const vtkRenderState*) override {}
};

using Chain = std::pair<const char*, std::function<vtkSmartPointer<vtkRenderPass>()>>;

template <class Class>
vtkSmartPointer<vtkRenderPass> Make()
{
  return vtkSmartPointer<Class>::New();
}

vtkSmartPointer<vtkRenderPass> OpaqueOnly()
{
  return InSequence({ Make<vtkOpaquePass>() });
}

const std::vector<Chain>& NestedChains()
{
  static const std::vector<Chain> chains = {
    { "AmbientOcclusionBeforeGlass",
      []
      {
        vtkNew<vtkSSAOPass> occlusion;
        occlusion->SetRadius(0.5);
        occlusion->SetDelegatePass(
          ByCamera(InSequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>() })));
        return ByCamera(InSequence({ occlusion, Make<vtkTranslucentPass>(),
          Make<vtkVolumetricPass>(), Make<vtkOverlayPass>() }));
      } },
    { "OpaqueInASequence",
      []
      {
        return ByCamera(
          InSequence({ Make<vtkLightsPass>(), OpaqueOnly(), Make<vtkTranslucentPass>() }));
      } },
    { "ShadowsBeforeGlass",
      []
      {
        vtkNew<vtkShadowMapPass> shadows;
        return ByCamera(
          InSequence({ shadows->GetShadowMapBakerPass(), shadows, Make<vtkTranslucentPass>() }));
      } },
    { "GlassInTheSecondSequence",
      []
      {
        return ByCamera(InSequence({ Make<vtkLightsPass>(), OpaqueOnly(),
          InSequence({ Make<vtkOpaquePass>(), Make<vtkTranslucentPass>() }) }));
      } },
    { "UnknownAtTheEnd",
      []
      {
        return ByCamera(
          InSequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>(), Make<vtkTranslucentPass>(),
            Make<vtkVolumetricPass>(), Make<vtkOverlayPass>(), Make<SilentPass>() }));
      } },
    { "DefaultBeforeGlass",
      [] {
        return ByCamera(
          InSequence({ Make<vtkLightsPass>(), OpaqueOnly(), Make<vtkDefaultPass>() }));
      } },
  };
  return chains;
}

class NestedChain : public testing::TestWithParam<Chain>
{
protected:
  Picture WithMethod(vtkRenderPass* method)
  {
    vtkNew<vtkSeeThroughPass> frame;
    frame->SetTranslucentPass(method);
    frame->Attach(this->Scene.Renderer);
    const Picture picture = this->Scene.Render();
    EXPECT_STREQ(frame->GetFallbackReason(), "");
    EXPECT_STREQ(frame->GetSetAsideReason(), "");
    frame->Detach();
    return picture;
  }

  PanesScene Scene;
};
}

TEST_P(NestedChain, DrawsOneLayerAsVTK)
{
  AddVolume(this->Scene.Renderer)->GetProperty()->ShadeOn(); // vtkSSAOPass of VTK 9.6 demands it
  const auto chain = GetParam().second();
  this->Scene.Renderer->SetPass(chain);
  this->Scene.Render();
  const Picture plain = this->Scene.Render();
  // Both blend in floating point and round to 8 bits once.
  EXPECT_TRUE(Matches(this->WithMethod(vtkNew<vtkLinkedListTransparencyPass>()), plain, 1));
  EXPECT_TRUE(Matches(this->Scene.Render(), plain)) << "the chain is not what it was";
}

TEST_P(NestedChain, DrawsLayersAsTruth)
{
  this->Scene.AddLayers();
  this->Scene.Renderer->SetPass(GetParam().second());
  const Picture blended = this->Scene.Render();
  const Picture truth = this->WithMethod(vtkNew<vtkTruthTransparencyPass>());
  EXPECT_TRUE(Matches(this->WithMethod(vtkNew<vtkLinkedListTransparencyPass>()), truth, 1));
  EXPECT_GT(LargestDifference(blended, truth), 5) << "VTK blends the panes rightly here";
}

INSTANTIATE_TEST_SUITE_P(Chains, NestedChain, testing::ValuesIn(NestedChains()),
  [](const auto& info) { return std::string(info.param.first); });

// Glass that several passes draw is drawn once, as one vtkRenderStepsPass draws it.
TEST(FrameChains, DrawGlassOnceWherePassesRepeatIt)
{
  PanesScene scene;
  const auto steps = Make<vtkRenderStepsPass>();
  scene.Renderer->SetPass(steps);
  const Picture once = scene.Render();
  const auto glass = Make<vtkTranslucentPass>();
  const vtkSmartPointer<vtkRenderPass> chains[] = {
    InSequence({ steps, steps }),
    InSequence({ steps, Make<vtkRenderStepsPass>() }),
    ByCamera(InSequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>(), Make<vtkTranslucentPass>(),
      Make<vtkTranslucentPass>(), Make<vtkOverlayPass>() })),
    ByCamera(InSequence({ Make<vtkLightsPass>(), InSequence({ Make<vtkOpaquePass>(), glass }),
      glass, Make<vtkOverlayPass>() })),
  };
  vtkNew<vtkSeeThroughPass> frame;
  for (const vtkSmartPointer<vtkRenderPass>& chain : chains)
  {
    scene.Renderer->SetPass(chain);
    const Picture byVTK = scene.Render();
    scene.Renderer->SetPass(frame);
    frame->SetEffectsPass(chain);
    EXPECT_TRUE(Matches(scene.Render(), once, 1)); // both round to 8 bits once
    scene.Renderer->SetPass(chain);
    EXPECT_TRUE(Matches(scene.Render(), byVTK)) << "the chain is not what it was";
  }
}

// A step among the passes that are drawn for shadows would be drawn by their shaders.
TEST(FrameChains, LeaveWhatIsDrawnForShadows)
{
  vtkNew<vtkShadowMapPass> shadows;
  const auto step = Make<SilentPass>();
  vitrine::ChainEdit chain(ByCamera(InSequence({ shadows->GetShadowMapBakerPass(), shadows })));
  EXPECT_TRUE(chain.PutTranslucentStep(step));
  EXPECT_TRUE(vitrine::HasPass(chain.Root(), "SilentPass"));
  EXPECT_FALSE(vitrine::HasPass(shadows, "SilentPass"));
}

// The culler hears of each pass that draws the frame, and of none that is set aside.
TEST(FrameChains, AreKnownToTheCuller)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkSeeThroughPass> frame;
  renderer->SetPass(frame);
  const auto beyond = [&renderer] { return vitrine::FindPassBeyondView(renderer, {}); };
  EXPECT_EQ(beyond(), "");
  const auto silent = Make<SilentPass>();
  const auto notKnown = "SilentPass is of a class that is not known";
  frame->SetOverlayPass(silent);
  EXPECT_EQ(beyond(), notKnown);
  frame->SetEffectsPass(vtkNew<vtkRenderStepsPass>());
  EXPECT_EQ(beyond(), "") << "the chain draws, and not the steps of the frame";
  frame->SetOverlayPass(nullptr);
  frame->SetEffectsPass(silent);
  EXPECT_STRNE(frame->GetSetAsideReason(), "");
  EXPECT_EQ(beyond(), "");
  frame->SetVolumetricPass(silent);
  EXPECT_EQ(beyond(), notKnown);
  frame->SetVolumetricPass(nullptr);
  frame->SetLightsPass(silent);
  EXPECT_EQ(beyond(), notKnown);
  frame->SetLightsPass(nullptr);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(silent);
  frame->SetCameraPass(camera);
  EXPECT_EQ(beyond(), notKnown);
}

namespace
{

vtkSmartPointer<vtkRenderStepsPass> StepsThatPeelVolumes()
{
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  vtkNew<vtkDualDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(steps->GetTranslucentPass());
  peeling->SetVolumetricPass(steps->GetVolumetricPass());
  steps->SetTranslucentPass(peeling);
  steps->SetVolumetricPass(nullptr);
  return steps;
}
}

// A pass that peels volumes with the glass gives way to the step, and its volumes are drawn behind the step.
TEST(FrameChains, KeepVolumesThatVTKPeeled)
{
  PanesScene scene;
  AddVolume(scene.Renderer);
  scene.Renderer->SetPass(vtkNew<vtkRenderStepsPass>());
  const Picture expected = scene.Render();
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  const auto steps = StepsThatPeelVolumes();
  for (const vtkSmartPointer<vtkRenderPass>& chain : { vtkSmartPointer<vtkRenderPass>(steps),
         ByCamera(InSequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>(),
           steps->GetTranslucentPass(), Make<vtkOverlayPass>() })) })
  {
    frame->SetEffectsPass(chain);
    EXPECT_TRUE(Matches(scene.Render(), expected, 2)); // both round before the volume is blended
  }
  EXPECT_TRUE(steps->GetTranslucentPass()->IsA("vtkDualDepthPeelingPass"));
}

namespace
{

/** PanesScene with a shaded volume, lit by three spot lights of different colours. */
struct ShadedVolumeScene : PanesScene
{
  ShadedVolumeScene()
    : Volume(AddVolume(this->Renderer))
  {
    this->Volume->GetProperty()->ShadeOn();
    this->Renderer->AutomaticLightCreationOff();
    for (int i = 0; i < 3; ++i)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPositional(true);
      light->SetPosition(1.5 * i - 1.5, 0.8, 2.0);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      light->SetConeAngle(80.0);
      light->SetColor(1.0 - 0.4 * i, 0.5, 0.2 + 0.3 * i);
      light->SetIntensity(0.5);
      this->Renderer->AddLight(light);
    }
    this->Lights->SetCutOff(0.0);
    this->Renderer->SetPass(this->Frame);
  }

  void ExpectLitAsByVTK(vtkRenderPass* chain)
  {
    this->Frame->SetEffectsPass(chain);
    this->Frame->SetLightingPass(nullptr);
    const Picture byVTK = this->Render();
    this->Frame->SetLightingPass(this->Lights);
    EXPECT_TRUE(Matches(this->Render(), byVTK));
    this->Volume->GetProperty()->ShadeOff();
    EXPECT_GT(LargestDifference(this->Render(), byVTK), 20) << "shading has no effect here";
    this->Volume->GetProperty()->ShadeOn();
  }

  vtkSmartPointer<vtkVolume> Volume;
  vtkNew<vtkSeeThroughPass> Frame;
  vtkNew<vtkClusteredLightsPass> Lights;
};
}

// Shaded volumes look up the renderer's lights, wherever their step stands below the pass for lights.
TEST(FrameChains, LightShadedVolumesAsVTK)
{
  ShadedVolumeScene scene;
  const std::pair<const char*, vtkSmartPointer<vtkRenderPass>> chains[] = {
    { "no chain", nullptr },
    { "steps", Make<vtkRenderStepsPass>() },
    { "sequence",
      ByCamera(InSequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>(),
        Make<vtkTranslucentPass>(), Make<vtkVolumetricPass>(), Make<vtkOverlayPass>() })) },
    { "sequence in a sequence",
      ByCamera(InSequence({ Make<vtkLightsPass>(), OpaqueOnly(),
        InSequence({ Make<vtkTranslucentPass>(), Make<vtkVolumetricPass>() }) })) },
    { "default pass", ByCamera(InSequence({ Make<vtkLightsPass>(), Make<vtkDefaultPass>() })) },
    { "peeled", StepsThatPeelVolumes() },
  };
  for (const auto& [name, chain] : chains)
  {
    SCOPED_TRACE(name);
    scene.ExpectLitAsByVTK(chain);
    EXPECT_EQ(scene.Lights->GetNumberOfLights(), 3);
  }
}

// VTK peels the volumes and lights them. It peels none that can be seen on llvmpipe.
TEST(FrameChains, LeaveTheLightsOfPeeledVolumesToVTK)
{
  ShadedVolumeScene scene;
  scene.AddSphere(-0.3, 0.2, 0.4, 0.3, { 0.9, 0.4, 0.2, 0.5 });
  scene.Window->AlphaBitPlanesOn();
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  const Picture byVTK = scene.Render();
  EXPECT_EQ(std::string(scene.Frame->GetFallbackReason()).find("LightingPass"), std::string::npos);
  scene.Frame->SetLightingPass(scene.Lights);
  EXPECT_TRUE(Matches(scene.Render(), byVTK));
  EXPECT_NE(std::string(scene.Frame->GetFallbackReason()).find("LightingPass"), std::string::npos);
  EXPECT_EQ(scene.Lights->GetNumberOfLights(), 0);
}
