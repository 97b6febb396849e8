#include "vtkSeeThroughPass.h"

#include "gl/VitrineOpenGL.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkSeeThroughPass);

namespace
{

// A hardware selector is served by the renderer itself, but only where no pass is set: with a pass the
// renderer leaves all drawing to it, and no pass of VTK's knows of selectors.
void RenderForSelector(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  renderer->SetPass(nullptr);
  renderer->DeviceRender();
  renderer->SetPass(pass);
}

// vtkCameraPass never tells the camera that the window is in stereo, so both eyes would see the same. The camera
// learns it where a renderer without a pass updates it; that also sets the viewport and clears.
class EyeCameraPass : public vtkCameraPass
{
public:
  static EyeCameraPass* New() { VTK_STANDARD_NEW_BODY(EyeCameraPass); }
  vtkTypeMacro(EyeCameraPass, vtkCameraPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkRenderer* renderer = s->GetRenderer();
    if (s->GetFrameBuffer() || !window || !renderer->IsActiveCameraCreated() || !this->DelegatePass)
    {
      this->Superclass::Render(s);
      return;
    }
    window->MakeCurrent();
    vtkOpenGLState* state = window->GetState();
    const vtkOpenGLState::ScopedglViewport viewport(state);
    const vtkOpenGLState::ScopedglScissor scissor(state);
    const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    renderer->GetActiveCamera()->Render(renderer);
    this->DelegatePass->Render(s);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
  }
};

}

vtkSeeThroughPass::vtkSeeThroughPass()
{
  vtkNew<EyeCameraPass> camera;
  camera->SetDelegatePass(this->SequencePass);
  this->SetCameraPass(camera);
  vtkNew<vtkLinkedListTransparencyPass> linkedList;
  this->SetTranslucentPass(linkedList);
}

vtkSeeThroughPass::~vtkSeeThroughPass() = default;

void vtkSeeThroughPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetSelector())
  {
    RenderForSelector(renderer);
    return;
  }
  this->Superclass::Render(s);
}
