#include "vtkTolerantTransparencyPass.h"

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
void vtkTolerantTransparencyPass::SetTolerance(const vitrine::CoincidenceTolerance& tolerance)
{
  const std::string problem = tolerance.FindProblem();
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return;
  }
  const vitrine::CoincidenceTolerance before = this->GetTolerance();
  if (tolerance.IsOn() != before.IsOn())
  {
    this->ShaderStage.Modified();
  }
  if (tolerance.Steps != before.Steps || tolerance.Slope != before.Slope)
  {
    this->CoincidenceSteps = tolerance.Steps;
    this->CoincidenceSlope = tolerance.Slope;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::SetCoincidenceSteps(double steps)
{
  this->SetTolerance({ steps, this->CoincidenceSlope });
}

//------------------------------------------------------------------------------
void vtkTolerantTransparencyPass::SetCoincidenceSlope(double slope)
{
  this->SetTolerance({ this->CoincidenceSteps, slope });
}
