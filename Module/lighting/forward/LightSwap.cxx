#include "lighting/forward/LightSwap.h"

#include "lighting/forward/RendererLights.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"

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
  : Pass(pass)
{
  auto* const steps = vtkRenderStepsPass::SafeDownCast(pass);
  this->Before = steps ? steps->GetVolumetricPass() : nullptr;
  if (this->Before)
  {
    vtkNew<InLightPass> inLight;
    inLight->Set(this->Before, lights);
    steps->SetVolumetricPass(inLight);
  }
}

ScopedVolumeLights::~ScopedVolumeLights()
{
  if (this->Before)
  {
    static_cast<vtkRenderStepsPass*>(this->Pass)->SetVolumetricPass(this->Before);
  }
}

}
