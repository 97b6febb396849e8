#include "frame/RendererFlags.h"

#include "vtkHiddenLineRemovalPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <functional>

namespace vitrine
{

/** A pass that calls a function. */
class RendererFlags::Step : public vtkRenderPass
{
public:
  static Step* New() { VTK_STANDARD_NEW_BODY(Step); }
  vtkTypeMacro(Step, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->NumberOfRenderedProps = 0;
    this->Draw(s, static_cast<vtkOpenGLRenderer*>(s->GetRenderer()));
  }

  std::function<void(const vtkRenderState*, vtkOpenGLRenderer*)> Draw;
};

RendererFlags::RendererFlags()
{
  this->Shadowed->Draw = [this](const vtkRenderState* s, vtkOpenGLRenderer* renderer)
  {
    this->Enter(renderer);
    this->Shadows->GetShadowMapBakerPass()->Render(s);
    this->Shadows->Render(s);
  };
  this->Opaque->Draw = [](const vtkRenderState* s, vtkOpenGLRenderer* renderer)
  { renderer->DeviceRenderOpaqueGeometry(s->GetFrameBuffer()); };
  this->Smoothed->Draw = [this](const vtkRenderState* s, vtkOpenGLRenderer* renderer)
  {
    if (s->GetPropArrayCount() > 0) // VTK tests this too.
    {
      this->Enter(renderer);
      if (renderer->GetFXAAOptions())
      {
        this->Smoothing->UpdateConfiguration(renderer->GetFXAAOptions());
      }
      this->Smoothing->Execute(renderer);
    }
  };
  this->Peeled->Draw = [](const vtkRenderState* s, vtkOpenGLRenderer* renderer)
  { renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer()); };
}

RendererFlags::~RendererFlags()
{
  this->Leave();
}

/** Switches to the window of `renderer`, whose context is current. */
void RendererFlags::Enter(vtkOpenGLRenderer* renderer)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Context.LivesIn(window))
  {
    this->Leave();
    // Leave() releases nothing of a context that is gone, and VTK's objects would go on using it.
    this->ReleaseGraphicsResources(window);
    this->Context.Hold(window);
  }
}

void RendererFlags::Leave()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow* window) { this->ReleaseGraphicsResources(window); });
}

vtkRenderPass* RendererFlags::OpaqueStep(vtkOpenGLRenderer* renderer, vtkRenderPass* plain)
{
  if (renderer->GetUseShadows())
  {
    return this->Shadowed;
  }
  const bool isByRenderer = renderer->GetUseSSAO() || renderer->GetUseHiddenLineRemoval();
  return isByRenderer ? this->Opaque.Get() : plain;
}

vtkRenderPass* RendererFlags::SmoothingStep(vtkOpenGLRenderer* renderer)
{
  return renderer->GetUseFXAA() ? this->Smoothed.Get() : nullptr;
}

vtkRenderPass* RendererFlags::PeelingStep()
{
  return this->Peeled;
}

vtkRenderPass* RendererFlags::UnpeeledStep(vtkRenderPass* volumes)
{
  // VTK clears the flag while it peels if the device lacks what that takes.
  this->Unpeeled->Draw = [pass = vtkSmartPointer<vtkRenderPass>(volumes)](
                           const vtkRenderState* s, vtkOpenGLRenderer* renderer)
  {
    if (pass && !renderer->GetUseDepthPeelingForVolumes())
    {
      pass->Render(s);
    }
  };
  return this->Unpeeled;
}

bool RendererFlags::PeelsVolumes(vtkOpenGLRenderer* renderer, const vtkRenderState* s)
{
  if (!renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes() ||
    renderer->GetUseShadows())
  {
    return false;
  }
  bool hasTranslucent = false;
  vtkNew<vtkPropCollection> volumes;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* const prop = s->GetPropArray()[i];
    prop->GetVolumes(volumes);
    hasTranslucent = hasTranslucent || prop->HasTranslucentPolygonalGeometry();
  }
  return hasTranslucent && volumes->GetNumberOfItems() > 0;
}

void RendererFlags::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Context.Lives() && !this->Context.LivesIn(window))
  {
    return; // What lives in another window is still needed there.
  }
  this->Shadows->GetShadowMapBakerPass()->ReleaseGraphicsResources(window);
  this->Shadows->ReleaseGraphicsResources(window);
  this->Smoothing->ReleaseGraphicsResources();
  this->Context.LetGo();
}

}
