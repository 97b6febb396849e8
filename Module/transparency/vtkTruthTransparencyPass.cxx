#include "vtkTruthTransparencyPass.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkTruthTransparencyPass);

vtkTruthTransparencyPass::vtkTruthTransparencyPass() = default;
vtkTruthTransparencyPass::~vtkTruthTransparencyPass() = default;

void vtkTruthTransparencyPass::Render(const vtkRenderState* s)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    s->GetPropArray()[i]->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
}
