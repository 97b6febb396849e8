#include "vtkSeeThroughPass.h"

#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
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

}

vtkSeeThroughPass::vtkSeeThroughPass()
{
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
