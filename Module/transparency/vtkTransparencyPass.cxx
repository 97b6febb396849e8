#include "vtkTransparencyPass.h"

vtkTransparencyPass::vtkTransparencyPass() = default;
vtkTransparencyPass::~vtkTransparencyPass() = default;

void vtkTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
