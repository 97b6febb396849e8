#include "vtkTolerantTransparencyPass.h"

#include "scene/Settings.h"
#include "transparency/common/CoincidenceTolerance.h"

//------------------------------------------------------------------------------
vtkTolerantTransparencyPass::vtkTolerantTransparencyPass() = default;

//------------------------------------------------------------------------------
vtkTolerantTransparencyPass::~vtkTolerantTransparencyPass() = default;

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoincidenceSteps: " << this->CoincidenceSteps << "\n";
  os << indent << "CoincidenceSlope: " << this->CoincidenceSlope << "\n";
}

//------------------------------------------------------------------------------
vitrine::CoincidenceTolerance vtkTolerantTransparencyPass::GetTolerance() const
{
  return { this->CoincidenceSteps, this->CoincidenceSlope };
}

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::SetTolerance(const char* name, double& setting, double value)
{
  const bool wasOn = this->GetTolerance().IsOn();
  vitrine::SetInRange(this, name, setting, value, vitrine::NotNegative);
  if (this->GetTolerance().IsOn() != wasOn)
  {
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::SetCoincidenceSteps(double steps)
{
  this->SetTolerance("CoincidenceSteps", this->CoincidenceSteps, steps);
}

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::SetCoincidenceSlope(double slope)
{
  this->SetTolerance("CoincidenceSlope", this->CoincidenceSlope, slope);
}
