#include "lighting/forward/LightSwap.h"

#include "lighting/forward/RendererLights.h"
#include "scene/PassTraits.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkVolumetricPass.h"

#include <utility>

namespace vitrine
{

namespace
{

class StandIn : public vtkLightCollection
{
public:
  static StandIn* New() { VTK_STANDARD_NEW_BODY(StandIn); }
  vtkTypeMacro(StandIn, vtkLightCollection);
};

/** Renders another pass with a given collection of lights. */
class InLightPass : public vtkRenderPass
{
public:
  static InLightPass* New() { VTK_STANDARD_NEW_BODY(InLightPass); }
  vtkTypeMacro(InLightPass, vtkRenderPass);

  void Set(vtkRenderPass* pass, vtkLightCollection* lights)
  {
    this->Drawing = pass;
    this->Lights = lights;
  }

  void Render(const vtkRenderState* s) override
  {
    {
      const ScopedLights lights(s->GetRenderer(), this->Lights);
      this->UpdateLights(s->GetRenderer());
      this->Drawing->Render(s);
    }
    this->UpdateLights(s->GetRenderer());
    this->NumberOfRenderedProps = this->Drawing->GetNumberOfRenderedProps();
  }

private:
  vtkSmartPointer<vtkRenderPass> Drawing;
  vtkSmartPointer<vtkLightCollection> Lights;
};

vtkSmartPointer<vtkRenderPass> InLight(vtkRenderPass* pass, vtkLightCollection* lights)
{
  auto inLight = vtkSmartPointer<InLightPass>::New();
  inLight->Set(pass, lights);
  return inLight;
}
}

vtkSmartPointer<vtkLightCollection> MakeStandIn(bool isPositional)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(isPositional);
  auto lights = vtkSmartPointer<StandIn>::New();
  lights->AddItem(light);
  return lights;
}

bool IsStandIn(vtkLightCollection* lights)
{
  return StandIn::SafeDownCast(lights) != nullptr;
}

ScopedLights::ScopedLights(vtkRenderer* renderer, vtkLightCollection* lights)
  : Renderer(renderer)
  , Before(LightsOf(renderer))
  , Meanwhile(lights)
  , Count(lights->GetNumberOfItems())
{
  LightsOf(this->Renderer) = this->Meanwhile;
}

ScopedLights::~ScopedLights()
{
  LightsOf(this->Renderer) = this->Before;
  while (this->Meanwhile->GetNumberOfItems() > this->Count)
  {
    this->Before->AddItem(static_cast<vtkLight*>(this->Meanwhile->GetItemAsObject(this->Count)));
    this->Meanwhile->RemoveItem(this->Count);
  }
}

ScopedVolumeLights::ScopedVolumeLights(vtkRenderPass* pass, vtkLightCollection* lights)
{
  AllPasses(pass,
    [this, lights](vtkRenderPass* one)
    {
      this->GiveLights(one, lights);
      return true;
    });
}

ScopedVolumeLights::~ScopedVolumeLights()
{
  for (auto i = this->Undo.rbegin(); i != this->Undo.rend(); ++i)
  {
    (*i)();
  }
}

void ScopedVolumeLights::GiveLights(vtkRenderPass* parent, vtkLightCollection* lights)
{
  if (auto* const steps = vtkRenderStepsPass::SafeDownCast(parent))
  {
    this->GiveLightsToStep(steps, lights);
  }
  else if (auto* const peeling = vtkDualDepthPeelingPass::SafeDownCast(parent))
  {
    this->GiveLightsToStep(peeling, lights);
  }
  else if (auto* const sequence = vtkSequencePass::SafeDownCast(parent))
  {
    this->GiveLightsInSequence(sequence, lights);
  }
}

template <class Parent>
void ScopedVolumeLights::GiveLightsToStep(Parent* parent, vtkLightCollection* lights)
{
  if (const vtkSmartPointer<vtkRenderPass> before = parent->GetVolumetricPass())
  {
    this->Undo.push_back([parent, before] { parent->SetVolumetricPass(before); });
    parent->SetVolumetricPass(InLight(before, lights));
  }
}

void ScopedVolumeLights::GiveLightsInSequence(vtkSequencePass* sequence, vtkLightCollection* lights)
{
  vtkNew<vtkRenderPassCollection> passes;
  bool hasVolumes = false;
  for (vtkRenderPass* const pass : TraitsOf(sequence).Delegates)
  {
    const bool drawsVolumes = vtkVolumetricPass::SafeDownCast(pass) != nullptr;
    passes->AddItem(drawsVolumes ? InLight(pass, lights).Get() : pass);
    hasVolumes = hasVolumes || drawsVolumes;
  }
  if (hasVolumes)
  {
    this->Undo.push_back(
      [sequence, before = vtkSmartPointer<vtkRenderPassCollection>(sequence->GetPasses())]
      { sequence->SetPasses(before); });
    sequence->SetPasses(passes);
  }
}

}
