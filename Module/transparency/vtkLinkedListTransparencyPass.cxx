#include "vtkLinkedListTransparencyPass.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkLinkedListTransparencyPass);

vtkLinkedListTransparencyPass::vtkLinkedListTransparencyPass() = default;
vtkLinkedListTransparencyPass::~vtkLinkedListTransparencyPass() = default;

void vtkLinkedListTransparencyPass::Render(const vtkRenderState* s)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    s->GetPropArray()[i]->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
}
