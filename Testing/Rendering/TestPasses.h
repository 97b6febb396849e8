/**
 * Render passes that applications put together.
 */
#ifndef VITRINE_TEST_PASSES_H
#define VITRINE_TEST_PASSES_H

#include "vtkCameraPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"

#include <initializer_list>

/** Passes in the order in which they draw. */
inline vtkSmartPointer<vtkSequencePass> InSequence(std::initializer_list<vtkRenderPass*> passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* const pass : passes)
  {
    collection->AddItem(pass);
  }
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(collection);
  return sequence;
}

/** A pass below one that sets the camera. */
inline vtkSmartPointer<vtkRenderPass> ByCamera(vtkRenderPass* pass)
{
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(pass);
  return camera;
}

/** A pass of a class that Vitrine does not know. It draws as a vtkRenderStepsPass does. */
class UnknownPass : public vtkRenderPass
{
public:
  static UnknownPass* New() { VTK_STANDARD_NEW_BODY(UnknownPass); }
  vtkTypeMacro(UnknownPass, vtkRenderPass);
  void Render(const vtkRenderState* s) override { this->Steps->Render(s); }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Steps->ReleaseGraphicsResources(window);
  }

private:
  vtkNew<vtkRenderStepsPass> Steps;
};

#endif
