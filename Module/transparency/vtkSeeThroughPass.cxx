#include "vtkSeeThroughPass.h"

#include "vtkHardwareSelector.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSeeThroughPass);

vtkSeeThroughPass::vtkSeeThroughPass()
{
  vtkNew<vtkLinkedListTransparencyPass> linkedList;
  this->SetTranslucentPass(linkedList);
}

vtkSeeThroughPass::~vtkSeeThroughPass() = default;

void vtkSeeThroughPass::Render(const vtkRenderState* s)
{
  this->Superclass::Render(s);
}
